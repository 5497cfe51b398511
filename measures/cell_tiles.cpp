// SPDX-License-Identifier: Apache-2.0
#include "measures/cell_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "measures/cell_joining.hpp"

namespace pulvis::measures {
namespace {

/// Calls visit(index, piece) for the pieces of a polygon in the cells of a grid.
template <class Visit>
void divide(const std::array<Division, 3>& along, Polygon rest, int axis, std::array<std::uint32_t, 3>& index,
            const Visit& visit) {
  if (axis == 3) return visit(index, rest);
  const auto a = static_cast<std::size_t>(axis);
  double low = rest.corner[0][axis], high = low;
  for (int k = 1; k < rest.count; ++k) {
    low = least(low, rest.corner[k][axis]);
    high = greatest(high, rest.corner[k][axis]);
  }
  const std::size_t last = along[a].at(high);
  Polygon below, above;
  for (std::size_t cell = along[a].at(low); cell < last && rest.count >= 3; ++cell) {
    cut(rest, axis, along[a].edge(cell + 1), below, above);
    index[a] = static_cast<std::uint32_t>(cell);
    if (below.count >= 3) divide(along, below, axis + 1, index, visit);
    rest = above;
  }
  index[a] = static_cast<std::uint32_t>(last);
  if (rest.count >= 3) divide(along, rest, axis + 1, index, visit);
}

}  // namespace

CellTiles::CellTiles(const Rigid& into, const Vec3& low, const Vec3& high, double edge,
                     const std::array<Spacing, 3>& spacing)
    : into_(into) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double length = high[axis] - low[axis];
    const bool fills = spacing[a] == Spacing::even && length >= edge;
    const double covered = fills ? length : edge * greatest(1.0, std::ceil((1.0 - 1e-9) * length / edge));
    along_[a] = fills ? evenly(length, edge) : Division(covered, edge);
    corner_[axis] = low[axis] - 0.5 * (covered - length);
  }
}

CellTiles::Index CellTiles::index_of(const Vec3& place) const {
  return {static_cast<std::uint32_t>(along_[0].at(place.x)),
          static_cast<std::uint32_t>(along_[1].at(place.y)),
          static_cast<std::uint32_t>(along_[2].at(place.z))};
}

std::uint64_t CellTiles::key(const Index& index) const {  // each index is below 1e6: no overflow
  return index[0] + along_[0].count() * (index[1] + along_[1].count() * std::uint64_t{index[2]});
}

std::uint32_t CellTiles::number_at(const Index& index) const {
  for (std::size_t a = 0; a < 3; ++a)  // one below the first wraps round and is beyond the last
    if (index[a] >= along_[a].count()) return none;
  return table_.find(key(index));
}

std::uint32_t CellTiles::make_cell(const Index& index, const Vec3& normal) {
  const auto next = static_cast<std::uint32_t>(cells_.size());
  const std::uint32_t number = table_.find_or_add(key(index), next);
  if (number == next) {
    Cell& cell = cells_.emplace_back();
    cell.index = index;
    cell.one_normal = normal;
  }
  return number;
}

std::uint32_t CellTiles::add(Polygon polygon, const Vec3& normal) {
  for (int k = 0; k < polygon.count; ++k) polygon.corner[k] = into_(polygon.corner[k]) - corner_;
  // Pieces smaller than this are rounding: what lies against a boundary belongs to one of its sides.
  const double negligible = 1e-12 * area_moments(polygon).area;
  std::uint32_t only = none, pieces = 0;
  Index index{};
  divide(along_, polygon, 0, index, [&](const Index& where, const Polygon& piece) {
    const AreaMoments moments = area_moments(piece);
    if (!(moments.area > negligible)) return;
    only = make_cell(where, normal);
    Cell& cell = cells_[only];
    cell.area += moments.area;
    cell.first += moments.first;
    cell.normal += moments.area * normal;
    ++pieces;
  });
  return pieces == 1 ? only : none;
}

std::array<std::uint32_t, 6> CellTiles::neighbours_of(const Index& index) const {
  std::array<std::uint32_t, 6> neighbours{};
  for (std::size_t side = 0; side < 6; ++side) {
    Index other = index;
    other[side / 2] += side % 2 == 0 ? std::uint32_t(-1) : 1u;
    neighbours[side] = number_at(other);
  }
  return neighbours;
}

void CellTiles::join(double least) {
  std::vector<SurfaceCell> cells;
  cells.reserve(cells_.size());
  for (const Cell& cell : cells_)
    cells.push_back({cell.area, cell.first / cell.area, neighbours_of(cell.index)});
  const std::vector<std::uint32_t> tile = join_cells(cells, least);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    cells_[c].tile = tile[c];
    tiles_ = std::max(tiles_, tile[c] + 1);
  }
  table_.renumber([&](std::uint32_t cell) { return tile[cell]; });
}

void CellTiles::append_to(std::vector<WallTile>& tiles, std::uint32_t surface) const {
  const std::size_t begin = tiles.size();
  tiles.resize(begin + tiles_);
  for (const Cell& cell : cells_) {
    WallTile& tile = tiles[begin + cell.tile];
    tile.area += cell.area;
    tile.centre += cell.first;
    tile.normal += cell.normal;
  }
  for (const Cell& cell : cells_) {
    WallTile& tile = tiles[begin + cell.tile];
    if (norm(tile.normal) <= 1e-6 * tile.area) tile.normal = tile.area * cell.one_normal;
  }
  for (std::size_t t = begin; t < tiles.size(); ++t) {
    WallTile& tile = tiles[t];
    const Vec3 place = tile.centre / tile.area + corner_;
    tile.surface = surface;
    tile.centre = into_.back(place);
    tile.normal = tile.normal / norm(tile.normal);
    tile.u = place.x;
    tile.v = place.y;
  }
}

std::uint32_t CellTiles::at(const Vec3& point) const {
  if (tiles_ == 1) return 0;
  const Vec3 place = into_(point) - corner_;
  const std::uint32_t tile = number_at(index_of(place));
  return tile == none ? nearest_tile(place) : tile;
}

double CellTiles::square_distance(const Index& index, const Vec3& place) const {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double before = along_[a].edge(index[a]) - place[axis],
                 beyond = place[axis] - along_[a].edge(index[a] + 1);
    sum += square(greatest(greatest(before, beyond), 0.0));
  }
  return sum;
}

std::uint32_t CellTiles::nearest_tile(const Vec3& place) const {
  std::uint32_t best = none;
  double least_distance = 0.0;
  const auto consider = [&](const Index& index, std::uint32_t tile) {
    const double distance = square_distance(index, place);
    if (best != none && distance >= least_distance) return;
    best = tile;
    least_distance = distance;
  };
  const Index middle = index_of(place);
  for (std::uint32_t k = 0; k < 27; ++k) {
    const Index index{middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1};
    const std::uint32_t tile = number_at(index);
    if (tile != none) consider(index, tile);
  }
  if (best == none)
    for (const Cell& cell : cells_) consider(cell.index, cell.tile);
  return best;
}

}  // namespace pulvis::measures
