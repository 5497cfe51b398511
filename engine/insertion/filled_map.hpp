// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/insertion/overlap_grid.hpp"

namespace pulvis {

/// Where the centre of one more sphere surely cannot lie: one bit for each of many small voxels, set if any
/// point of it is too close to a sphere of the grid. Where a region is nearly full, nearly all places drawn
/// are refused; a bit says so without a walk through the cells. It says nothing that the grid would not say.
class FilledMap {
 public:
  /// For spheres of at least `radius` m, with centres inside [low, high].
  FilledMap(const Vec3& low, const Vec3& high, double radius);

  /// Takes in the spheres of the grid from number `begin` on.
  void add(const OverlapGrid& grid, std::size_t begin, int threads);

  bool filled(const Vec3& centre) const;

 private:
  void fill_layers(const Vec3& centre, double reach, std::size_t begin, std::size_t end);
  void fill_row(double x, double half, std::uint64_t* row);

  Vec3 low_;
  double radius_, edge_, per_edge_;  ///< m, m, 1/m
  std::size_t cells_[3], words_;     ///< voxels; words of 64 along x
  std::vector<std::uint64_t> bits_;
};

}  // namespace pulvis
