// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/parcels/domain.hpp"

namespace pulvis {

/// Spheres in and around a region, to ask whether one more would overlap any of them. Knows the images across
/// periodic boundaries.
class OverlapGrid {
 public:
  /// For some `expected` spheres of at most `largest_radius` m, asked about inside [low, high].
  OverlapGrid(const Vec3& low, const Vec3& high, double largest_radius, const Box& domain,
              std::size_t expected);

  void add(const Vec3& centre, double radius);
  bool overlaps(const Vec3& centre, double radius) const;

 private:
  struct Ball {
    Vec3 centre;
    double radius;
  };
  int axis_cell(const Vec3& p, int axis) const;
  void add_image(const Vec3& centre, double radius);

  Vec3 low_, high_, edge_;
  int cells_[3];
  Box domain_;
  std::vector<std::vector<Ball>> cell_;
};

}  // namespace pulvis
