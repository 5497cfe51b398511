// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/overlap_grid.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis {

OverlapGrid::OverlapGrid(const Vec3& low, const Vec3& high, double largest_radius, const Box& domain,
                         std::size_t expected)
    : domain_(domain) {
  // Spheres whose centres lie up to one radius outside the region can still overlap one inside.
  const Vec3 rim{largest_radius, largest_radius, largest_radius};
  low_ = low - rim;
  high_ = high + rim;
  // A mostly empty region needs no more cells than a few per sphere.
  const Vec3 extent = high_ - low_;
  const double most = 4.0 * static_cast<double>(expected) + 4096.0;
  const double edge = std::max(2.0 * largest_radius, std::cbrt(extent.x * extent.y * extent.z / most));
  std::size_t total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double length = high_[axis] - low_[axis];
    cells_[axis] = std::clamp(static_cast<int>(length / edge), 1, 1024);
    edge_[axis] = length / cells_[axis];
    total *= static_cast<std::size_t>(cells_[axis]);
  }
  cell_.resize(total);
}

int OverlapGrid::axis_cell(const Vec3& p, int axis) const {
  const int k = static_cast<int>((p[axis] - low_[axis]) / edge_[axis]);
  return std::clamp(k, 0, cells_[axis] - 1);
}

void OverlapGrid::add(const Vec3& centre, double radius) {
  int count[3];
  double shift[3][3];
  for (int axis = 0; axis < 3; ++axis) {
    const double length = domain_.max[axis] - domain_.min[axis];
    count[axis] = domain_.periodic[axis] ? 3 : 1;
    shift[axis][0] = 0.0;
    shift[axis][1] = length;
    shift[axis][2] = -length;
  }
  for (int i = 0; i < count[0]; ++i)
    for (int j = 0; j < count[1]; ++j)
      for (int k = 0; k < count[2]; ++k)
        add_image(centre + Vec3{shift[0][i], shift[1][j], shift[2][k]}, radius);
}

void OverlapGrid::add_image(const Vec3& c, double radius) {
  for (int axis = 0; axis < 3; ++axis)
    if (c[axis] < low_[axis] || c[axis] > high_[axis]) return;
  const auto index = (static_cast<std::size_t>(axis_cell(c, 2)) * static_cast<std::size_t>(cells_[1]) +
                      static_cast<std::size_t>(axis_cell(c, 1))) *
                         static_cast<std::size_t>(cells_[0]) +
                     static_cast<std::size_t>(axis_cell(c, 0));
  cell_[index].push_back({c, radius});
}

bool OverlapGrid::overlaps(const Vec3& centre, double radius) const {
  int from[3], to[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = std::max(axis_cell(centre, axis) - 1, 0);
    to[axis] = std::min(axis_cell(centre, axis) + 1, cells_[axis] - 1);
  }
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j)
      for (int i = from[0]; i <= to[0]; ++i) {
        const auto index = (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells_[1]) +
                            static_cast<std::size_t>(j)) *
                               static_cast<std::size_t>(cells_[0]) +
                           static_cast<std::size_t>(i);
        for (const Ball& b : cell_[index]) {
          const Vec3 d = b.centre - centre;
          if (dot(d, d) < square(b.radius + radius)) return true;
        }
      }
  return false;
}

}  // namespace pulvis
