// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Contacts per sphere, over the spheres whose centre lies in the die.
struct Coordination {
  std::size_t spheres = 0;             ///< number of spheres in the die
  std::optional<double> mean;          ///< contacts with other spheres per sphere; none without spheres
  std::optional<double> mean_walls;    ///< contacts with walls per sphere; none without spheres
  std::vector<std::size_t> histogram;  ///< [k]: spheres with k contacts with others; up to the largest k
};

/// A contact between two spheres in the die counts for both of them; one between a sphere in the die and one
/// outside counts for the first. `wall_contacts` has the place of the sphere once for each wall it touches.
/// Throws std::out_of_range for a place that is not in the list of spheres.
Coordination coordination(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts, const Container& container);

}  // namespace pulvis::measures
