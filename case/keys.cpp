// SPDX-License-Identifier: Apache-2.0
#include "case/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

namespace pulvis::case_file {

bool Range::contains(double value) const {
  const bool above = low_end == End::open || value > low || (low_end == End::included && value == low);
  const bool below = high_end == End::open || value < high || (high_end == End::included && value == high);
  return above && below;
}

std::string parent_pattern(std::string_view pattern) {
  const std::size_t dot = pattern.rfind('.');
  return std::string(dot == std::string_view::npos ? std::string_view{} : pattern.substr(0, dot));
}

std::string leaf_of(std::string_view pattern) {
  const std::size_t dot = pattern.rfind('.');
  return std::string(dot == std::string_view::npos ? pattern : pattern.substr(dot + 1));
}

std::string element_pattern(const Key& key) {
  if (key.kind == KeyKind::named_tables) return key.pattern + ".*";
  if (key.kind == KeyKind::listed_tables) return key.pattern + "[]";
  return key.pattern;
}

const std::vector<const Key*>& keys_in(std::string_view table_pattern) {
  using Children = std::map<std::string, std::vector<const Key*>, std::less<>>;
  static const Children children = [] {
    Children result;
    for (const Key& key : all_keys()) result[parent_pattern(key.pattern)].push_back(&key);
    return result;
  }();
  static const std::vector<const Key*> none;
  const auto found = children.find(table_pattern);
  return found != children.end() ? found->second : none;
}

const Key* find_key(std::string_view table_pattern, std::string_view leaf) {
  for (const Key* key : keys_in(table_pattern))
    if (leaf_of(key->pattern) == leaf) return key;
  return nullptr;
}

bool is_table(KeyKind kind) {
  return kind == KeyKind::table || kind == KeyKind::named_tables || kind == KeyKind::listed_tables;
}

std::string enumerate(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
    text += fmt::format("\"{}\"", words[i]);
  }
  return text;
}

std::string describe_kind(const Key& key) {
  const std::string count = key.length > 0 ? fmt::format("{} ", key.length) : "";
  switch (key.kind) {
    case KeyKind::table:
      return "a table";
    case KeyKind::named_tables:
      return fmt::format("tables [{}.NAME]", key.pattern);
    case KeyKind::listed_tables:
      return fmt::format("tables [[{}]]", key.pattern);
    case KeyKind::quantity:
      return dimension_with_article(key.dimension) + " with its unit";
    case KeyKind::number:
      return "a number";
    case KeyKind::integer:
      return "a whole number";
    case KeyKind::text:
      return "text";
    case KeyKind::boolean:
      return "true or false";
    case KeyKind::choice:
      return enumerate(key.choices);
    case KeyKind::choices:
      return "a list of any of " + enumerate(key.choices, "and");
    case KeyKind::name:
      return fmt::format("a name out of [{}]", key.refers_to);
    case KeyKind::names:
      return fmt::format("a list of {}names out of [{}]{}", count, key.refers_to,
                         key.length == 0 ? ", or one name" : "");
    case KeyKind::quantities:
      return fmt::format("a list; each {} with its unit", dimension_with_article(key.dimension));
    case KeyKind::numbers:
      return "a list of numbers";
    case KeyKind::vector:
      return fmt::format("a list of three (x, y, z); each {} with its unit",
                         dimension_with_article(key.dimension));
    case KeyKind::direction:
      return "a list of three numbers (x, y, z), not all zero; only the direction counts";
  }
  return "";
}

std::string describe_range(const Key& key) {
  const auto bound = [&](double value) { return format_quantity(value, key.dimension, 15); };
  const Range& range = key.range;
  std::string text;
  if (range.low_end == Range::End::included) text = "at least " + bound(range.low);
  if (range.low_end == Range::End::excluded) text = "greater than " + bound(range.low);
  if (!text.empty() && range.high_end != Range::End::open) text += " and ";
  if (range.high_end == Range::End::included) text += "at most " + bound(range.high);
  if (range.high_end == Range::End::excluded) text += "less than " + bound(range.high);
  return text;
}

std::string describe_condition(const Condition& condition) {
  if (condition.key.empty()) return "";
  return fmt::format("{} is {}", condition.key, enumerate(condition.values));
}

namespace {

// Edits (one character more, less or other, or two neighbours swapped) between two words.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> older, old(b.size() + 1), current(b.size() + 1);
  std::iota(old.begin(), old.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = old[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replaced, old[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], older[j - 2] + 1);
    }
    older = old;
    old = current;
  }
  return old[b.size()];
}

std::string lower(std::string text) {
  for (char& c : text)
    c = c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 200;  // a longer word is no typing error
  if (word.size() > longest) return std::nullopt;
  std::optional<std::string> best;
  std::size_t best_distance = word.size() <= 3 ? 2 : 3;  // one more than is allowed
  for (const std::string& candidate : candidates) {
    const std::size_t difference =
        candidate.size() > word.size() ? candidate.size() - word.size() : word.size() - candidate.size();
    if (difference >= best_distance) continue;
    const std::size_t distance = edit_distance(lower(word), lower(candidate));
    if (distance >= word.size()) continue;  // nothing of the word is left
    if (distance < best_distance) best = candidate, best_distance = distance;
  }
  return best;
}

}  // namespace pulvis::case_file
