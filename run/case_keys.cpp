// SPDX-License-Identifier: Apache-2.0
#include "run/case_keys.hpp"

#include <fmt/format.h>

#include <map>

#include "output/checksum.hpp"

namespace pulvis {
namespace {

/// The files a case names, by the key that names them.
std::map<std::string, std::string> files_of(const Case& c) {
  std::map<std::string, std::string> files;
  for (const Wall& wall : c.walls)
    if (wall.shape == Wall::Shape::mesh) files["walls." + wall.name + ".path"] = wall.path;
  for (const Source& source : c.sources)
    if (source.kind == Source::Kind::file) files["sources." + source.name + ".path"] = source.path;
  return files;
}

}  // namespace

std::vector<CaseKey> deciding_keys(const Case& c) {
  const auto files = files_of(c);
  std::vector<CaseKey> keys;
  for (const ResolvedKey& k : c.keys) {
    if (k.key == "title" || k.key.starts_with("output.")) continue;
    const auto file = files.find(k.key);
    keys.push_back({k.key, k.value, file == files.end() ? k.meaning : checksum_of_file(file->second)});
  }
  return keys;
}

std::vector<std::string> differences(const std::vector<CaseKey>& before, const std::vector<CaseKey>& now) {
  std::map<std::string, const CaseKey*> old;
  for (const CaseKey& k : before) old[k.key] = &k;
  std::vector<std::string> lines;
  for (const CaseKey& k : now) {
    const auto at = old.find(k.key);
    if (at == old.end()) {
      lines.push_back(fmt::format("{} was not given, is {}", k.key, k.value));
      continue;
    }
    if (at->second->value == k.value && at->second->meaning != k.meaning)
      lines.push_back(fmt::format("{}: what is in {} has changed", k.key, k.value));
    else if (at->second->meaning != k.meaning)
      lines.push_back(fmt::format("{} was {}, is {}", k.key, at->second->value, k.value));
    old.erase(at);
  }
  for (const auto& [key, k] : old) lines.push_back(fmt::format("{} was {}, is not given", key, k->value));
  return lines;
}

}  // namespace pulvis
