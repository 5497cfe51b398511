// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "engine/walls/bodies.hpp"
#include "measures/cell_tiles.hpp"
#include "measures/rectangle_tiles.hpp"
#include "measures/ring_tiles.hpp"
#include "measures/wall_tile.hpp"

namespace pulvis::measures {

/// All surfaces of walls, divided into tiles. A tile is at least `edge` wide along each direction in which
/// its surface is; a surface smaller than that is one tile.
///
/// Rectangle: an even grid along its sides. Disc, mantle, sphere: rings and sectors (ring_tiles.hpp). Plane:
/// what lies in the domain, in an even grid. Patch of a mesh: what lies in the cells of a grid along the axes
/// of the body; parts below half of edge^2 are joined with neighbours, so where a patch is inclined to the
/// axes it is the area that is bounded below, not the width. Areas are exact but for rounding. Normals point
/// as those of the surfaces, and away from the axis or centre of curved ones.
///
/// On the map, u and v run along the sides of a rectangle from its centre; in a plane from its point; of a
/// patch see lay_out in patch_tiles.hpp. They are for pictures: a bent patch may cover itself.
class WallTiling {
 public:
  static constexpr std::uint32_t no_facet = 0xffffffff;
  static constexpr std::uint32_t no_tile = 0xffffffff;

  /// Planes are cut off at the box from `low` to `high`. `edge` in m; throws Failure if it is not above zero
  /// or so small that there would be millions of tiles.
  WallTiling(const Walls& walls, const Vec3& low, const Vec3& high, double edge);

  /// In the order of surfaces.
  std::span<const WallTile> tiles() const { return tiles_; }

  /// Tile that the point of a surface belongs to, in the frame of its body. `facet` is the triangle of its
  /// mesh that the point lies on, or no_facet. A point off the surface belongs to the tile below it or,
  /// beyond the rim, to the nearest. no_tile for a plane outside the domain.
  std::uint32_t tile_of(std::uint32_t surface, std::uint32_t facet, const Vec3& point) const;

 private:
  /// The tiles of one surface; tile_of calls it for each contact with a wall, hence no virtual functions.
  struct Part {
    std::variant<std::monostate, RectangleTiles, RingTiles, CellTiles> tiles;
    std::uint32_t first = 0;        ///< in tiles_
    std::uint32_t mesh = no_facet;  ///< of a patch
  };
  void add_shape(Part& part, const Surface& surface, const Vec3& low, const Vec3& high, double edge);
  void add_patch(Part& part, const Surface& surface, const FacetedWall& wall,
                 std::span<const std::uint32_t> triangles, double edge);

  std::vector<Part> parts_;                                ///< by surface
  std::vector<std::vector<std::uint32_t>> tile_of_facet_;  ///< by mesh and triangle; no_tile if in several
  std::vector<WallTile> tiles_;
};

}  // namespace pulvis::measures
