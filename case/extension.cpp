// SPDX-License-Identifier: Apache-2.0
#include "case/extension.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <unordered_map>
#include <utility>

#include "case/keys.hpp"
#include "case/toml_source.hpp"

namespace pulvis::case_file {
namespace {

namespace fs = std::filesystem;

// The pattern of what stands under a key: [materials] holds names, and each name is a materials.*.
std::string pattern_below(const std::string& pattern, const std::string& name) {
  if (const Key* key = find_key(pattern, name)) return key->pattern;
  const std::string named = pattern + ".*";
  return keys_in(named).empty() ? "no key" : named;
}

// Whether a key of the base has lost its meaning beside what the extension gives.
bool falls_away(const Entry& old, const Value& over, const std::string& pattern) {
  const Key* key = find_key(pattern, old.key);
  if (key == nullptr || over.find(old.key) != nullptr) return false;
  if (!key->partner.empty() && over.find(key->partner) != nullptr) return true;
  if (key->only_when.key.empty()) return false;
  const Entry* state = over.find(key->only_when.key);
  const auto& values = key->only_when.values;
  return state != nullptr && std::find(values.begin(), values.end(), state->value.text) == values.end();
}

void make_paths_absolute(Value& table, const std::string& pattern, const fs::path& folder) {
  for (Entry& entry : table.entries) {
    const Key* key = find_key(pattern, entry.key);
    if (entry.value.kind == Value::Kind::table)
      make_paths_absolute(entry.value, pattern_below(pattern, entry.key), folder);
    else if (entry.value.kind == Value::Kind::text && key != nullptr && key->file)
      entry.value.text = (folder / entry.value.text).lexically_normal().string();
  }
}

void set_source(Value& value, int source) {
  value.place.source = source;
  for (Value& item : value.items) set_source(item, source);
  for (Entry& entry : value.entries) {
    entry.place.source = source;
    set_source(entry.value, source);
  }
}

Value parsed(const std::string& text, int source, ProblemList& problems) {
  auto result = parse_toml(text);
  if (SyntaxError* error = std::get_if<SyntaxError>(&result)) {
    error->place.source = source;
    problems.add(error->place, error->message, error->expected);
    problems.throw_if_any();
  }
  Value& root = std::get<Value>(result);
  set_source(root, source);
  return std::move(root);
}

// Takes out what a file extends.
std::optional<Entry> take_extends(Value& root, ProblemList& problems) {
  Entry* found = root.find("extends");
  if (found == nullptr) return {};
  Entry entry = std::move(*found);
  root.entries.erase(root.entries.begin() + (found - root.entries.data()));
  if (entry.value.kind == Value::Kind::text && !entry.value.text.empty()) return entry;
  problems.add(entry.value.place,
               entry.value.kind == Value::Kind::text ? "extends is empty"
                                                     : "extends is " + kind_with_article(entry.value.kind),
               "expected the path of a case file, e.g. \"base.toml\"");
  problems.throw_if_any();
  return {};
}

fs::path folder_of(const std::string& file) { return fs::absolute(file).parent_path(); }

// One file whichever way it is named; as written where the system cannot tell.
fs::path identity(const std::string& file) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(file), error);
  return error ? fs::absolute(file).lexically_normal() : real;
}

void refuse_circle(const std::vector<std::string>& files, const std::string& next, const Place& place,
                   ProblemList& problems) {
  const auto same = [&](const std::string& file) { return identity(file) == identity(next); };
  const auto first = std::find_if(files.begin(), files.end(), same);
  if (first == files.end()) return;
  problems.add(place,
               fmt::format("files extend each other in a circle: {} -> {}",
                           fmt::join(first, files.end(), " -> "), next),
               "the last of a chain extends nothing");
  problems.throw_if_any();
}

}  // namespace

std::string text_of_case_file(const std::string& path, const std::string& wanted_by) {
  const auto unreadable = [&](const std::string& why) {
    return Failure(Exit::bad_input, fmt::format("{}: cannot read the case file: {}{}", path, why,
                                                wanted_by.empty() ? "" : "\n  " + wanted_by));
  };
  // A folder opens like a file, and reading a device may never end.
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw unreadable("there is no such file");
  if (!fs::exists(status)) throw unreadable(error.message());
  if (fs::is_directory(status)) throw unreadable("it is a folder");
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

void merge(Value& base, Value over, const std::string& pattern) {
  std::erase_if(base.entries, [&](const Entry& old) { return falls_away(old, over, pattern); });
  base.place = over.place;
  std::unordered_map<std::string, std::size_t> there;  // of a table of thousands, too
  for (std::size_t k = 0; k < base.entries.size(); ++k) there.emplace(base.entries[k].key, k);
  for (Entry& entry : over.entries) {
    const auto found = there.find(entry.key);
    Entry* old = found == there.end() ? nullptr : &base.entries[found->second];
    if (old == nullptr) {
      base.entries.push_back(std::move(entry));
    } else if (old->value.kind == Value::Kind::table && entry.value.kind == Value::Kind::table) {
      old->place = entry.place;
      merge(old->value, std::move(entry.value), pattern_below(pattern, entry.key));
    } else {
      *old = std::move(entry);
    }
  }
}

Extended read_with_bases(const std::string& text, const std::string& name, ProblemList& problems) {
  std::vector<std::string> files{name};
  std::vector<Value> roots{parsed(text, 0, problems)};
  while (const std::optional<Entry> extends = take_extends(roots.back(), problems)) {
    const std::string next =
        (fs::path(files.back()).parent_path() / extends->value.text).lexically_normal().string();
    refuse_circle(files, next, extends->value.place, problems);
    const std::string more = text_of_case_file(next, problems.describe(extends->value.place) + " extends it");
    roots.push_back(parsed(more, problems.add_file(next, more), problems));
    files.push_back(next);
  }
  if (files.size() > 1)
    for (std::size_t k = 0; k < files.size(); ++k) make_paths_absolute(roots[k], "", folder_of(files[k]));
  Extended result{std::move(roots.back()), {}};
  for (std::size_t k = roots.size() - 1; k-- > 0;) merge(result.root, std::move(roots[k]));
  result.bases.assign(files.begin() + 1, files.end());
  return result;
}

std::string text_of(const Extended& files, const std::string& name) {
  std::string text = fmt::format("# Put together by pulvis {} from {}, which extends {}.\n", PULVIS_VERSION,
                                 name, fmt::join(files.bases, ", which extends "));
  std::replace(text.begin(), text.end() - 1, '\n', ' ');  // in a name of a file
  return text + toml_text(files.root);
}

}  // namespace pulvis::case_file
