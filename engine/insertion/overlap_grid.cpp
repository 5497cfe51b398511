// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/overlap_grid.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis {

OverlapGrid::OverlapGrid(const Vec3& low, const Vec3& high, double largest_radius, const Box& domain,
                         std::size_t expected)
    : low_(low), high_(high), expected_(expected), domain_(domain) {
  constexpr std::size_t most_levels = 16;
  level_.resize(most_levels);
  for (Level& level : level_) {
    level.largest_radius = largest_radius;
    largest_radius *= 0.5;
  }
  ball_.reserve(expected);
  next_.reserve(expected);
}

/// Clamped, so that what sticks into the region from outside is found in the cells at its rim.
int OverlapGrid::Level::cell(double from_low, int axis) const {
  return static_cast<int>(std::clamp(from_low * cells_per_metre[axis], 0.0, cells[axis] - 1.0));
}

std::size_t OverlapGrid::Level::index(int i, int j, int k) const {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells[1]) + static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(cells[0]) +
         static_cast<std::size_t>(i);
}

OverlapGrid::Level& OverlapGrid::level_for(double radius) {
  std::size_t k = 0;
  while (k + 1 < level_.size() && radius <= level_[k + 1].largest_radius) ++k;
  Level& level = level_[k];
  if (!level.first.empty()) return level;
  // A mostly empty region needs no more cells than a few per sphere.
  const Vec3 extent = high_ - low_;
  const double most = 4.0 * static_cast<double>(expected_) + 4096.0;
  const double edge = std::max(2.0 * level.largest_radius, std::cbrt(extent.x * extent.y * extent.z / most));
  std::size_t total = 1;
  for (int axis = 0; axis < 3; ++axis) {
    level.cells[axis] = std::clamp(static_cast<int>(extent[axis] / edge), 1, 1024);
    level.cells_per_metre[axis] = level.cells[axis] / extent[axis];
    total *= static_cast<std::size_t>(level.cells[axis]);
  }
  level.first.assign(total, none);
  return level;
}

void OverlapGrid::add(const Vec3& centre, double radius) {
  // Along each axis, the places of the sphere and its images that reach into the region.
  double at[3][3];
  int count[3] = {0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const double length = domain_.periodic[axis] ? domain_.max[axis] - domain_.min[axis] : 0.0;
    for (const double shift : {0.0, length, -length}) {
      const double x = centre[axis] + shift;
      if (x > low_[axis] - radius && x < high_[axis] + radius) at[axis][count[axis]++] = x;
      if (length == 0.0) break;
    }
  }
  if (count[0] * count[1] * count[2] == 0) return;
  Level& level = level_for(radius);
  for (int i = 0; i < count[0]; ++i)
    for (int j = 0; j < count[1]; ++j)
      for (int k = 0; k < count[2]; ++k) add_image(level, {at[0][i], at[1][j], at[2][k]}, radius);
}

void OverlapGrid::add_image(Level& level, const Vec3& c, double radius) {
  const Vec3 d = c - low_;
  std::uint32_t& first = level.first[level.index(level.cell(d.x, 0), level.cell(d.y, 1), level.cell(d.z, 2))];
  next_.push_back(first);
  first = static_cast<std::uint32_t>(ball_.size());
  ball_.push_back({c, radius});
}

bool OverlapGrid::overlaps(const Vec3& centre, double radius, std::size_t since) const {
  for (const Level& level : level_)
    if (!level.first.empty() && overlaps_in(level, centre, radius, since)) return true;
  return false;
}

bool OverlapGrid::overlaps_in(const Level& level, const Vec3& centre, double radius,
                              std::size_t since) const {
  const auto any_in = [&](std::uint32_t first) {
    // The last added comes first.
    for (std::uint32_t b = first; b != none && b >= since; b = next_[b]) {
      const Vec3 apart = ball_[b].centre - centre;
      if (dot(apart, apart) < square(ball_[b].radius + radius)) return true;
    }
    return false;
  };
  const Vec3 d = centre - low_;
  // Most of what overlaps lies in the same cell.
  if (any_in(level.first[level.index(level.cell(d.x, 0), level.cell(d.y, 1), level.cell(d.z, 2))]))
    return true;
  int from[3], to[3];
  const double reach = radius + level.largest_radius;
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = level.cell(d[axis] - reach, axis);
    to[axis] = level.cell(d[axis] + reach, axis);
  }
  for (int k = from[2]; k <= to[2]; ++k)
    for (int j = from[1]; j <= to[1]; ++j) {
      const std::uint32_t* row = &level.first[level.index(0, j, k)];
      for (int i = from[0]; i <= to[0]; ++i)
        if (any_in(row[i])) return true;
    }
  return false;
}

}  // namespace pulvis
