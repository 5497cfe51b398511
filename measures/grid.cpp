// SPDX-License-Identifier: Apache-2.0
#include "measures/grid.hpp"

#include <fmt/format.h>

#include "engine/base/failure.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {

Division::Division(double length, double edge) : length_(length) {
  constexpr double most = 1e6;  // parts along one axis: finer than the parcels of any die that fits in memory
  const double wanted = std::max(1.0, std::round(length / edge));
  if (!(edge > 0.0 && length > 0.0 && wanted <= most))
    throw Failure(
        Exit::bad_case,
        fmt::format("cannot divide {} m of the die into parts of {} m: their size must be above zero "
                    "and not too small for the die",
                    length, edge));
  count_ = static_cast<std::size_t>(wanted);
  part_ = length / wanted;
}

void check_spheres(std::span<const Sphere> spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Vec3& centre = spheres[i].centre;
    if (!std::isfinite(centre.x + centre.y + centre.z + spheres[i].radius))
      throw Failure(Exit::physics, fmt::format("sphere {} has a centre or radius that is not finite", i));
  }
}

double mean_diameter(std::span<const Sphere> spheres) {
  if (spheres.empty()) return 0.0;
  const double sum = pairwise_sum(spheres.size(), [&](std::size_t i) { return 2.0 * spheres[i].radius; });
  return sum / static_cast<double>(spheres.size());
}

}  // namespace pulvis::measures
