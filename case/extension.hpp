// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/problems.hpp"
#include "case/value.hpp"

// A case file that says `extends = "base.toml"` adds to that file and changes it; so may that file in turn.
namespace pulvis::case_file {

/// The text of a case file. Throws Failure(Exit::bad_input) if it cannot be read; `wanted_by` says who asked for
/// it, empty for the user.
std::string text_of_case_file(const std::string& path, const std::string& wanted_by = "");

/// A case file and those it extends, put together; each value knows the file it stands in.
struct Extended {
  Value root;                      ///< without the key `extends`
  std::vector<std::string> bases;  ///< the files it extends, the nearest first
};

/// Parses `text`, which stands in the file `name`, and what it extends. Where it extends nothing, nothing is
/// changed; else paths of files are made absolute, seen from the file that gives them. Throws CaseError for
/// text that is no TOML, an `extends` that is no text, and files that extend each other in a circle;
/// Failure(Exit::bad_input) for a file that cannot be read.
Extended read_with_bases(const std::string& text, const std::string& name, ProblemList& problems);

/// The files put together as one text.
std::string text_of(const Extended& files, const std::string& name);

/// Puts `over` into `base`: tables key by key, all else replaces. A key of `base` falls away if `over` gives
/// the other of two that exclude each other, or the key that decides whether it has a meaning so that it has
/// none. `pattern`: of the tables, as in the key table.
void merge(Value& base, Value over, const std::string& pattern = "");

}  // namespace pulvis::case_file
