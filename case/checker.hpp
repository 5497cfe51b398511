// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/problems.hpp"
#include "case/sections.hpp"

namespace pulvis::case_file {

/// Checks a parsed case against the key table: unknown and missing keys, kinds, dimensions, ranges,
/// names, conditions. Problems are reported; the section holds what could be read, and the defaults.
Section check_keys(const Value& root, ProblemList& problems);

}  // namespace pulvis::case_file
