// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/walls/surface.hpp"
#include "measures/wall_tile.hpp"

namespace pulvis::measures {

/// Tiles of a rectangle: an even grid along its sides. u and v count from its centre.
class RectangleTiles {
 public:
  RectangleTiles(const Surface& s, double edge)
      : centre_(s.centre),
        normal_(s.normal),
        side_{s.side[0], s.side[1]},
        half_{s.half[0], s.half[1]},
        along_{evenly(2.0 * s.half[0], edge), evenly(2.0 * s.half[1], edge)} {}

  /// All tiles, in the order of their numbers.
  void append_to(std::vector<WallTile>& tiles, std::uint32_t surface) const {
    const double area = along_[0].part() * along_[1].part();
    for (std::size_t j = 0; j < along_[1].count(); ++j)
      for (std::size_t i = 0; i < along_[0].count(); ++i) {
        const double u = middle(0, i), v = middle(1, j);
        tiles.push_back({surface, area, centre_ + u * side_[0] + v * side_[1], normal_, u, v});
      }
  }

  /// Number of the tile that a point on or near the rectangle belongs to.
  std::uint32_t at(const Vec3& point) const {
    const Vec3 from_centre = point - centre_;
    const std::size_t i = along_[0].at(dot(from_centre, side_[0]) + half_[0]);
    const std::size_t j = along_[1].at(dot(from_centre, side_[1]) + half_[1]);
    return static_cast<std::uint32_t>(i + along_[0].count() * j);
  }

 private:
  double middle(int direction, std::size_t i) const {
    const Division& along = along_[direction];
    return 0.5 * (along.edge(i) + along.edge(i + 1)) - half_[direction];
  }

  Vec3 centre_, normal_, side_[2];
  double half_[2];
  Division along_[2];
};

}  // namespace pulvis::measures
