// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/walls/faceted_wall.hpp"
#include "measures/cell_tiles.hpp"
#include "measures/wall_tile.hpp"

namespace pulvis::measures {

/// The triangles of a mesh by patch.
class PatchLists {
 public:
  explicit PatchLists(const FacetedWall& wall);
  std::span<const std::uint32_t> triangles(std::uint32_t patch) const {
    return std::span(order_).subspan(begin_[patch], begin_[patch + 1] - begin_[patch]);
  }

 private:
  std::vector<std::uint32_t> begin_, order_;
};

/// Tiles of a patch: what of its triangles lies in the cells of a grid along the axes of the body. Along an
/// axis that the patch runs along (no triangle is inclined to it) the cells divide it evenly, so a rectangle
/// of triangles has the tiles of a rectangle; along the others they are cubes of `edge`. Pieces below half of
/// edge^2 are joined with neighbours. `tile_of_facet`, by triangle of the mesh, is set to the tile that a
/// triangle of the patch lies in, or to CellTiles::none if it lies in several cells.
CellTiles patch_tiles(const FacetedWall& wall, std::span<const std::uint32_t> triangles, double edge,
                      const std::string& name, std::vector<std::uint32_t>& tile_of_facet);

/// Sets u and v of the tiles of a patch, from its middle. One that faces mostly one way is seen from there,
/// u along perpendicular(mean normal). One that goes round is unrolled about the coordinate axis its normals
/// point along least: u is the angle, counter-clockwise from perpendicular(axis), times the mean distance
/// from the axis, v the way along it.
void lay_out(std::span<WallTile> patch);

}  // namespace pulvis::measures
