// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
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

  std::size_t rattlers = 0;                     ///< spheres with fewer than four contacts, walls counted
  std::optional<double> rattler_share;          ///< -; of the spheres; none without spheres
  std::optional<double> mean_without_rattlers;  ///< contacts, walls counted; none if all are rattlers
};

/// Contacts below which a sphere counts as a rattler: without friction, four are the fewest that hold a sphere
/// in its place (3 directions + 1, as contacts that only push cannot pull back).
constexpr std::uint32_t rattler_contacts = 4;

/// A contact between two spheres in the die counts for both of them; one between a sphere in the die and one
/// outside counts for the first. `wall_contacts` has the place of the sphere once for each wall it touches.
///
/// Rattlers carry little of the load. Without them: sum of the contacts, with spheres and walls, of the spheres
/// with at least four, over their number, so never below 4; contacts with rattlers stay counted (nothing is
/// taken away twice). Own definition, in the manner of the corrected coordination number of the literature on
/// isotropic packings without walls.
/// Throws std::out_of_range for a place that is not in the list of spheres.
Coordination coordination(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts, const Container& container);

/// The same over the spheres with a non-zero `counted` instead of those in a die, e.g. those in a part of it
/// (centres_in_part in porosity_parts.hpp).
Coordination coordination(std::span<const std::uint8_t> counted, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts);

}  // namespace pulvis::measures
