// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <string>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// Triangles as a file lists them, each with three corners of its own that know of no neighbour. The order of
/// the corners is counter-clockwise seen from outside, if the file is right.
struct TriangleSoup {
  std::string source;                          ///< the file, for messages
  std::vector<std::array<Vec3, 3>> triangles;  ///< in units of the file; facet number = index + 1
};

}  // namespace pulvis
