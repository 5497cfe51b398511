// SPDX-License-Identifier: Apache-2.0
#include "tests/reliability/edits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "validation/draw.hpp"

namespace pulvis::tests {
namespace {

using Lines = std::vector<std::string>;

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last + 1 - first);
}

bool is_header(const std::string& line) { return trimmed(line).starts_with('['); }
bool says_nothing(const std::string& line) { return trimmed(line).empty() || trimmed(line).starts_with('#'); }

/// What a line is about: the key, or the last part of the name of a table.
std::string subject_of(const std::string& line) {
  const std::string text = trimmed(line);
  if (is_header(line)) {
    const std::size_t end = text.find(']');
    const std::string name = text.substr(0, end);
    return name.substr(name.find_last_of("[.") + 1);
  }
  return trimmed(text.substr(0, text.find('=')));
}

/// Where messages may point when `gone` stood before line `at` (from 0) of `lines` and is there no more.
std::set<int> places_without(const Lines& lines, std::size_t at, const std::string& gone) {
  std::set<int> places;
  if (says_nothing(gone)) return places;
  const auto number = [](std::size_t line) { return static_cast<int>(line) + 1; };
  std::size_t first = std::min(at, lines.size()), end = first;  // of the table that now is there
  while (first > 0 && !is_header(lines[first - 1])) --first;
  if (first > 0) --first;
  while (end < lines.size() && !is_header(lines[end])) ++end;
  for (std::size_t k = first; k < end; ++k) places.insert(number(k));
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].find(subject_of(gone)) != std::string::npos) places.insert(number(k));
  if (is_header(gone) || subject_of(gone) == "extends" || first == 0) places.insert(1);
  return places;
}

/// Draws what an edit needs.
class Pen {
 public:
  Pen(const std::string& text, std::uint64_t number)
      : draw_(number, 1882), text_(text), lines_(lines_in(text)) {}

  Edit edit() {
    switch (below(13)) {
      case 0:
        return character("deleted", [&](std::size_t at) { text_.erase(at, 1); });
      case 1:
        return character("inserted", [&](std::size_t at) { text_.insert(at, 1, letter()); });
      case 2:
        return character("replaced", [&](std::size_t at) { text_[at] = letter(); });
      case 3:
        return character("swapped with the next", [&](std::size_t at) {
          if (at + 1 < text_.size()) std::swap(text_[at], text_[at + 1]);
        });
      case 4:
        return line_deleted();
      case 5:
        return line_doubled();
      case 6:
        return value_from_elsewhere();
      case 7:
        return unit_changed();
      case 8:
        return number_changed();
      case 9:
        return key_misspelt();
      case 10:
        return one_removed("\"", "quote removed");
      case 11:
        return one_removed("[]{}", "bracket removed");
      default:
        return one_removed("=,.#", "sign removed");
    }
  }

 private:
  std::size_t below(std::size_t end) {
    return std::min(end - 1, static_cast<std::size_t>(draw_.between(0.0, static_cast<double>(end))));
  }
  char letter() {
    static const std::string letters = "[]{}\"'=.,#\\\n\t 0123456789eaxz_-+:%^/";
    return letters[below(letters.size())];
  }

