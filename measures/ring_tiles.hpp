// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/walls/surface.hpp"
#include "measures/grid.hpp"
#include "measures/wall_tile.hpp"

namespace pulvis::measures {

/// Tiles of a surface of revolution (disc, ring, mantle of a cylinder or cone, sphere): even rings along its
/// meridian, each divided into as many sectors as are at least `edge` wide at the ring's mean radius.
/// On the map, v runs along the meridian (from the lower end, the inner rim or the lower pole) and u is the
/// angle, counter-clockwise from perpendicular(axis), times the ring's mean radius.
class RingTiles {
 public:
  RingTiles(const Surface& surface, double edge);

  /// All tiles, in the order of their numbers; `surface` is what they shall have as such.
  void append_to(std::vector<WallTile>& tiles, std::uint32_t surface) const;

  /// Number of the tile that a point on or near the surface belongs to.
  std::uint32_t at(const Vec3& point) const;

 private:
  /// What lies between two ways along the meridian, as means over its area.
  struct Band {
    double area = 0.0;                               ///< m^2
    double mean_radius = 0.0;                        ///< m; area over 2 pi times width
    double centre_radius = 0.0, centre_along = 0.0;  ///< m; mean distance from the axis, and along it
    double normal_across = 0.0, normal_along = 0.0;  ///< mean normal, away from and along the axis
  };
  struct Ring {
    std::uint32_t first = 0, sectors = 1;
  };
  Band band(double from, double to) const;
  Band straight_band(double from, double to) const;
  Band round_band(double from, double to) const;
  double way(double distance, double along) const;

  Surface::Kind kind_;
  Vec3 centre_, axis_, ahead_, aside_;  ///< the two last: where the angle is 0 and a quarter turn
  double radius_ = 0.0;                 ///< m; where the meridian begins, or of the sphere
  double out_ = 0.0, up_ = 1.0;         ///< direction of a straight meridian, away from and along the axis
  Division along_;
  std::vector<Ring> rings_;
};

}  // namespace pulvis::measures
