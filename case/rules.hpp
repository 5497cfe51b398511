// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/problems.hpp"
#include "case/sections.hpp"

namespace pulvis::case_file {

/// Checks what lies between keys: corners in order, names used once, sides that a shape has, sources
/// that some phase opens. A rule is silent where a value it needs is itself wrong.
void check_rules(const Section& root, ProblemList& problems);

/// The part of it that concerns phases and the sources and motions they use.
void check_phase_rules(const Section& root, ProblemList& problems);

/// The part on walls, motions and gravity.
void check_wall_rules(const Section& root, ProblemList& problems);

/// The part on sheared domains and what fills them.
void check_shear_rules(const Section& root, ProblemList& problems);

/// Walls that have an inside: boxes and cylinders, as indices.
std::vector<std::size_t> walls_with_inside(const Section& root);

}  // namespace pulvis::case_file
