// SPDX-License-Identifier: Apache-2.0
#include "measures/periodic_images.hpp"

namespace pulvis::measures {

std::vector<Sphere> with_periodic_images(std::span<const Sphere> spheres, const Box& domain,
                                         const std::array<bool, 3>& periodic) {
  std::vector<Sphere> all(spheres.begin(), spheres.end());
  for (int axis = 0; axis < 3; ++axis) {
    if (!periodic[static_cast<std::size_t>(axis)]) continue;
    const double length = domain.max[axis] - domain.min[axis];

    // Images made for earlier axes take part: that makes those across edges and corners.
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double place = all[i].centre[axis], radius = all[i].radius;
      if (place - radius < domain.min[axis]) {
        all.push_back(all[i]);
        all.back().centre[axis] = place + length;
      }
      if (place + radius > domain.max[axis]) {
        all.push_back(all[i]);
        all.back().centre[axis] = place - length;
      }
    }
  }
  return all;
}

}  // namespace pulvis::measures
