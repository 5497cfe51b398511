// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "case/key_text.hpp"
#include "case/keys.hpp"
#include "case/reader.hpp"

namespace pulvis {
namespace {

using namespace case_file;

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = std::min(path.find('.'), path.size());
    parts.emplace_back(path.substr(0, end));
    if (end == path.size()) return parts;
    path.remove_prefix(end + 1);
  }
}

// "phases[2]", "phases[]" and "phases" are the same table; so is "phases.fill", a name.
std::string without_index(const std::string& part) { return part.substr(0, part.find('[')); }

// Whether a path means a key: "*" stands for any name and may be left out, an index too.
bool matches(const std::vector<std::string>& pattern, std::size_t p, const std::vector<std::string>& path,
             std::size_t k) {
  if (p == pattern.size()) return k == path.size();
  if (pattern[p] == "*")
    return matches(pattern, p + 1, path, k) || (k < path.size() && matches(pattern, p + 1, path, k + 1));
  if (k == path.size() || without_index(pattern[p]) != without_index(path[k])) return false;
  if (matches(pattern, p + 1, path, k + 1)) return true;
  const bool listed = pattern[p].ends_with("[]");
  return listed && k + 1 < path.size() && matches(pattern, p + 1, path, k + 2);
}

std::vector<std::string> leaves_in(const Key& table) {
  std::vector<std::string> leaves;
  if (is_table(table.kind))
    for (const Key* key : keys_in(element_pattern(table))) leaves.push_back(leaf_of(key->pattern));
  return leaves;
}

std::vector<const Key*> find_keys(const std::string& path) {
  constexpr std::size_t deepest = 16;  // no key has as many parts
  const std::vector<std::string> parts = parts_of(path);
  std::vector<const Key*> result;
  if (parts.size() > deepest) return result;
  for (const Key& key : all_keys()) {
    // The elements of a named table: "materials.*" and "materials.steel" are their table.
    const std::vector<std::string> pattern =
        parts_of(is_table(key.kind) ? element_pattern(key) : key.pattern);
    if (matches(pattern, 0, parts, 0)) result.push_back(&key);
  }
  // The most literal match wins: in "materials.density" the last part is the key and not the name of a
  // material, and neither is a mistyped "materials.desity".
  std::vector<const Key*> literal;
  bool mistyped = false;
  for (const Key* key : result) {
    if (leaf_of(key->pattern) == without_index(parts.back()) || key->pattern == path) literal.push_back(key);
    mistyped = mistyped || (parts.size() > 1 && nearest(parts.back(), leaves_in(*key)));
  }
  if (!literal.empty() || mistyped) return literal;
  if (!result.empty() || parts.size() > 1) return result;
  for (const Key& key : all_keys())
    if (leaf_of(key.pattern) == path) result.push_back(&key);
  return result;
}

[[noreturn]] void unknown_key(const std::string& path) {
  std::vector<std::string> known;
  for (const Key& key : all_keys()) {
    known.push_back(key.pattern);
    // The same without the marks for names and elements, as a hurried user writes it.
    std::string plain;
    for (const std::string& part : parts_of(key.pattern))
      if (part != "*") plain += (plain.empty() ? "" : ".") + without_index(part);
    known.push_back(plain);
    known.push_back(leaf_of(key.pattern));
  }
  const auto guess = nearest(path, known);
  const auto by_leaf = guess ? guess : nearest(leaf_of(path), known);
  throw Failure(Exit::usage,
                fmt::format("there is no key \"{}\"{}", path.substr(0, 200),
                            by_leaf ? fmt::format("; did you mean \"{}\"?", *by_leaf)
                                    : "; the tables are " + enumerate(top_level_tables(), "and")));
}

std::string entry(const Key& key) {
  std::string text = fmt::format("{}\n  {}\n", key.pattern, key.help);
  const auto line = [&](std::string_view label, const std::string& content) {
    if (!content.empty()) text += fmt::format("  {:<9} {}\n", label, content);
  };
  line("value:", describe_kind(key));
  line("default:", describe_default(key));
  line("range:", describe_range(key));
  line("counts:", key.only_when.key.empty() ? "" : "where " + describe_condition(key.only_when));
  line("example:", key.example.empty() ? "" : fmt::format("{} = {}", leaf_of(key.pattern), key.example));
  if (is_table(key.kind)) {
    text += "  keys:\n";
    for (const Key* child : keys_in(element_pattern(key)))
      text += fmt::format("    {:<22} {}\n", leaf_of(child->pattern), child->help);
  }
  return text;
}

}  // namespace

std::string explain(const std::string& key) {
  const std::vector<const Key*> found = find_keys(key);
  if (found.empty()) unknown_key(key);
  std::string text;
  for (const Key* one : found) text += (text.empty() ? "" : "\n") + entry(*one);
  return text;
}

}  // namespace pulvis
