// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "measures/stress.hpp"

// Beds whose contact forces, and so stresses, are known on paper.
namespace pulvis::measures::packings {

struct PressedBed {
  std::vector<Particle> parcels;
  std::vector<PairForce> pairs;
  std::vector<WallForce> walls;
};

/// Spheres of unit mass and diameter d in a cubic lattice of n along each axis, between six plates: the chain
/// along axis a carries the force of its plates, pressure[a] d^2, in each contact. With `weight` (N, each
/// parcel's, downwards) the contacts and the floor below carry that of the parcels above them too.
inline PressedBed pressed_bed(std::uint32_t n, double d, const Vec3& pressure, double weight = 0.0) {
  PressedBed bed;
  const auto place = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) { return i + n * (j + n * k); };
  for (std::uint32_t k = 0; k < n; ++k)
    for (std::uint32_t j = 0; j < n; ++j)
      for (std::uint32_t i = 0; i < n; ++i) {
        bed.parcels.push_back({{(i + 0.5) * d, (j + 0.5) * d, (k + 0.5) * d}, {}, 1.0, 0.5 * d});
        const std::uint32_t here = place(i, j, k), at[3] = {i, j, k};
        const std::uint32_t next[3] = {place(i + 1, j, k), place(i, j + 1, k), place(i, j, k + 1)};
        for (int axis = 0; axis < 3; ++axis) {
          const double force = pressure[axis] * d * d;
          const auto along = [&](double length) {
            Vec3 v;
            v[axis] = length;
            return v;
          };
          const double above = axis == 2 ? weight : 0.0;  // of each parcel above
          if (at[axis] == 0) bed.walls.push_back({here, along(force + above * n), along(0.5 * d)});
          if (at[axis] + 1 == n)
            bed.walls.push_back({here, along(-force), along(-0.5 * d)});
          else
            bed.pairs.push_back({here, next[axis], along(-force - above * (n - 1 - at[axis])), along(-d)});
        }
      }
  return bed;
}

}  // namespace pulvis::measures::packings
