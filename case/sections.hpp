// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case/keys.hpp"
#include "case/value.hpp"
#include "engine/math/vec3.hpp"

// A case between text and `Case`: every value read in SI units with its place, or its default.
namespace pulvis::case_file {

/// One key of a case that has a value.
struct Setting {
  const Key* key = nullptr;
  std::string path;             ///< "materials.steel.density"
  bool given = false;           ///< in the file or by an override; otherwise it is the default
  bool valid = false;           ///< the value could be read; if not, that has been reported
  Place place;                  ///< of the value, if given
  Place key_place;              ///< of the key, if given
  std::string written;          ///< the value as TOML
  std::vector<double> numbers;  ///< SI; one for a number, three for a vector
  std::int64_t integer = 0;
  bool flag = false;
  std::vector<std::string> texts;  ///< one for a text, a choice, a name
  std::vector<Place> item_places;  ///< of the elements of a list
};

/// One table of a case. Where a table was not given, it stands there with its defaults.
struct Section {
  std::string name;  ///< "steel"; of a listed table, its index
  std::string path;  ///< "materials.steel", "phases[2]"
  std::string pattern;
  bool given = false;
  Place place;  ///< of the header or the key
  std::map<std::string, Setting> settings;
  std::map<std::string, Section> tables;               ///< plain tables
  std::map<std::string, std::vector<Section>> groups;  ///< named and listed tables, in the order of the file

  /// The setting if it has a valid value, else nullptr.
  const Setting* find(const std::string& key) const;

  /// Where to point at for a key: at its value, else at the table.
  Place place_of(const std::string& key) const;

  // Values of keys; the key must be declared, and have a valid value unless it is asked for as `optional_`.
  double number(const std::string& key) const;
  std::optional<double> optional_number(const std::string& key) const;
  std::int64_t integer(const std::string& key) const;
  bool flag(const std::string& key) const;
  const std::string& text(const std::string& key) const;
  const std::vector<std::string>& texts(const std::string& key) const;
  const std::vector<double>& numbers(const std::string& key) const;
  Vec3 vector(const std::string& key) const;
  Vec3 unit_vector(const std::string& key) const;

  /// The text of a key or nullptr if it has no valid value.
  const std::string* optional_text(const std::string& key) const;

  /// A table, or the tables of a group, below this one; empty and not given where a required table is not there at all or
  /// something else stands in its place, which has been said already when rules are looked at.
  const Section& table(const std::string& key) const;
  const std::vector<Section>& group(const std::string& key) const;

 private:
  const Setting& setting(const std::string& key) const;
};

/// Places of those settings that stand in the file; null pointers are let by.
std::vector<Place> places_of(std::initializer_list<const Setting*> settings);

/// Places of all that is given in a section and below it.
std::vector<Place> places_in(const Section& section);

/// The index of the element with this name, if there is one.
std::optional<std::size_t> index_of(const std::vector<Section>& group, const std::string& name);

/// All settings of a section and those below it, in the order of the key table.
void list_settings(const Section& section, std::vector<const Setting*>& settings);

}  // namespace pulvis::case_file
