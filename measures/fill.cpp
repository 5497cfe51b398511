// SPDX-License-Identifier: Apache-2.0
#include "measures/fill.hpp"

#include <algorithm>
#include <stdexcept>

#include "measures/sum.hpp"

namespace pulvis::measures {

Fill fill_inside(std::span<const Sphere> spheres, std::span<const double> masses,
                 const Container& container) {
  if (spheres.size() != masses.size())
    throw std::invalid_argument("fill_inside: there must be one mass for each sphere");
  const auto inside = [&](const Sphere& sphere) { return is_inside(container, sphere.centre); };
  const auto mass_inside = [&](std::size_t i) { return inside(spheres[i]) ? masses[i] : 0.0; };
  return {.mass = pairwise_sum(spheres.size(), mass_inside),
          .count = static_cast<std::size_t>(std::count_if(spheres.begin(), spheres.end(), inside))};
}

FillState fill_state(std::span<const Sphere> spheres, std::span<const double> masses,
                     const FreeSurface& surface, const Container& container) {
  if (spheres.size() != masses.size())
    throw std::invalid_argument("fill_state: there must be one mass for each sphere");
  const DieFrame frame(container);
  FillState state;
  state.volume = filled_volume(surface, container);
  state.ratio = state.volume / volume(container);
  state.mass = pairwise_sum(spheres.size(), [&](std::size_t i) {
    if (!is_inside(container, spheres[i].centre)) return 0.0;
    const Vec3 at = frame.to_local(spheres[i].centre);
    return at.z <= surface.height(surface.along_first.at(at.x), surface.along_second.at(at.y)) ? masses[i]
                                                                                               : 0.0;
  });
  if (state.volume > 0.0) state.density = state.mass / state.volume;
  return state;
}

}  // namespace pulvis::measures
