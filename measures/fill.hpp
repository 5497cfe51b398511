// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>

#include "measures/container.hpp"
#include "measures/free_surface.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// What is in the die: the spheres whose centre is inside (powder heaped above it is not).
struct Fill {
  double mass = 0.0;      ///< kg
  std::size_t count = 0;  ///< number of spheres
};

/// Named so that std::fill is no candidate. `masses` (kg) belong to `spheres` one by one;
/// std::invalid_argument if their numbers differ.
Fill fill_inside(std::span<const Sphere> spheres, std::span<const double> masses, const Container& container);

/// How full the die is.
struct FillState {
  double volume = 0.0;  ///< m^3; of the die below the free surface (filled_volume)
  double ratio = 0.0;   ///< -; that over the volume of the die
  double mass = 0.0;    ///< kg; of spheres whose centre is in the die and not above the free surface
  std::optional<double> density;  ///< kg/m^3; apparent density, mass/volume; none in an empty die
};

/// Apparent density counts the bed alone: a sphere that still falls, above the height of its column, adds
/// neither mass nor volume. Spheres count whole by their centre; what the die's rim and the surface cut off
/// on one side comes back on the other in the mean. For the density of a part, see part_porosity.
/// std::invalid_argument if numbers differ or the surface is that of another die.
FillState fill_state(std::span<const Sphere> spheres, std::span<const double> masses,
                     const FreeSurface& surface, const Container& container);

}  // namespace pulvis::measures
