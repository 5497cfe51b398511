// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// Triangles that share their corners. The order of a triangle's corners is counter-clockwise seen from the
/// side its normal points to.
struct TriangleMesh {
  std::vector<Vec3> points;  ///< m
  std::vector<std::array<std::uint32_t, 3>> triangles;

  const Vec3& corner(std::size_t triangle, int k) const {
    return points[triangles[triangle][static_cast<std::size_t>(k)]];
  }
};

}  // namespace pulvis
