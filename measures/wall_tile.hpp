// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>

#include "engine/math/vec3.hpp"
#include "measures/grid.hpp"

namespace pulvis::measures {

/// A piece of a wall's surface over which its pressure is averaged. Lengths and directions are in the frame
/// of the body, so they hold wherever it moves.
struct WallTile {
  std::uint32_t surface = 0;  ///< index in Walls::surfaces
  double area = 0.0;          ///< m^2
  Vec3 centre;                ///< m; mean of its points, which on a curved wall lies beside the wall
  Vec3 normal;                ///< unit vector: mean normal; where normals cancel, one of them
  double u = 0.0, v = 0.0;    ///< m; its place on the unfolded surface, for maps
};

/// Whether normals cancel so far that their mean (this vector, its length at most 1) has no direction left.
inline bool cancelled(const Vec3& mean_normal) { return !(norm(mean_normal) > 1e-6); }

/// The largest whole number of equal parts that are each at least `edge` long, or one part. A length that is
/// a whole number of edges but for rounding has that many parts.
inline double parts_within(double length, double edge) {
  return std::max(1.0, std::floor((1.0 + 1e-9) * length / edge));
}
inline Division evenly(double length, double edge) {
  return Division(length, length / parts_within(length, edge));
}

/// Throws Failure if tiles of this edge (m) would be more than anyone could look at; `area` is that of the
/// surface (m^2), `name` its name.
void check_number_of_tiles(double area, double edge, const std::string& name);

}  // namespace pulvis::measures
