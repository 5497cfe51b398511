// SPDX-License-Identifier: Apache-2.0
#include "case/reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "case/build.hpp"
#include "case/checker.hpp"
#include "case/rules.hpp"
#include "case/toml_source.hpp"

namespace pulvis {
namespace {

using namespace case_file;

// Text to checked sections; throws with all problems found on the way.
Section checked_sections(const std::string& text, const std::vector<Override>& overrides,
                         ProblemList& problems) {
  auto parsed = parse_toml(text);
  if (const SyntaxError* error = std::get_if<SyntaxError>(&parsed)) {
    problems.add(error->place, error->message, error->expected);
    problems.throw_if_any();
  }
  Value& root = std::get<Value>(parsed);
  apply_overrides(overrides, root, problems);
  Section section = check_keys(root, problems);
  check_rules(section, problems);
  problems.throw_if_any();
  return section;
}

std::string text_of_file(const std::string& path) {
  const auto unreadable = [&](const std::string& why) {
    return Failure(Exit::bad_input, fmt::format("{}: cannot read the case file: {}", path, why));
  };
  // A folder opens like a file, and reading a device may never end.
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw unreadable("there is no such file");
  if (std::filesystem::is_directory(status)) throw unreadable("it is a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw unreadable(std::strerror(errno));
  // One byte beyond the limit is enough for the guard of the parser to refuse it.
  constexpr std::size_t most = (4u << 20) + 1;
  std::string text(most, '\0');
  file.read(text.data(), static_cast<std::streamsize>(most));
  if (file.bad()) throw unreadable(std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

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

}  // namespace

Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<Override>& overrides) {
  ProblemList problems(name, text);
  const Section sections = checked_sections(text, overrides, problems);
  Case result = build_case(sections, name);
  list_origins(sections, problems, result.origins);
  result.file = name;
  result.text = text;
  return result;
}

Case read_case(const std::string& path, const std::vector<Override>& overrides) {
  return read_case_text(text_of_file(path), path, overrides);
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

std::vector<ResolvedKey> resolved(const std::string& text, const std::string& name,
                                  const std::vector<Override>& overrides) {
  ProblemList problems(name, text);
  const Section root = checked_sections(text, overrides, problems);
  std::vector<const Setting*> settings;
  list_settings(root, settings);
  std::vector<ResolvedKey> result;
  for (const Setting* setting : settings)
    result.push_back({setting->path, setting->written, meaning_of(*setting),
                      setting->given ? problems.describe(setting->place) : "default"});
  return result;
}

}  // namespace pulvis
