// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "case/case.hpp"
#include "case/sections.hpp"

namespace pulvis::case_file {

/// Makes the typed case of sections in which no problem was found. `name` is the case file's path:
/// paths in the case are seen from its folder. `title`, `file` and `text` of the file are the caller's.
Case build_case(const Section& root, const std::string& name);

}  // namespace pulvis::case_file
