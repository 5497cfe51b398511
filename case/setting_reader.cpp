// SPDX-License-Identifier: Apache-2.0
#include "case/setting_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pulvis::case_file {
namespace {

bool is_list(KeyKind kind) {
  return kind == KeyKind::choices || kind == KeyKind::names || kind == KeyKind::quantities ||
         kind == KeyKind::numbers || kind == KeyKind::vector || kind == KeyKind::direction;
}

std::size_t due_length(const Key& key) {
  return key.kind == KeyKind::vector || key.kind == KeyKind::direction ? 3 : key.length;
}

// The unit of the first quantity in an example such as "70 GPa" or ["0 mm", "0 mm", "0 mm"].
std::string example_unit(const Key& key) {
  const std::size_t blank = key.example.find(' ');
  const std::size_t quote = key.example.find('"', key.example.find('"') + 1);
  if (blank == std::string::npos || quote == std::string::npos || quote < blank) return "";
  return key.example.substr(blank + 1, quote - blank - 1);
}

// A quotation for a message: short, and on one line.
std::string quoted(const Value& value) {
  constexpr std::size_t room = 60;
  std::string text = written(value);
  if (text.size() <= room) return text;
  std::size_t end = room;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

}  // namespace

void SettingReader::read(const Value& value, Setting& setting) const {
  setting.written = written(value);
  // A single name needs no brackets.
  if (setting.key->kind == KeyKind::names && setting.key->length == 0 && value.kind == Value::Kind::text) {
    setting.valid = element(value, setting);
    setting.item_places.push_back(value.place);
    return;
  }
  setting.valid = is_list(setting.key->kind) ? list(value, setting) : element(value, setting);
}

bool SettingReader::element(const Value& value, Setting& setting) const {
  switch (setting.key->kind) {
    case KeyKind::quantity:
    case KeyKind::quantities:
    case KeyKind::vector:
      return quantity(value, setting);
    case KeyKind::number:
    case KeyKind::numbers:
    case KeyKind::direction:
      return plain_number(value, setting);
    case KeyKind::integer:
      return whole_number(value, setting);
    case KeyKind::boolean:
      if (value.kind != Value::Kind::boolean) return wrong_kind(value, setting), false;
      setting.flag = value.boolean;
      return true;
    default:
      return word(value, setting);
  }
}

bool SettingReader::quantity(const Value& value, Setting& setting) const {
  const Key& key = *setting.key;
  if (value.kind == Value::Kind::number || value.kind == Value::Kind::integer) {
    const std::string number = written(value);
    if (!std::isfinite(value.number))
      return wrong_quantity(value, setting, number + " is no finite number", ""), false;
    return wrong_quantity(value, setting, fmt::format("{} has no unit", number), number), false;
  }
  if (value.kind != Value::Kind::text) return wrong_kind(value, setting), false;
  const QuantityReading reading = read_quantity(value.text);
  if (!reading.quantity) return wrong_quantity(value, setting, reading.message, reading.number), false;
  const Dimension& found = reading.quantity->dimension;
  if (!(found == key.dimension)) {
    const bool bare = found == dimension::none;
    const std::string why =
        bare ? quoted(value) + " has no unit" : quoted(value) + " is " + dimension_with_article(found);
    return wrong_quantity(value, setting, why, bare ? reading.number : ""), false;
  }
  if (!in_range(reading.quantity->value, value, setting)) return false;
  setting.numbers.push_back(reading.quantity->value);
  return true;
}

void SettingReader::wrong_quantity(const Value& value, const Setting& setting, const std::string& why,
                                   const std::string& number) const {
  const std::string unit = example_unit(*setting.key);
  const std::string example =
      number.empty() || unit.empty() ? setting.key->example : fmt::format("\"{} {}\"", number, unit);
  problems_.add(
      value.place,
      fmt::format("{} is not {}: {}", setting.path, dimension_with_article(setting.key->dimension), why),
      "expected e.g. " + example);
}

bool SettingReader::plain_number(const Value& value, Setting& setting) const {
  double number = value.number;
  if (value.kind == Value::Kind::text && value.text.find('%') != std::string::npos) {
    const QuantityReading reading = read_quantity(value.text);
    if (!reading.quantity || !(reading.quantity->dimension == dimension::none))
      return wrong_kind(value, setting), false;
    number = reading.quantity->value;
  } else if (value.kind != Value::Kind::number && value.kind != Value::Kind::integer) {
    return wrong_kind(value, setting), false;
  }
  if (!std::isfinite(number)) {
    problems_.add(value.place, fmt::format("{} is no finite number", setting.path),
                  "expected e.g. " + setting.key->example);
    return false;
  }
  if (!in_range(number, value, setting)) return false;
  setting.numbers.push_back(number);
  return true;
}

bool SettingReader::whole_number(const Value& value, Setting& setting) const {
  // 1e6 is a number of the other kind in TOML, but a whole one; beyond 2^53 it may not be what was meant.
  constexpr double exact = 9007199254740992.0;  // 2^53
  std::int64_t integer = value.integer;
  if (value.kind == Value::Kind::number && std::abs(value.number) <= exact &&
      value.number == std::floor(value.number))
    integer = static_cast<std::int64_t>(value.number);
  else if (value.kind != Value::Kind::integer)
    return wrong_kind(value, setting), false;
  if (!in_range(static_cast<double>(integer), value, setting)) return false;
  setting.integer = integer;
  setting.numbers.push_back(static_cast<double>(integer));
  return true;
}

bool SettingReader::in_range(double number, const Value& value, const Setting& setting) const {
  if (setting.key->range.contains(number)) return true;
  problems_.add(value.place, fmt::format("{} is out of range: {}", setting.path, quoted(value)),
                "expected " + describe_range(*setting.key));
  return false;
}

bool SettingReader::word(const Value& value, Setting& setting) const {
  // In an override, a bare 316 may well be a name.
  const bool bare =
      value.place.source > 0 && (value.kind == Value::Kind::integer || value.kind == Value::Kind::number ||
                                 value.kind == Value::Kind::date || value.kind == Value::Kind::boolean);
  if (value.kind != Value::Kind::text && !bare) return wrong_kind(value, setting), false;
  const std::string text = bare ? written(value) : value.text;
  if (!known(value, text, setting)) return false;
  setting.texts.push_back(text);
  return true;
}

bool SettingReader::known(const Value& value, const std::string& text, const Setting& setting) const {
  const Key& key = *setting.key;
  if (key.kind == KeyKind::choice || key.kind == KeyKind::choices) {
    if (std::find(key.choices.begin(), key.choices.end(), text) != key.choices.end()) return true;
    const auto guess = nearest(text, key.choices);
    problems_.add(
        value.place, fmt::format("{} cannot be {}", setting.path, quoted(value)),
        (guess ? fmt::format("did you mean \"{}\"? ", *guess) : "") + "expected " + enumerate(key.choices));
    return false;
  }
  if (key.kind != KeyKind::name && key.kind != KeyKind::names) return true;
  const auto table = names_.of_table.find(key.refers_to);
  if (table != names_.of_table.end() && table->second.contains(text)) return true;
  if (problems_.full()) return false;
  std::vector<std::string> names;
  if (table != names_.of_table.end()) names.assign(table->second.begin(), table->second.end());
  const auto guess = nearest(text, names);
  constexpr std::size_t listed = 8;  // as many as fit a line
  std::string expected = guess                   ? fmt::format("did you mean \"{}\"?", *guess)
                         : names.empty()         ? fmt::format("expected a table [{}.NAME]", key.refers_to)
                         : names.size() > listed ? fmt::format("expected a name out of [{}]", key.refers_to)
                                                 : "expected " + enumerate(names);
  problems_.add(value.place,
                fmt::format("{}: there is no {} in [{}]", setting.path, quoted(value), key.refers_to),
                std::move(expected));
  return false;
}

bool SettingReader::list(const Value& value, Setting& setting) const {
  const Key& key = *setting.key;
  if (value.kind != Value::Kind::list) return wrong_kind(value, setting), false;
  const std::size_t due = due_length(key);
  if (due != 0 && value.items.size() != due) {
    problems_.add(value.place, fmt::format("{} has {} elements", setting.path, value.items.size()),
                  fmt::format("expected {}, e.g. {}", due, key.example));
    return false;
  }
  if (value.items.empty() && (key.kind == KeyKind::quantities || key.kind == KeyKind::numbers)) {
    problems_.add(value.place, setting.path + " is empty", "expected e.g. " + key.example);
    return false;
  }
  bool valid = true;
  std::set<std::string> seen;
  const bool distinct = key.kind == KeyKind::choices || (key.kind == KeyKind::names && key.length == 0);
  for (const Value& item : value.items) {
    valid = element(item, setting) && valid;
    setting.item_places.push_back(item.place);
    if (!distinct || item.kind != Value::Kind::text || seen.insert(item.text).second) continue;
    problems_.add(item.place, fmt::format("{} names {} twice", setting.path, quoted(item)), "once is enough");
    valid = false;
  }
  const auto zero = [](double number) { return number == 0.0; };
  if (valid && key.kind == KeyKind::direction &&
      std::all_of(setting.numbers.begin(), setting.numbers.end(), zero)) {
    problems_.add(value.place, setting.path + " has no direction", "expected e.g. " + key.example);
    valid = false;
  }
  return valid;
}

void SettingReader::wrong_kind(const Value& value, const Setting& setting) const {
  const bool inside = is_list(setting.key->kind) && value.kind != Value::Kind::list;
  problems_.add(
      value.place,
      fmt::format(
          "{} is {}{}", setting.path, kind_with_article(value.kind),
          value.kind == Value::Kind::list || value.kind == Value::Kind::table ? "" : ": " + quoted(value)),
      fmt::format("expected {}, e.g. {}", inside ? "a list" : describe_kind(*setting.key),
                  setting.key->example));
}

}  // namespace pulvis::case_file
