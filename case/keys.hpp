// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/units.hpp"

// The declaration of every key of a case file. Validation, `explain`, the reference page and the JSON
// Schema are made from it; there is no second list. To add a key: add its row in key_table_*.cpp and read
// it in build.cpp.
namespace pulvis::case_file {

enum class KeyKind {
  table,          ///< [gravity]
  named_tables,   ///< [materials.NAME]
  listed_tables,  ///< [[phases]]
  quantity,       ///< text with a unit
  number,         ///< a number without unit; "30 %" too
  integer,
  text,
  boolean,
  choice,      ///< one of `choices`
  choices,     ///< a list of them
  name,        ///< a name out of the table `refers_to`
  names,       ///< a list of them
  quantities,  ///< a list of text with units
  numbers,     ///< a list of numbers
  vector,      ///< three quantities
  direction,   ///< three numbers, not all zero; only their direction counts
};

/// What must hold for a number; for a list, for each of its numbers. In SI units.
struct Range {
  enum class End { open, included, excluded };
  End low_end = End::open, high_end = End::open;
  double low = 0.0, high = 0.0;

  bool contains(double value) const;
  bool is_open() const { return low_end == End::open && high_end == End::open; }
};

/// Whether a key must be there.
enum class Presence {
  required,
  optional,  ///< `standard` holds if it is not given; without a `standard`, nothing holds
  one_of,    ///< exactly one of this key and its `partner`
};

/// A key counts only where a key beside it has one of some values.
struct Condition {
  std::string key;                  ///< empty: always
  std::vector<std::string> values;  ///< of that key
};

struct Key {
  std::string pattern{};  ///< "materials.*.density", "phases[].until"
  KeyKind kind = KeyKind::table;
  Dimension dimension{};  ///< quantity, quantities, vector
  std::string example{};  ///< as written in TOML
  Presence presence = Presence::optional;
  std::string standard{};    ///< the default, as written in TOML; empty: none
  std::string when_unset{};  ///< in words, what holds if there is no `standard`
  Range range{};             ///< of numbers and quantities
  std::size_t length = 0;    ///< of a list; 0: any
  std::vector<std::string> choices{};
  std::string refers_to{};  ///< named table whose names are meant
  std::string partner{};    ///< key beside this one that excludes it
  Condition only_when{};
  bool file = false;  ///< text: the path of a file, seen from the file that gives it
  std::string help{};
};

/// All keys, tables before what stands in them.
const std::vector<Key>& all_keys();

/// The pattern of the table that a key stands in: "materials.*" for "materials.*.density", "" at the top.
std::string parent_pattern(std::string_view pattern);

/// The last part of a pattern: "density"; "*" for the elements of a named table.
std::string leaf_of(std::string_view pattern);

/// The pattern of one element of a named or listed table; of a plain table, its own.
std::string element_pattern(const Key& key);

/// The keys that stand directly in a table.
const std::vector<const Key*>& keys_in(std::string_view table_pattern);

/// The key of this name in a table, or nullptr.
const Key* find_key(std::string_view table_pattern, std::string_view leaf);

bool is_table(KeyKind kind);

/// "a pressure with its unit", "one of \"hertz\", \"jkr\"": what a value of this key is.
std::string describe_kind(const Key& key);

/// "greater than 0 m"; empty if anything goes.
std::string describe_range(const Key& key);

/// "kind is \"sine\""; empty if always.
std::string describe_condition(const Condition& condition);

/// `"a", "b" or "c"`.
std::string enumerate(const std::vector<std::string>& words, std::string_view last = "or");

/// The candidate a mistyped word was probably meant to be: at most two edits away, fewer for short words.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace pulvis::case_file
