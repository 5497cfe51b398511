// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "case/problems.hpp"
#include "case/sections.hpp"

namespace pulvis::case_file {

/// The names in each named table of a case.
struct KnownNames {
  std::map<std::string, std::set<std::string>> of_table;
};

/// Reads the value of one key as its declaration says; what is wrong with it goes to `problems`.
class SettingReader {
 public:
  SettingReader(const KnownNames& names, ProblemList& problems) : names_(names), problems_(problems) {}

  /// Fills numbers, texts and so on of `setting` from the value; sets `valid`.
  void read(const Value& value, Setting& setting) const;

 private:
  bool quantity(const Value& value, Setting& setting) const;
  bool plain_number(const Value& value, Setting& setting) const;
  bool whole_number(const Value& value, Setting& setting) const;
  bool word(const Value& value, Setting& setting) const;
  bool list(const Value& value, Setting& setting) const;
  bool element(const Value& value, Setting& setting) const;
  bool in_range(double number, const Value& value, const Setting& setting) const;
  bool known(const Value& value, const std::string& text, const Setting& setting) const;
  void wrong_kind(const Value& value, const Setting& setting) const;
  void wrong_quantity(const Value& value, const Setting& setting, const std::string& why,
                      const std::string& number) const;

  const KnownNames& names_;
  ProblemList& problems_;
};

}  // namespace pulvis::case_file
