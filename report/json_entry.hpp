// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pulvis::report {

/// An entry of a JSON file that knows where it stands, so that what is wrong with it can be said. Whatever is
/// not as expected throws Failure(Exit::bad_input) with file and entry. Valid while the document it was read
/// from is.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::ordered_json& json, std::string file) : json_(json), file_(std::move(file)) {}

  bool has(const std::string& key) const;
  JsonEntry at(const std::string& key) const;
  std::optional<JsonEntry> find(const std::string& key) const;
  /// The entries of a list.
  std::vector<JsonEntry> items() const;
  /// Name and value of each member, in the order of the file.
  std::vector<std::pair<std::string, JsonEntry>> members() const;

  double number() const;  ///< null: not a number (NaN)
  std::string text() const;
  std::size_t count() const;  ///< a whole number from 0
  std::vector<double> numbers() const;
  /// As many as that.
  std::vector<double> numbers(std::size_t size) const;

  double number_or(const std::string& key, double otherwise) const;
  std::string text_or(const std::string& key, const std::string& otherwise) const;
  std::vector<std::string> texts_or_none(const std::string& key) const;

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  JsonEntry(const nlohmann::ordered_json& json, std::string file, std::string place)
      : json_(json), file_(std::move(file)), place_(std::move(place)) {}
  const nlohmann::ordered_json& json_;
  std::string file_, place_;
};

/// A JSON file as a whole; nothing if there is none. Throws Failure(Exit::bad_input) naming it if it cannot be read or
/// is damaged.
std::optional<nlohmann::ordered_json> read_json(const std::string& path);

/// The bytes of a file; nothing if there is none. Throws Failure(Exit::bad_input) if it cannot be read.
std::optional<std::string> read_bytes(const std::string& path);

}  // namespace pulvis::report
