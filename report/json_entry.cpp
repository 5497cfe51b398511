// SPDX-License-Identifier: Apache-2.0
#include "report/json_entry.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>

#include "engine/base/failure.hpp"

namespace pulvis::report {

using Json = nlohmann::ordered_json;

void JsonEntry::fail(const std::string& expected) const {
  throw Failure(Exit::bad_input,
                fmt::format("{}: {}: expected {}; the file is damaged or was not written by pulvis", file_,
                            place_.empty() ? "/" : place_, expected));
}

bool JsonEntry::has(const std::string& key) const { return json_.is_object() && json_.contains(key); }

JsonEntry JsonEntry::at(const std::string& key) const {
  if (!json_.is_object()) fail("an object");
  const auto found = json_.find(key);
  if (found == json_.end()) fail(fmt::format("an entry \"{}\"", key));
  return {*found, file_, place_ + "/" + key};
}

std::optional<JsonEntry> JsonEntry::find(const std::string& key) const {
  if (!has(key)) return {};
  return at(key);
}

std::vector<JsonEntry> JsonEntry::items() const {
  if (!json_.is_array()) fail("a list");
  std::vector<JsonEntry> list;
  for (std::size_t k = 0; k < json_.size(); ++k)
    list.push_back(JsonEntry(json_[k], file_, fmt::format("{}/{}", place_, k)));
  return list;
}

std::vector<std::pair<std::string, JsonEntry>> JsonEntry::members() const {
  if (!json_.is_object()) fail("an object");
  std::vector<std::pair<std::string, JsonEntry>> list;
  for (const auto& [key, value] : json_.items())
    list.emplace_back(key, JsonEntry(value, file_, place_ + "/" + key));
  return list;
}

double JsonEntry::number() const {
  if (json_.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!json_.is_number()) fail("a number");
  return json_.get<double>();
}

std::string JsonEntry::text() const {
  if (!json_.is_string()) fail("a text");
  return json_.get<std::string>();
}

std::size_t JsonEntry::count() const {
  const double value = number();
  if (!(value >= 0.0 && value <= 1e15) || value != std::floor(value)) fail("a whole number from 0");
  return static_cast<std::size_t>(value);
}

std::vector<double> JsonEntry::numbers() const {
  std::vector<double> list;
  for (const JsonEntry& item : items()) list.push_back(item.number());
  return list;
}

std::vector<double> JsonEntry::numbers(std::size_t size) const {
  if (json_.is_array() && json_.size() != size) fail(fmt::format("{} numbers, not {}", size, json_.size()));
  return numbers();
}

double JsonEntry::number_or(const std::string& key, double otherwise) const {
  return has(key) ? at(key).number() : otherwise;
}

std::string JsonEntry::text_or(const std::string& key, const std::string& otherwise) const {
  return has(key) ? at(key).text() : otherwise;
}

std::vector<std::string> JsonEntry::texts_or_none(const std::string& key) const {
  std::vector<std::string> list;
  if (has(key))
    for (const JsonEntry& item : at(key).items()) list.push_back(item.text());
  return list;
}

std::optional<std::string> read_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const auto fail = [&](const char* why) {
    throw Failure(Exit::bad_input, fmt::format("cannot read {}: {}", path, why));
  };
  if (!std::filesystem::is_regular_file(path, error)) fail("it is not a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) fail(std::strerror(errno));
  std::string bytes;
  char part[65536];
  while (const std::size_t got = std::fread(part, 1, sizeof part, file.get())) bytes.append(part, got);
  if (std::ferror(file.get())) fail(std::strerror(errno));
  return bytes;
}

std::optional<Json> read_json(const std::string& path) {
  const auto bytes = read_bytes(path);
  if (!bytes) return {};
  try {
    return Json::parse(*bytes);
  } catch (const Json::exception& error) {
    throw Failure(Exit::bad_input, fmt::format("{} is damaged: {}", path, error.what()));
  }
}

}  // namespace pulvis::report
