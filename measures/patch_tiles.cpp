// SPDX-License-Identifier: Apache-2.0
#include "measures/patch_tiles.hpp"

#include <cmath>
#include <numeric>

#include "engine/math/region.hpp"

namespace pulvis::measures {
namespace {

Polygon polygon_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  Polygon polygon;
  for (int k = 0; k < 3; ++k) polygon.add(mesh.corner(triangle, k));
  return polygon;
}

/// What a grid for a patch must know of it.
struct Extent {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};  ///< m
  double area = 0.0;                                            ///< m^2
  Vec3 inclined;  ///< m^2; integral of the squares of the normal's components
};

Extent extent_of(const FacetedWall& wall, std::span<const std::uint32_t> triangles) {
  Extent extent;
  for (const std::uint32_t t : triangles) {
    const Polygon polygon = polygon_of(wall.mesh(), t);
    const double area = area_moments(polygon).area;
    if (!(area > 0.0)) continue;
    extent.area += area;
    for (int axis = 0; axis < 3; ++axis) {
      extent.inclined[axis] += area * square(wall.normal_of(t)[axis]);
      for (const Vec3& p : {polygon.corner[0], polygon.corner[1], polygon.corner[2]}) {
        extent.low[axis] = least(extent.low[axis], p[axis]);
        extent.high[axis] = greatest(extent.high[axis], p[axis]);
      }
    }
  }
  return extent;
}

}  // namespace

PatchLists::PatchLists(const FacetedWall& wall) : begin_(wall.patches() + 1, 0) {
  const auto count = static_cast<std::uint32_t>(wall.mesh().triangles.size());
  for (std::uint32_t t = 0; t < count; ++t) ++begin_[wall.patch_of(t) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  order_.resize(count);
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t t = 0; t < count; ++t) order_[next[wall.patch_of(t)]++] = t;
}

CellTiles patch_tiles(const FacetedWall& wall, std::span<const std::uint32_t> triangles, double edge,
                      const std::string& name, std::vector<std::uint32_t>& tile_of_facet) {
  const Extent extent = extent_of(wall, triangles);
  check_number_of_tiles(extent.area, edge, name);
  std::array<CellTiles::Spacing, 3> spacing{};
  for (int axis = 0; axis < 3; ++axis)
    spacing[static_cast<std::size_t>(axis)] =
        extent.inclined[axis] < 1e-6 * extent.area ? CellTiles::Spacing::even : CellTiles::Spacing::fixed;
  CellTiles tiles(Rigid{}, extent.low, extent.high, edge, spacing);
  for (const std::uint32_t t : triangles)
    tile_of_facet[t] = tiles.add(polygon_of(wall.mesh(), t), wall.normal_of(t));
  tiles.join(0.5 * (1.0 - 1e-9) * square(edge));
  for (const std::uint32_t t : triangles)
    if (tile_of_facet[t] != CellTiles::none) tile_of_facet[t] = tiles.tile_of_cell(tile_of_facet[t]);
  return tiles;
}

void lay_out(std::span<WallTile> patch) {
  double area = 0.0;
  Vec3 middle, facing, inclined;
  for (const WallTile& tile : patch) {
    area += tile.area;
    middle += tile.area * tile.centre;
    facing += tile.area * tile.normal;
    for (int a = 0; a < 3; ++a) inclined[a] += tile.area * square(tile.normal[a]);
  }
  middle = middle / area;
  const bool one_way = norm(facing) > 0.5 * area;
  Vec3 axis = facing / (one_way ? norm(facing) : 1.0);
  if (!one_way) {
    axis = {};
    axis[inclined.x < least(inclined.y, inclined.z) ? 0 : inclined.y < inclined.z ? 1 : 2] = 1.0;
  }
  const Vec3 ahead = perpendicular(axis), aside = cross(axis, ahead);
  double radius = 0.0;
  for (WallTile& tile : patch) {
    const Vec3 away = tile.centre - middle;
    tile.u = dot(away, ahead);
    tile.v = dot(away, aside);
    radius += tile.area * root(square(tile.u) + square(tile.v)) / area;
  }
  if (one_way) return;
  for (WallTile& tile : patch) {
    const double angle = std::atan2(tile.v, tile.u);
    tile.u = radius * (angle < 0.0 ? angle + 2.0 * pi : angle);
    tile.v = dot(tile.centre - middle, axis);
  }
}

}  // namespace pulvis::measures
