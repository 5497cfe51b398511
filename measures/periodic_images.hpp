// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "measures/shapes.hpp"

namespace pulvis::measures {

/// The spheres, followed by the images of those that reach across a face of the domain.
struct PeriodicImages {
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> original;  ///< place in the list of what it is an image of; a sphere's own place
};

/// The spheres, followed by the images of those that reach across a face of `domain` along an axis where
/// space is periodic: then each part of a sphere that sticks out of the domain is there once more on the
/// other side. Only for measures of volume (porosity): images are no parcels, so do not count them or their
/// contacts.
PeriodicImages periodic_images(std::span<const Sphere> spheres, const Box& domain,
                               const std::array<bool, 3>& periodic);

}  // namespace pulvis::measures
