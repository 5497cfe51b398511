// SPDX-License-Identifier: Apache-2.0
#include "case/units.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace pulvis {
namespace {

// Factor of a unit: numerator / denominator * 10^decimal. Apart, so that no decimal prefix is rounded.
struct Unit {
  double numerator = 1.0, denominator = 1.0;
  int decimal = 0;
  Dimension dimension;
};

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool takes_prefix;
};

constexpr double turn_in_radians = 6.283185307179586476925;  // 2 pi

constexpr std::array named_units{
    NamedUnit{"m", {1, 1, 0, dimension::length}, true},
    NamedUnit{"g", {1, 1, -3, dimension::mass}, true},
    NamedUnit{"t", {1, 1, 3, dimension::mass}, false},
    NamedUnit{"s", {1, 1, 0, dimension::time}, true},
    NamedUnit{"min", {60, 1, 0, dimension::time}, false},
    NamedUnit{"h", {3600, 1, 0, dimension::time}, false},
    NamedUnit{"Hz", {1, 1, 0, dimension::frequency}, true},
    NamedUnit{"rpm", {1, 60, 0, dimension::frequency}, false},
    NamedUnit{"N", {1, 1, 0, dimension::force}, true},
    NamedUnit{"Pa", {1, 1, 0, dimension::pressure}, true},
    NamedUnit{"bar", {1, 1, 5, dimension::pressure}, true},
    NamedUnit{"J", {1, 1, 0, dimension::energy}, true},
    NamedUnit{"W", {1, 1, 0, Dimension{1, 2, -3}}, true},
    NamedUnit{"l", {1, 1, -3, dimension::volume}, true},
    NamedUnit{"L", {1, 1, -3, dimension::volume}, true},
    NamedUnit{"g_n", {9.80665, 1, 0, dimension::acceleration}, false},  // standard gravity, CGPM 1901
    NamedUnit{"deg", {1, 360, 0, dimension::angle}, false},
    NamedUnit{"rad", {1, turn_in_radians, 0, dimension::angle}, false},
    NamedUnit{"cycle", {1, 1, 0, dimension::angle}, false},
    NamedUnit{"cycles", {1, 1, 0, dimension::angle}, false},
    NamedUnit{"turn", {1, 1, 0, dimension::angle}, false},
    NamedUnit{"turns", {1, 1, 0, dimension::angle}, false},
    NamedUnit{"%", {1, 1, -2, dimension::none}, false},
};

constexpr std::array<std::pair<char, int>, 11> prefixes{{{'f', -15},
                                                         {'p', -12},
                                                         {'n', -9},
                                                         {'u', -6},
                                                         {'m', -3},
                                                         {'c', -2},
                                                         {'d', -1},
                                                         {'k', 3},
                                                         {'M', 6},
                                                         {'G', 9},
                                                         {'T', 12}}};

// A symbol that is a unit by itself wins over prefix + unit: "min" is a minute.
std::optional<Unit> find_unit(std::string_view symbol) {
  for (const NamedUnit& named : named_units)
    if (named.symbol == symbol) return named.unit;
  for (const auto& [letter, power] : prefixes) {
    if (symbol.size() < 2 || symbol.front() != letter) continue;
    for (const NamedUnit& named : named_units) {
      if (!named.takes_prefix || named.symbol != symbol.substr(1)) continue;
      Unit unit = named.unit;
      unit.decimal += power;
      return unit;
    }
  }
  return std::nullopt;
}

Unit product(const Unit& a, const Unit& b) {
  return {a.numerator * b.numerator, a.denominator * b.denominator, a.decimal + b.decimal,
          a.dimension * b.dimension};
}

