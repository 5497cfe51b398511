// SPDX-License-Identifier: Apache-2.0
#include "measures/near_points.hpp"

#include <numeric>

namespace pulvis::measures {
namespace {

Box box_around(std::span<const Vec3> points, double margin) {
  Box box{points[0], points[0]};
  for (const Vec3& point : points)
    for (int a = 0; a < 3; ++a) {
      box.min[a] = least(box.min[a], point[a]);
      box.max[a] = greatest(box.max[a], point[a]);
    }
  const Vec3 arm{margin, margin, margin};
  return {box.min - arm, box.max + arm};
}

bool holds(const Box& box, const Vec3& point) {
  for (int a = 0; a < 3; ++a)
    if (!(box.min[a] <= point[a] && point[a] <= box.max[a])) return false;
  return true;
}

}  // namespace

NearPoints::NearPoints(std::span<const Vec3> items, std::span<const Vec3> points, double reach) {
  if (points.empty()) return;
  const Box box = box_around(points, reach);
  origin_ = box.min;
  const Vec3 size = box.max - box.min;
  std::size_t count = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    // A hundred cells along each axis are enough: a million in all. Rounding to the nearest whole number
    // could make cells narrower than the reach, so what is given is what divides the length.
    const double length = size[static_cast<int>(a)];
    const double parts = std::clamp(std::floor(length / (reach * (1.0 + 1e-9))), 1.0, 100.0);
    along_[a] = Division(length, length / parts);
    count *= along_[a].count();
  }
  begin_.assign(count + 1, 0);
  for (const Vec3& item : items)
    if (holds(box, item)) ++begin_[cell_of(item) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  entries_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (holds(box, items[i])) entries_[next[cell_of(items[i])]++] = static_cast<std::uint32_t>(i);
}

std::size_t NearPoints::cell_of(const Vec3& place) const {
  const Vec3 local = place - origin_;
  return along_[0].at(local.x) +
         along_[0].count() * (along_[1].at(local.y) + along_[1].count() * along_[2].at(local.z));
}

}  // namespace pulvis::measures
