// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "case/key_text.hpp"
#include "case/keys.hpp"
#include "case/reader.hpp"

namespace pulvis {
namespace case_file {

std::string describe_default(const Key& key) {
  switch (key.presence) {
    case Presence::required:
      return "required";
    case Presence::one_of:
      return fmt::format("required, this or {}", key.partner);
    case Presence::optional:
      break;
  }
  const std::string excluded = key.partner.empty() ? "" : fmt::format("; not together with {}", key.partner);
  if (!key.standard.empty()) return key.standard + excluded;
  return (key.when_unset.empty() ? "optional" : key.when_unset) + excluded;
}

std::vector<std::string> top_level_tables() {
  std::vector<std::string> result;
  for (const Key* key : keys_in(""))
    if (is_table(key->kind)) result.push_back(key->pattern);
  return result;
}

}  // namespace case_file

namespace {

using namespace case_file;

std::string header(const Key& key) {
  std::string path = key.pattern;
  if (const std::size_t star = path.find('*'); star != std::string::npos) path.replace(star, 1, "NAME");
  if (key.kind == KeyKind::named_tables) return fmt::format("[{}.NAME]", path);
  if (key.kind == KeyKind::listed_tables) return fmt::format("[[{}]]", path);
  return fmt::format("[{}]", path);
}

std::string row(const Key& key) {
  std::string meaning = key.help;
  if (!key.only_when.key.empty()) meaning += fmt::format(" (where {})", describe_condition(key.only_when));
  const std::string range = describe_range(key);
  const bool literal = key.presence == Presence::optional && !key.standard.empty() && key.partner.empty();
  const std::string standard = describe_default(key);
  return fmt::format("| `{}` | {}{} | {} | {} |\n", leaf_of(key.pattern), describe_kind(key),
                     range.empty() ? "" : ", " + range, literal ? fmt::format("`{}`", standard) : standard,
                     meaning);
}

void append_table(const Key* table, const std::string& pattern, std::string& text) {
  if (table != nullptr)
    text += fmt::format("\n## `{}`\n\n{}; {}.\n", header(*table), table->help, describe_default(*table));
  std::string rows;
  for (const Key* key : keys_in(pattern))
    if (!is_table(key->kind)) rows += row(*key);
  if (!rows.empty()) text += "\n| key | value | default | meaning |\n|---|---|---|---|\n" + rows;
  for (const Key* key : keys_in(pattern))
    if (is_table(key->kind)) append_table(key, element_pattern(*key), text);
}

}  // namespace

std::string keys_reference_markdown() {
  std::string text =
      "# Keys of a case file\n\n"
      "Made from the key table (`case/key_table*.cpp`); do not edit.\n\n"
      "A case is a TOML file. A value with a dimension is text with its unit: `\"4.6 um\"`, `\"25 mJ/m^2\"`, "
      "`\"10.2 g/cm^3\"`, `\"5 Hz\"`, `\"90 deg\"`. `pulvis explain KEY` shows the same on a terminal, and "
      "`--set key=value` replaces a value: `--set powders.mo.coarse_graining=50`, `--set "
      "phases.shake.cycles=5` "
      "(the phase of that name), `--set phases[2].cycles=5` (counted from 0).\n";
  append_table(nullptr, "", text);
  return text;
}

}  // namespace pulvis
