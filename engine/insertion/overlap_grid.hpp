// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/parcels/domain.hpp"

namespace pulvis {

/// Spheres in and around a region, to ask whether one more would overlap any of them. Knows the images across
/// periodic boundaries. The answers do not depend on the order in which spheres were added, and any number of
/// threads may ask while none adds.
class OverlapGrid {
 public:
  /// For some `expected` spheres of at most `largest_radius` m, asked about inside [low, high].
  OverlapGrid(const Vec3& low, const Vec3& high, double largest_radius, const Box& domain,
              std::size_t expected);

  void add(const Vec3& centre, double radius);
  /// Whether a sphere overlaps one that was added when there were `since` or more.
  bool overlaps(const Vec3& centre, double radius, std::size_t since = 0) const;

  /// Spheres in the grid, images included, in the order in which they were added.
  std::size_t size() const { return ball_.size(); }
  const Vec3& centre(std::size_t k) const { return ball_[k].centre; }
  double radius(std::size_t k) const { return ball_[k].radius; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Ball {
    Vec3 centre;
    double radius;
  };
  /// Spheres of about one size, in cells of about their diameter: small spheres among large ones would crowd
  /// cells made for the large. Lists of a cell are chained, so that there is one array and no sorting.
  struct Level {
    double largest_radius = 0.0;
    double cells_per_metre[3] = {0, 0, 0};
    int cells[3] = {0, 0, 0};
    std::vector<std::uint32_t> first;  ///< ball of each cell, or none; empty while the level is

    int cell(double from_low, int axis) const;
    std::size_t index(int i, int j, int k) const;
  };

  Level& level_for(double radius);
  void add_image(Level& level, const Vec3& centre, double radius);
  bool overlaps_in(const Level& level, const Vec3& centre, double radius, std::size_t since) const;

  Vec3 low_, high_;
  std::size_t expected_;
  Box domain_;
  std::vector<Level> level_;  ///< each of half the radius of the one before
  std::vector<Ball> ball_;
  std::vector<std::uint32_t> next_;  ///< ball in the same cell
};

}  // namespace pulvis