Unit power(const Unit& a, int n) {
  Unit result{1, 1, a.decimal * n, to_power(a.dimension, n)};
  for (int i = 0; i < std::abs(n); ++i) {
    result.numerator *= n > 0 ? a.numerator : a.denominator;
    result.denominator *= n > 0 ? a.denominator : a.numerator;
  }
  return result;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%'; }
bool is_space(char c) { return c == ' ' || c == '\t'; }

// The typographic spellings are rewritten first; what follows handles ASCII only.
std::string in_ascii(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> spellings{
      {{"\xC2\xB5", "u"},    // micro sign
       {"\xCE\xBC", "u"},    // Greek mu
       {"\xC2\xB7", "*"},    // middle dot
       {"\xC2\xB2", "^2"},   // superscript two
       {"\xC2\xB3", "^3"},   // superscript three
       {"\xC2\xB0", "deg"},  // degree sign
       {"\xC2\xA0", " "}}};  // space that does not break
  std::string result;
  while (!text.empty()) {
    std::size_t taken = 1;
    std::string_view written = text.substr(0, 1);
    for (const auto& [from, to] : spellings)
      if (text.starts_with(from)) taken = from.size(), written = to;
    result += written;
    text.remove_prefix(taken);
  }
  return result;
}

// Recursive descent over: factor { (* | . | blank | /) factor }, factor: ( ... ) | 1 | symbol, [power].
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : text_(text) {}

  std::optional<Unit> parse() {
    Unit unit = expression(0);
    if (message_.empty() && at_ < text_.size()) fail(fmt::format("unexpected \"{}\"", text_.substr(at_, 1)));
    return message_.empty() ? std::optional(unit) : std::nullopt;
  }
  const std::string& message() const { return message_; }

 private:
  static constexpr int deepest = 8;  // no unit of this world needs more parentheses

  void fail(std::string message) {
    if (message_.empty()) message_ = std::move(message);
  }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool skip_blanks() {
    const std::size_t before = at_;
    while (is_space(next())) ++at_;
    return at_ > before;
  }

  Unit expression(int depth) {
    if (depth > deepest) return fail("too many parentheses"), Unit{};
    skip_blanks();
    Unit result = factor(depth);
    bool divided = false;
    while (message_.empty()) {
      const bool blank = skip_blanks();
      const char c = next();
      if (c == '\0' || c == ')') break;
      const bool slash = c == '/';
      if (slash || c == '*' || c == '.') {
        ++at_;
        skip_blanks();
      } else if (!blank) {
        break;
      }
      if (divided && !slash)
        return fail("a product after \"/\" can be read in two ways; use parentheses"), result;
      divided = divided || slash;
      result = product(result, power(factor(depth), slash ? -1 : 1));
    }
    return result;
  }

  Unit factor(int depth) {
    if (next() == '(') {
      ++at_;
      const Unit inner = expression(depth + 1);
      if (next() != ')') return fail("a parenthesis is not closed"), inner;
      ++at_;
      return raised(inner);
    }
    if (next() == '1' && (at_ + 1 >= text_.size() || !is_digit(text_[at_ + 1]))) return ++at_, Unit{};
    const std::size_t begin = at_;
    while (is_letter(next())) ++at_;
    const std::string_view symbol = text_.substr(begin, at_ - begin);
    if (symbol.empty()) {
      fail(next() == '\0' ? std::string("a unit is missing at the end")
                          : fmt::format("unexpected \"{}\"", text_.substr(at_, 1)));
      return {};
    }
    const std::optional<Unit> unit = find_unit(symbol);
    if (!unit) return fail(fmt::format("unknown unit \"{}\"", symbol)), Unit{};
    return raised(*unit);
  }

  // "^-2", "^2", "2" and "-2" after a symbol.
  Unit raised(const Unit& unit) {
    const bool caret = next() == '^';
    if (caret) ++at_;
    const bool sign = next() == '-' || next() == '+';
    const bool negative = next() == '-';
    if (!caret && !is_digit(next()) && !(sign && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])))
      return unit;
    if (sign) ++at_;
    const char digit = next();
    if (digit < '1' || digit > '9') return fail("a power is a whole number from -9 to 9, not 0"), unit;
    ++at_;
    if (is_digit(next())) return fail("a power is a whole number from -9 to 9, not 0"), unit;
    return power(unit, negative ? -(digit - '0') : digit - '0');
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string message_;
};

// A decimal number at the start of a text: digits with an optional point, and its exponent apart.
struct Decimal {
  std::string digits;
  int exponent = 0;
  std::size_t length = 0;  // 0: there is none
};