  template <class Change>
  Edit character(const std::string& how, Change&& change) {
    const std::size_t at = below(text_.size());
    const auto line = static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + at, '\n'));
    change(at);
    return done(line, "character " + how);
  }

  /// Takes the place of an edit within one line, or across the end of it, from the lines before and after.
  Edit done(std::size_t line, const std::string& what) {
    Edit edit{text_, fmt::format("line {}: {}", line + 1, what), {static_cast<int>(line) + 1}};
    const Lines now = lines_in(text_);
    // An end of a line that is gone, new or elsewhere is in the line after, too.
    const bool across =
        now.size() != lines_.size() || (line + 1 < now.size() && now[line + 1] != lines_[line + 1]);
    if (across) edit.places.insert(static_cast<int>(line) + 2);
    for (std::size_t k = line; k < std::min(line + (across ? 2 : 1), lines_.size()); ++k)
      // What has become a comment, or another key or header, is gone from where it was.
      if (k >= now.size() || says_nothing(now[k]) || subject_of(now[k]) != subject_of(lines_[k]))
        edit.places.merge(places_without(now, std::min(k + 1, now.size()), lines_[k]));
    return edit;
  }
  Edit with_line(std::size_t line, const std::string& content, const std::string& what) {
    Lines changed = lines_;
    changed[line] = content;
    text_ = joined(changed);
    return done(line, what);
  }

  Edit line_deleted() {
    const std::size_t line = below(lines_.size());
    Lines left = lines_;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(line));
    return {joined(left), fmt::format("line {}: line deleted: {}", line + 1, lines_[line]),
            places_without(left, line, lines_[line])};
  }
  Edit line_doubled() {
    const std::size_t line = below(lines_.size());
    Lines more = lines_;
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(line), lines_[line]);
    return {joined(more),
            fmt::format("line {}: line doubled", line + 1),
            {static_cast<int>(line) + 1, static_cast<int>(line) + 2}};
  }

  /// A line drawn among those with something, or none.
  template <class Has>
  std::size_t line_with(Has&& has) {
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < lines_.size(); ++k)
      if (!says_nothing(lines_[k]) && has(lines_[k])) some.push_back(k);
    return some.empty() ? lines_.size() : some[below(some.size())];
  }
  static bool has_value(const std::string& line) {
    return !is_header(line) && line.find('=') != std::string::npos;
  }

  Edit value_from_elsewhere() {
    const std::size_t line = line_with(has_value), other = line_with(has_value);
    if (line == lines_.size()) return line_deleted();
    const std::size_t here = lines_[line].find('='), there = lines_[other].find('=');
    return with_line(line, lines_[line].substr(0, here) + lines_[other].substr(there),
                     "the value of " + subject_of(lines_[other]) + " taken for it");
  }

  Edit unit_changed() {
    static const std::vector<std::string> units = {
        "mm",     "um",     "m",     "km",     "s",   "ms",   "h",   "kg",  "g",   "mg",
        "g/cm^3", "kg/m^3", "Pa",    "MPa",    "GPa", "Hz",   "kHz", "deg", "rad", "m/s",
        "mm/s",   "m/s^2",  "J/m^2", "mJ/m^2", "g/s", "kg/s", "",    "%",   "mn"};
    const auto unit_at = [](const std::string& line) -> std::pair<std::size_t, std::size_t> {
      const std::size_t open = line.find('"'), blank = line.find(' ', open), close = line.find('"', open + 1);
      if (open == std::string::npos || close == std::string::npos || blank > close) return {0, 0};
      return {blank + 1, close};
    };
    const std::size_t line =
        line_with([&](const std::string& l) { return has_value(l) && unit_at(l).second > 0; });
    if (line == lines_.size()) return line_deleted();
    const auto [first, end] = unit_at(lines_[line]);
    return with_line(line,
                     lines_[line].substr(0, first) + units[below(units.size())] + lines_[line].substr(end),
                     "unit changed");
  }

  Edit number_changed() {
    const auto digit_after_sign = [](const std::string& l) {
      return l.find_first_of("0123456789", std::min(l.find('='), l.size()));
    };
    const std::size_t line = line_with(
        [&](const std::string& l) { return has_value(l) && digit_after_sign(l) != std::string::npos; });
    if (line == lines_.size()) return line_deleted();
    std::string changed = lines_[line];
    std::size_t at = digit_after_sign(changed);
    for (std::size_t k = at; k < changed.size() && changed[k] != '#'; ++k)
      if (std::isdigit(static_cast<unsigned char>(changed[k])) && draw_.chance(0.5)) at = k;
    static const std::vector<std::string> instead = {"-1",   "0",     "9",  "00", "1e9",
                                                     "1e-9", "1e400", ".5", "77", "nan"};
    changed.replace(at, 1, instead[below(instead.size())]);
    return with_line(line, changed, "number changed");
  }

  Edit key_misspelt() {
    const std::size_t line = line_with([](const std::string& l) { return has_value(l) || is_header(l); });
    if (line == lines_.size()) return line_deleted();
    std::string changed = lines_[line];
    const std::size_t first = changed.find_first_not_of(" []"), end = changed.find_first_of("=]", first);
    const std::size_t at = first + below(std::max<std::size_t>(end - first, 2) - 1);
    if (draw_.chance(0.5))
      changed.erase(at, 1);
    else
      std::swap(changed[at], changed[at + 1]);
    return with_line(line, changed, "key misspelt");
  }

  Edit one_removed(const std::string& signs, const std::string& what) {
    const auto has = [&](const std::string& l) { return l.find_first_of(signs) != std::string::npos; };
    const std::size_t line = line_with(has);
    if (line == lines_.size()) return line_deleted();
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < lines_[line].size(); ++k)
      if (signs.find(lines_[line][k]) != std::string::npos) places.push_back(k);
    std::string changed = lines_[line];
    changed.erase(places[below(places.size())], 1);
    return with_line(line, changed, what);
  }

  validation::Draw draw_;
  std::string text_;
  Lines lines_;
};

}  // namespace

std::vector<std::string> lines_in(const std::string& text) {
  Lines lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

Edit edit_of(const std::string& text, std::uint64_t number) { return Pen(text, number).edit(); }

}  // namespace pulvis::tests
