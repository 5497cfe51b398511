// SPDX-License-Identifier: Apache-2.0
#include "measures/plane_tiles.hpp"

#include "engine/math/region.hpp"

namespace pulvis::measures {

Polygon plane_in_box(const Surface& plane, const Vec3& low, const Vec3& high) {
  const double reach = norm(high - low);
  const double slack = 1e-12 * reach;  // so that rounding does not lift a floor off the box it closes
  const Vec3 middle = 0.5 * (low + high), along = perpendicular(plane.normal),
             across = cross(plane.normal, along);
  const Vec3 foot = middle - dot(middle - plane.centre, plane.normal) * plane.normal;
  Polygon polygon, below, above;
  for (const auto& [u, v] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
    polygon.add(foot + (u * reach) * along + (v * reach) * across);
  const auto cut_off = [&](int axis, double bound, double side) {
    bool inside = true;
    for (int k = 0; k < polygon.count; ++k)
      inside = inside && side * (polygon.corner[k][axis] - bound) <= slack;
    if (inside) return;
    cut(polygon, axis, bound, below, above);
    polygon = side > 0.0 ? below : above;
  };
  for (int axis = 0; axis < 3; ++axis) {
    cut_off(axis, low[axis], -1.0);
    cut_off(axis, high[axis], 1.0);
  }
  return polygon;
}

std::optional<CellTiles> plane_tiles(const Surface& plane, const Vec3& low, const Vec3& high, double edge) {
  const Polygon polygon = plane_in_box(plane, low, high);
  const double area = area_moments(polygon).area;
  if (!(area > 0.0)) return std::nullopt;
  check_number_of_tiles(area, edge, plane.name);
  Rigid into;
  into.row[0] = perpendicular(plane.normal);
  into.row[1] = cross(plane.normal, into.row[0]);
  into.row[2] = plane.normal;
  into.shift = -into.turn(plane.centre);
  Vec3 first = into(polygon.corner[0]), last = first;
  for (int k = 1; k < polygon.count; ++k) {
    const Vec3 place = into(polygon.corner[k]);
    for (int axis = 0; axis < 3; ++axis) {
      first[axis] = least(first[axis], place[axis]);
      last[axis] = greatest(last[axis], place[axis]);
    }
  }
  constexpr auto even = CellTiles::Spacing::even;
  CellTiles tiles(into, first, last, edge, {even, even, even});
  tiles.add(polygon, plane.normal);
  tiles.join(0.5 * (1.0 - 1e-9) * square(edge));
  return tiles;
}

}  // namespace pulvis::measures
