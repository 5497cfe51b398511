// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>

#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// A parcel as mechanics sees it.
struct Body {
  Vec3 position{};       ///< m
  Vec3 velocity{};       ///< m/s
  Vec3 spin{};           ///< rad/s
  double mass = 0.0;     ///< kg
  double inertia = 0.0;  ///< kg m^2, about any axis through the centre (2/5 m r^2 for a solid sphere)
};

/// Mechanical energies, J. Energy stored in contacts is not among them.
struct Energies {
  double translational = 0.0;  ///< sum of m v^2 / 2
  double rotational = 0.0;     ///< sum of I omega^2 / 2
  double potential = 0.0;      ///< sum of -m g . (x - origin)

  double kinetic() const { return translational + rotational; }
};

/// Sums over all bodies, in an order fixed by their places in the list (pairwise).
Energies energies(std::span<const Body> bodies, const Vec3& gravity, const Vec3& origin = {});

}  // namespace pulvis::measures
