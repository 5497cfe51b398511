// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

// The parsed file as this room sees it, whatever library read it.
namespace pulvis::case_file {

/// Where something is written: a place in the case file or in a `--set`.
struct Place {
  int source = 0;  ///< 0: the case file; then the files it extends, then the overrides; see ProblemList
  int line = 1;    ///< from 1
  int column = 1;  ///< from 1, in characters (code points)
  int length = 0;  ///< in characters, of the part on that line
};

struct Entry;

/// A value of the file: one of the kinds of TOML.
struct Value {
  enum class Kind { text, integer, number, boolean, list, table, date };
  Kind kind = Kind::table;
  Place place;
  std::string text;
  std::int64_t integer = 0;
  double number = 0.0;  ///< of an integer, too
  bool boolean = false;
  std::vector<Value> items;    ///< of a list
  std::vector<Entry> entries;  ///< of a table, in the order of the file

  const Entry* find(const std::string& key) const;
  Entry* find(const std::string& key);
};

/// A key of a table with its value.
struct Entry {
  std::string key;
  Place place;
  Value value;
};

/// "a table", "a list", "text": for messages.
std::string kind_with_article(Value::Kind kind);

/// The value as one would write it in the file, shortened if it is very long.
std::string written(const Value& value);

/// The same at whatever length.
std::string written_in_full(const Value& value);

/// A key as one would write it in the file, in quotes where it needs them.
std::string written_key(const std::string& key);

}  // namespace pulvis::case_file
