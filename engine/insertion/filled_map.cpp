// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/filled_map.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

constexpr double voxels_per_radius = 2.0;
constexpr double most_voxels = 1e9;      // 125 MB
constexpr double cautious = 1.0 - 1e-9;  // rounding must not fill a voxel that is just free

std::size_t clamped(double x, std::size_t cells) {
  return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(cells) - 1.0));
}

}  // namespace

FilledMap::FilledMap(const Vec3& low, const Vec3& high, double radius) : low_(low), radius_(radius) {
  const Vec3 extent = high - low;
  edge_ = std::max(radius / voxels_per_radius, std::cbrt(extent.x * extent.y * extent.z / most_voxels));
  per_edge_ = 1.0 / edge_;
  for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<std::size_t>(extent[axis] / edge_) + 1;
  words_ = (cells_[0] + 63) / 64;
  bits_.assign(words_ * cells_[1] * cells_[2], 0);
}

void FilledMap::add(const OverlapGrid& grid, std::size_t begin, int threads) {
  // By layers of voxels, so that no two threads write to one word.
  parallel_shares(cells_[2], cells_[2] < 4 ? 1 : threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t b = begin; b < grid.size(); ++b)
      fill_layers(grid.centre(b) - low_, cautious * (grid.radius(b) + radius_), from, to);
  });
}

/// Fills the voxels of these layers all of whose corners lie within reach of the centre.
void FilledMap::fill_layers(const Vec3& c, double reach, std::size_t begin, std::size_t end) {
  if (c.z + reach < static_cast<double>(begin) * edge_ || c.z - reach > static_cast<double>(end) * edge_)
    return;
  // The farther face of a voxel, squared.
  const auto farther = [&](std::size_t cell, double x) {
    const double near = static_cast<double>(cell) * edge_ - x;
    return square(std::max(std::abs(near), std::abs(near + edge_)));
  };
  const std::size_t last = std::min(clamped((c.z + reach) / edge_, cells_[2]) + 1, end);
  const std::size_t from = clamped((c.y - reach) / edge_, cells_[1]),
                    to = clamped((c.y + reach) / edge_, cells_[1]);
  for (std::size_t k = std::max(clamped((c.z - reach) / edge_, cells_[2]), begin); k < last; ++k) {
    const double left = square(reach) - farther(k, c.z);
    if (left <= 0.0) continue;
    for (std::size_t j = from; j <= to; ++j)
      if (const double rest = left - farther(j, c.y); rest > 0.0)
        fill_row(c.x, root(rest), &bits_[(k * cells_[1] + j) * words_]);
  }
}

/// Fills the voxels of a row that lie in [x - half, x + half] as a whole.
void FilledMap::fill_row(double x, double half, std::uint64_t* row) {
  const double from = std::max((x - half) / edge_ + 1.0, 0.0);
  const double to = std::min((x + half) / edge_, static_cast<double>(cells_[0]));
  if (from >= to) return;
  auto first = static_cast<std::size_t>(from);
  const auto end = static_cast<std::size_t>(to);
  while (first < end) {
    const std::size_t word = first / 64, stop = std::min(end, 64 * (word + 1));
    row[word] |= (~std::uint64_t{0} >> (64 - (stop - first))) << (first % 64);
    first = stop;
  }
}

bool FilledMap::filled(const Vec3& centre) const {
  const Vec3 d = centre - low_;
  const std::size_t i = clamped(d.x * per_edge_, cells_[0]), j = clamped(d.y * per_edge_, cells_[1]),
                    k = clamped(d.z * per_edge_, cells_[2]);
  return bits_[(k * cells_[1] + j) * words_ + i / 64] >> (i % 64) & 1;
}

}  // namespace pulvis
