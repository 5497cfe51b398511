// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// A cell of a grid that a surface passes through.
struct SurfaceCell {
  static constexpr std::uint32_t none = 0xffffffff;
  double area = 0.0;                          ///< m^2; of the surface in it
  Vec3 centre;                                ///< m; of that part
  std::array<std::uint32_t, 6> neighbours{};  ///< numbers of the cells across its faces, or none
};

/// Joins cells to groups that each have at least the area `least`, unless all of them are one group: over and
/// over, the group with the least area, if it is too small, is joined with the one of its neighbours that has
/// the most (with the nearest group if it has none, as where a surface passes through the edge of a cell).
/// Returns the number of each cell's group; groups are numbered in the order of their first cells.
std::vector<std::uint32_t> join_cells(const std::vector<SurfaceCell>& cells, double least);

}  // namespace pulvis::measures
