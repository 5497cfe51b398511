// SPDX-License-Identifier: Apache-2.0
#include "measures/wall_tiles.hpp"

#include "measures/patch_tiles.hpp"
#include "measures/plane_tiles.hpp"

namespace pulvis::measures {
namespace {

/// m^2; of the shapes that have bounds of their own.
double area_of(const Surface& s) {
  switch (s.kind) {
    case Surface::Kind::rectangle:
      return 4.0 * s.half[0] * s.half[1];
    case Surface::Kind::disc:
      return pi * (s.radius - s.other_radius) * (s.radius + s.other_radius);
    case Surface::Kind::frustum:
      return pi * (s.radius + s.other_radius) * root(square(s.other_radius - s.radius) + square(s.height));
    case Surface::Kind::sphere:
      return 4.0 * pi * square(s.radius);
    case Surface::Kind::plane:
    case Surface::Kind::patch:
      break;
  }
  return 0.0;
}

}  // namespace

WallTiling::WallTiling(const Walls& walls, const Vec3& low, const Vec3& high, double edge) {
  std::vector<PatchLists> patches;
  for (const FacetedWall& mesh : walls.meshes) {
    patches.emplace_back(mesh);
    tile_of_facet_.emplace_back(mesh.mesh().triangles.size(), no_tile);
  }
  for (const Surface& surface : walls.surfaces) {
    Part& part = parts_.emplace_back();
    part.first = static_cast<std::uint32_t>(tiles_.size());
    if (surface.kind == Surface::Kind::patch) {
      add_patch(part, surface, walls.meshes[surface.mesh], patches[surface.mesh].triangles(surface.patch),
                edge);
    } else {
      add_shape(part, surface, low, high, edge);
    }
  }
}

void WallTiling::add_shape(Part& part, const Surface& surface, const Vec3& low, const Vec3& high,
                           double edge) {
  const auto number = static_cast<std::uint32_t>(parts_.size() - 1);
  if (surface.kind == Surface::Kind::plane) {
    if (auto tiles = plane_tiles(surface, low, high, edge)) part.tiles = std::move(*tiles);
  } else {
    check_number_of_tiles(area_of(surface), edge, surface.name);
    if (surface.kind == Surface::Kind::rectangle) {
      part.tiles.emplace<RectangleTiles>(surface, edge);
    } else {
      part.tiles.emplace<RingTiles>(surface, edge);
    }
  }
  if (const auto* rectangle = std::get_if<RectangleTiles>(&part.tiles)) rectangle->append_to(tiles_, number);
  if (const auto* rings = std::get_if<RingTiles>(&part.tiles)) rings->append_to(tiles_, number);
  if (const auto* cells = std::get_if<CellTiles>(&part.tiles)) cells->append_to(tiles_, number);
}

void WallTiling::add_patch(Part& part, const Surface& surface, const FacetedWall& wall,
                           std::span<const std::uint32_t> triangles, double edge) {
  std::vector<std::uint32_t>& tile_of_facet = tile_of_facet_[surface.mesh];
  part.mesh = surface.mesh;
  const auto& tiles =
      part.tiles.emplace<CellTiles>(patch_tiles(wall, triangles, edge, surface.name, tile_of_facet));
  tiles.append_to(tiles_, static_cast<std::uint32_t>(parts_.size() - 1));
  lay_out(std::span(tiles_).subspan(part.first));
  for (const std::uint32_t t : triangles)
    if (tile_of_facet[t] != no_tile) tile_of_facet[t] += part.first;
}

std::uint32_t WallTiling::tile_of(std::uint32_t surface, std::uint32_t facet, const Vec3& point) const {
  const Part& part = parts_[surface];
  if (const auto* rectangle = std::get_if<RectangleTiles>(&part.tiles))
    return part.first + rectangle->at(point);
  if (const auto* rings = std::get_if<RingTiles>(&part.tiles)) return part.first + rings->at(point);
  const auto* cells = std::get_if<CellTiles>(&part.tiles);
  if (cells == nullptr) return no_tile;
  if (facet != no_facet && part.mesh != no_facet) {
    const std::uint32_t tile = tile_of_facet_[part.mesh][facet];
    if (tile != no_tile) return tile;
  }
  return part.first + cells->at(point);
}

}  // namespace pulvis::measures
