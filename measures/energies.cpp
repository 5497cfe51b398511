// SPDX-License-Identifier: Apache-2.0
#include "measures/energies.hpp"

#include "measures/sum.hpp"

namespace pulvis::measures {

Energies energies(std::span<const Body> bodies, const Vec3& gravity, const Vec3& origin) {
  const auto sum = [&](const auto& energy_of) {
    return pairwise_sum(bodies.size(), [&](std::size_t i) { return energy_of(bodies[i]); });
  };
  return {
      .translational = sum([](const Body& b) { return 0.5 * b.mass * dot(b.velocity, b.velocity); }),
      .rotational = sum([](const Body& b) { return 0.5 * b.inertia * dot(b.spin, b.spin); }),
      .potential = sum([&](const Body& b) { return -b.mass * dot(gravity, b.position - origin); }),
  };
}

}  // namespace pulvis::measures
