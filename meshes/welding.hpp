// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vec3.hpp"
#include "meshes/triangle_soup.hpp"

namespace pulvis {

using Corners = std::array<std::uint32_t, 3>;  ///< numbers of points

struct WeldedTriangles {
  std::vector<Vec3> points;
  std::vector<Corners> triangles;     ///< without those that have a point twice
  std::vector<std::uint32_t> facets;  ///< per triangle: its number in the file, from 0
  std::uint64_t points_moved = 0;     ///< different points of the file that became another point
  std::uint64_t degenerate = 0;       ///< left out: a corner twice already in the file
  std::uint64_t needles = 0;          ///< left out: corners closer together than `distance`
};

/// Makes one point of corners closer together than `distance` (which may be zero: equal corners only). The
/// points left are further apart than it, each is one of the file's, and no corner moves by more. Neither the
/// order of the triangles nor that of their corners changes the points: they are taken in the order of their
/// coordinates, and each goes to the nearest one left, so that no chain of close points collapses into one.
WeldedTriangles weld(std::span<const std::array<Vec3, 3>> triangles, double distance);

}  // namespace pulvis
