// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/case.hpp"
#include "run/species.hpp"
#include "single_contact/adhesion.hpp"
#include "single_contact/collision.hpp"

namespace pulvis {

/// A pair of species as the real powder has it, or as it is simulated.
enum class Scale { grain, parcel };

/// One contact of d50 spheres (or of one with a wall) by itself, and what the law makes of it.
struct PairNumbers {
  explicit PairNumbers(const single_contact::Contact& of) : contact(of) {}

  single_contact::Contact contact;
  double radius = 0.0;  ///< m: of the first
  double weight = 0.0;  ///< N: of the first, under the strongest pull of the case
  double load = 0.0;    ///< N: what a contact at the bottom of the bed carries, at least the weight
  /// After that load where the law remembers it; else from rest.
  single_contact::Adhesion adhesion;
  double restitution = 1.0;  ///< asked for; 1 without dashpot
  single_contact::StickingSpeeds undamped_sticking;
  double speed_scale = 0.0;  ///< m/s: about which to look for the sticking speed with damping

  double bond() const { return weight > 0.0 ? adhesion.pull_off / weight : 0.0; }  ///< 0 without gravity
};

/// `bed_stress` (Pa): pressure at the bottom; `speed` (m/s): that of the case's collisions.
PairNumbers pair_numbers(const Case& c, const std::vector<Species>& species, const PairProperties& pair,
                         Scale scale, double bed_stress, double speed);

}  // namespace pulvis
