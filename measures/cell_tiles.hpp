// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "engine/math/rigid.hpp"
#include "measures/cell_table.hpp"
#include "measures/grid.hpp"
#include "measures/polygon.hpp"
#include "measures/wall_tile.hpp"

namespace pulvis::measures {

/// Tiles of a surface of flat polygons: a grid of cells divides space, and what of the surface lies in a cell
/// is a tile, or a part of one where that is little. Add all polygons, then join, then ask.
class CellTiles {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// How the cells of a grid lie along one of its axes.
  enum class Spacing {
    even,  ///< fill the box exactly, each at least `edge` long: where the surface runs along the axis
    fixed  ///< `edge` long and centred: where it is inclined, so that its parts in the cells stay small
  };

  /// A grid around the box from `low` to `high`, which holds all polygons; both stand in a frame of their
  /// own, `into` leads there. Along an axis where the box is thin, one cell is centred about it, so that a
  /// flat surface never lies on a boundary.
  CellTiles(const Rigid& into, const Vec3& low, const Vec3& high, double edge,
            const std::array<Spacing, 3>& spacing);

  /// Adds a polygon with its unit normal; returns the cell that all of it lies in, or none if in several.
  std::uint32_t add(Polygon polygon, const Vec3& normal);

  /// Joins cells with less area than `least` with a neighbour, until none is left.
  void join(double least);

  std::uint32_t tile_of_cell(std::uint32_t cell) const { return cells_[cell].tile; }

  /// All tiles, in the order of their numbers. u and v are the first two coordinates in the frame of `into`.
  void append_to(std::vector<WallTile>& tiles, std::uint32_t surface) const;

  /// Number of the tile that a point on or near the surface belongs to. A point in a cell that the surface
  /// does not reach belongs to the nearest cell that it does.
  std::uint32_t at(const Vec3& point) const;

 private:
  using Index = std::array<std::uint32_t, 3>;
  struct Cell {
    Index index{};
    std::uint32_t tile = 0;
    double area = 0.0;  ///< m^2
    Vec3 first;         ///< m^3; area times mean position in the grid
    Vec3 normal;        ///< m^2; area times mean normal, in the frame of the body
    Vec3 one_normal;    ///< of the first polygon
  };
  Index index_of(const Vec3& place) const;
  std::uint64_t key(const Index& index) const;
  std::uint32_t number_at(const Index& index) const;  ///< of the cell or, from join() on, its tile
  std::uint32_t make_cell(const Index& index, const Vec3& normal);
  std::array<std::uint32_t, 6> neighbours_of(const Index& index) const;
  std::uint32_t nearest_tile(const Vec3& place) const;
  double square_distance(const Index& index, const Vec3& place) const;

  Rigid into_;   ///< from the frame of the body to that of the grid
  Vec3 corner_;  ///< m; of the grid, in its frame; places in the grid count from there
  std::array<Division, 3> along_;
  std::vector<Cell> cells_;  ///< those the surface reaches, in the order they were found in
  CellTable table_;          ///< cells by key; from join() on, their tiles
  std::uint32_t tiles_ = 0;
};

}  // namespace pulvis::measures
