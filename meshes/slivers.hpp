// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/welding.hpp"

namespace pulvis {

/// A triangle's area, m^2 if the points are in m.
double area_of(std::span<const Vec3> points, const Corners& corners);
/// Its smallest height, over its longest edge.
double height_of(std::span<const Vec3> points, const Corners& corners);

/// Takes out triangles no higher than `height`, without opening cracks. The corner opposite to the longest
/// edge of such a triangle lies on that edge as far as `height` can tell; so the triangles on the other side
/// of the edge are split there, and their halves join the sliver's other neighbours in its stead. The surface
/// moves by less than `height`.
/// A sliver stays if the halves would be no better than it, as where `height` is not small against the mesh, or
/// if a knot of slivers needs more work than its size warrants. Triangles without any area go even then, for
/// they have no normal. Returns how many slivers stay.
/// A half of a split triangle keeps its facet number.
std::uint64_t remove_slivers(std::span<const Vec3> points, double height, std::vector<Corners>& triangles,
                             std::vector<std::uint32_t>& facets);

}  // namespace pulvis
