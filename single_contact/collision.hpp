// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "single_contact/contact.hpp"

namespace pulvis::single_contact {

/// A head-on collision of two free bodies.
struct Collision {
  bool sticks = false;           ///< they come back after a rebound, or stay
  bool is_crushed = false;       ///< overlaps of a radius were reached; the rest means nothing
  double restitution = 0.0;      ///< speed of leaving over that of approach; 0 if they stick
  double largest_overlap = 0.0;  ///< m
  double duration = 0.0;         ///< s, from first touch or formation to separation or to being back
};

/// Integrates the law from first touch (or from where a bridge or tail begins) at a closing speed (m/s), by the
/// engine's own rule (velocity Verlet, dashpots by the mid-step velocity). With overlap, steps are a thousandth of
/// the contact's duration at most; everywhere they are so short that the change of force in one shifts the kinetic
/// energy by less than 1e-4 of it. The restitution of damped collisions is then exact to 0.5 %.
Collision collide(const Contact& contact, double speed);

/// The same at a fixed time step (s), as a run has it: contacts are seen, and end, between steps. First touch lies in
/// the middle of a step.
Collision collide(const Contact& contact, double speed, double step);

/// Speeds at which collisions stick, m/s: those between the two. Laws that yield may stick in a band only.
struct StickingSpeeds {
  double lowest = 0.0;   ///< 0 where the slowest collisions stick
  double highest = 0.0;  ///< 0 if none sticks, infinite if all do that do not crush the bodies
};

/// Without damping and memory they follow from the work that a touch loses, m* v_s^2/2; else collisions are tried,
/// from 4096 times `reference` (m/s; a speed that matters for the contact) down to as small a part of it, each half
/// the one before, and the boundaries are halved down to 1e-4. Of several bands it is the fastest.
StickingSpeeds sticking_speeds(const Contact& contact, double reference);

}  // namespace pulvis::single_contact
