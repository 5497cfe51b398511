// SPDX-License-Identifier: Apache-2.0
#include "case/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "case/build.hpp"
#include "case/checker.hpp"
#include "case/extension.hpp"
#include "case/rules.hpp"

namespace pulvis {
namespace {

using namespace case_file;

void list_origins(const Section& section, const ProblemList& problems,
                  std::vector<std::pair<std::string, std::string>>& origins) {
  if (section.given && !section.path.empty())
    origins.emplace_back(section.path, problems.describe(section.place));
  for (const auto& [key, setting] : section.settings)
    if (setting.given) origins.emplace_back(setting.path, problems.describe(setting.place));
  for (const auto& [key, table] : section.tables) list_origins(table, problems, origins);
  for (const auto& [key, group] : section.groups)
    for (const Section& element : group) list_origins(element, problems, origins);
}

std::string meaning_of(const Setting& setting) {
  if (setting.key->kind == KeyKind::boolean) return setting.flag ? "true" : "false";
  if (setting.key->kind == KeyKind::integer) return fmt::format("{}", setting.integer);
  return fmt::format("{}{}", fmt::join(setting.numbers, " "), fmt::join(setting.texts, "\n"));
}

std::vector<ResolvedKey> resolved(const Section& root, const ProblemList& problems) {
  std::vector<const Setting*> settings;
  list_settings(root, settings);
  std::vector<ResolvedKey> result;
  for (const Setting* setting : settings)
    result.push_back({setting->path, setting->written, meaning_of(*setting),
                      setting->given ? problems.describe(setting->place) : "default",
                      setting->given ? problems.comment_at(setting->place) : ""});
  return result;
}

void put_in(const std::vector<Override>& overrides, Value& root, ProblemList& problems) {
  apply_overrides(overrides, root, problems);
  if (const Entry* late = root.find("extends"))
    problems.add(late->place, "extends is no key for --set: what a case extends is settled before",
                 "write it into a case file of its own");
}

}  // namespace

Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<Override>& overrides) {
  ProblemList problems(name, text);
  Extended files = read_with_bases(text, name, problems);
  std::string merged = files.bases.empty() ? text : text_of(files, name);
  put_in(overrides, files.root, problems);
  const Section sections = check_keys(files.root, problems);
  check_rules(sections, problems);
  problems.throw_if_any();
  Case result = build_case(sections, name);
  list_origins(sections, problems, result.origins);
  result.keys = resolved(sections, problems);
  result.file = name;
  result.bases = std::move(files.bases);
  result.text = std::move(merged);
  return result;
}

Case read_case(const std::string& path, const std::vector<Override>& overrides) {
  return read_case_text(text_of_case_file(path), path, overrides);
}

std::string places_of(const Case& c, const std::vector<std::string>& keys) {
  std::vector<std::string> places;
  for (const std::string& asked : keys)
    for (const ResolvedKey& key : c.keys)
      if (key.origin != "default" && (key.key == asked || key.key.starts_with(asked + ".")))
        places.push_back(key.origin);
  return short_list(places);
}

std::string place_of(const Case& c, std::string key) {
  while (true) {
    for (const auto& [written, place] : c.origins)
      if (written == key) return place;
    const std::size_t dot = key.rfind('.');
    if (dot == std::string::npos) return c.file;
    key.resize(dot);
  }
}

}  // namespace pulvis