Decimal read_decimal(std::string_view text) {
  Decimal result;
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t before = at;
    while (at < text.size() && is_digit(text[at])) result.digits += text[at++];
    return at > before;
  };
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) {
    if (text[at] == '-') result.digits += '-';
    ++at;
  }
  bool any = digits();
  // A point belongs to the number only if a digit stands beside it.
  if (at < text.size() && text[at] == '.' && (any || (at + 1 < text.size() && is_digit(text[at + 1])))) {
    result.digits += text[at++];
    any = digits() || any;
  }
  if (!any) return {};
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    std::size_t from = at + 1;
    if (from < text.size() && text[from] == '+') ++from;
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + text.size(), result.exponent);
    // Five digits of exponent are beyond any double; capping keeps the sum below from overflowing.
    if (error == std::errc::result_out_of_range || std::abs(result.exponent) > 99999)
      result.exponent = text[from] == '-' ? -99999 : 99999;
    if (error != std::errc::invalid_argument) at = static_cast<std::size_t>(end - text.data());
  }
  result.length = at;
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<double> scaled(const Decimal& decimal, const Unit& unit) {
  const std::string text = fmt::format("{}e{}", decimal.digits, decimal.exponent + unit.decimal);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  value = value * unit.numerator / unit.denominator;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

QuantityReading read_quantity(std::string_view written) {
  constexpr std::size_t longest = 100;  // bounds the exponents of a product, and the messages
  QuantityReading reading;
  if (written.size() > longest)
    return reading.message = "the text is too long for a number with a unit", reading;
  const std::string ascii = in_ascii(trimmed(written));
  const Decimal decimal = read_decimal(ascii);
  if (decimal.length == 0)
    return reading.message = fmt::format("\"{}\" does not start with a number", written), reading;
  reading.number = ascii.substr(0, decimal.length);
  const std::string_view rest = trimmed(std::string_view(ascii).substr(decimal.length));
  if (rest.starts_with(',')) return reading.message = "a decimal point is due, not a comma", reading;

  Unit unit;
  if (!rest.empty()) {
    UnitParser parser(rest);
    const std::optional<Unit> parsed = parser.parse();
    if (!parsed) return reading.message = parser.message(), reading;
    unit = *parsed;
  }
  const std::optional<double> value = scaled(decimal, unit);
  if (!value) return reading.message = fmt::format("{} is beyond the range of numbers", written), reading;
  reading.quantity = Quantity{*value, unit.dimension};
  return reading;
}

namespace {

// The units a report uses, ascending; the first entry's symbol names the dimension.
struct Display {
  Dimension dimension;
  std::string_view name;
  std::vector<std::pair<double, std::string_view>> units;
};

const std::vector<Display>& displays() {
  static const std::vector<Display> table{
      {dimension::none, "number", {{1, ""}}},
      {dimension::mass,
       "mass",
       {{1e-15, "pg"}, {1e-12, "ng"}, {1e-9, "ug"}, {1e-6, "mg"}, {1e-3, "g"}, {1, "kg"}, {1e3, "t"}}},
      {dimension::length,
       "length",
       {{1e-12, "pm"}, {1e-9, "nm"}, {1e-6, "um"}, {1e-3, "mm"}, {1, "m"}, {1e3, "km"}}},
      {dimension::area, "area", {{1e-12, "um^2"}, {1e-6, "mm^2"}, {1, "m^2"}}},
      {dimension::volume, "volume", {{1e-18, "um^3"}, {1e-9, "mm^3"}, {1e-6, "cm^3"}, {1, "m^3"}}},
      {dimension::time, "time", {{1e-12, "ps"}, {1e-9, "ns"}, {1e-6, "us"}, {1e-3, "ms"}, {1, "s"}}},
      {dimension::frequency, "frequency", {{1e-3, "mHz"}, {1, "Hz"}, {1e3, "kHz"}, {1e6, "MHz"}}},
      {dimension::speed, "speed", {{1e-6, "um/s"}, {1e-3, "mm/s"}, {1, "m/s"}}},
      {dimension::acceleration, "acceleration", {{1e-3, "mm/s^2"}, {1, "m/s^2"}}},
      {dimension::density, "density", {{1, "kg/m^3"}, {1e3, "g/cm^3"}}},
      {dimension::force,
       "force",
       {{1e-12, "pN"}, {1e-9, "nN"}, {1e-6, "uN"}, {1e-3, "mN"}, {1, "N"}, {1e3, "kN"}}},
      {dimension::pressure, "pressure", {{1, "Pa"}, {1e3, "kPa"}, {1e6, "MPa"}, {1e9, "GPa"}}},
      {dimension::energy,
       "energy",
       {{1e-15, "fJ"}, {1e-12, "pJ"}, {1e-9, "nJ"}, {1e-6, "uJ"}, {1e-3, "mJ"}, {1, "J"}}},
      {dimension::surface_energy, "surface energy", {{1e-6, "uJ/m^2"}, {1e-3, "mJ/m^2"}, {1, "J/m^2"}}},
      {dimension::mass_rate,
       "mass rate",
       {{1e-12, "ng/s"}, {1e-9, "ug/s"}, {1e-6, "mg/s"}, {1e-3, "g/s"}, {1, "kg/s"}}},
      {dimension::angle, "angle", {{1.0 / 360.0, "deg"}}},
  };
  return table;
}

const Display* find_display(const Dimension& dimension) {
  for (const Display& display : displays())
    if (display.dimension == dimension) return &display;
  return nullptr;
}

std::string base_units(const Dimension& dimension) {
  std::string text;
  const auto append = [&](std::string_view symbol, int exponent) {
    if (exponent == 0) return;
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", symbol,
                        exponent == 1 ? "" : fmt::format("^{}", exponent));
  };
  append("kg", dimension.kilogram);
  append("m", dimension.metre);
  append("s", dimension.second);
  append("cycle", dimension.turn);
  return text;
}

}  // namespace

std::string format_quantity(double value, const Dimension& dimension, int digits) {
  const Display* display = find_display(dimension);
  if (display == nullptr) return fmt::format("{:.{}g} {}", value, digits, base_units(dimension));
  // The largest unit of which there is at least one; zero stands in the SI unit itself.
  double factor = display->units.front().first;
  std::string_view symbol = display->units.front().second;
  for (const auto& [candidate, name] : display->units)
    if (std::abs(value) >= candidate * (1 - 1e-12) || (value == 0.0 && candidate <= 1.0))
      factor = candidate, symbol = name;
  return fmt::format("{:.{}g}{}{}", value / factor, digits, symbol.empty() ? "" : " ", symbol);
}

std::string dimension_name(const Dimension& dimension) {
  const Display* display = find_display(dimension);
  return display != nullptr ? std::string(display->name) : "quantity in " + base_units(dimension);
}

std::string dimension_with_article(const Dimension& dimension) {
  const std::string name = dimension_name(dimension);
  const bool vowel = name.find_first_of("aeiou") == 0;
  return (vowel ? "an " : "a ") + name;
}

}  // namespace pulvis
