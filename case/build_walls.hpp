// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/case.hpp"
#include "case/sections.hpp"

// Walls and motions out of checked sections.
namespace pulvis::case_file {

/// All of a wall but its material and motions, which are indices. `folder` is that of the case file.
Wall build_wall(const Section& section, const std::string& folder);

Motion build_motion(const Section& section);

/// Of a region table or of a wall, which holds the same keys.
Region build_region(const Section& section);

}  // namespace pulvis::case_file
