// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "measures/container.hpp"
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

}  // namespace pulvis::measures
