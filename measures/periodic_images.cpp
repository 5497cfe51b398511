// SPDX-License-Identifier: Apache-2.0
#include "measures/periodic_images.hpp"

#include <numeric>

namespace pulvis::measures {

PeriodicImages periodic_images(std::span<const Sphere> spheres, const Box& domain,
                               const std::array<bool, 3>& periodic) {
  PeriodicImages all{{spheres.begin(), spheres.end()}, std::vector<std::uint32_t>(spheres.size())};
  std::iota(all.original.begin(), all.original.end(), 0u);
  const auto add = [&](std::size_t i, int axis, double place) {
    all.spheres.push_back(all.spheres[i]);
    all.spheres.back().centre[axis] = place;
    all.original.push_back(all.original[i]);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!periodic[static_cast<std::size_t>(axis)]) continue;
    const double length = domain.max[axis] - domain.min[axis];

    // Images made for earlier axes take part: that makes those across edges and corners.
    const std::size_t count = all.spheres.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double place = all.spheres[i].centre[axis], radius = all.spheres[i].radius;
      if (place - radius < domain.min[axis]) add(i, axis, place + length);
      if (place + radius > domain.max[axis]) add(i, axis, place - length);
    }
  }
  return all;
}

}  // namespace pulvis::measures
