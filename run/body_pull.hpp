// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/case.hpp"

namespace pulvis {

/// Acceleration by gravity and the rotating frame in the middle of the domain at a time (s), m/s^2.
inline Vec3 pull_at(const Case& c, double time) {
  return c.body_force.at(time).at(0.5 * (c.domain.min + c.domain.max));
}

/// Against the pull in the middle of the domain, a unit vector; z where there is none.
inline Vec3 up_at(const Case& c, double time) {
  const Vec3 pull = pull_at(c, time);
  return norm(pull) > 0.0 ? -pull / norm(pull) : Vec3{0, 0, 1};
}

/// Bound on the acceleration of what falls anywhere in the domain at any time, in the direction it has in the
/// middle of the domain.
inline Vec3 strongest_pull(const Case& c) {
  const BodyForce& force = c.body_force;
  Vec3 strongest = pull_at(c, force.ramp);
  double gravity = force.times.empty() ? norm(force.gravity) : 0.0;
  for (const Vec3& at : force.table) gravity = greatest(gravity, norm(at));
  for (const double time : force.times)
    if (const Vec3 pull = pull_at(c, time); norm(pull) > norm(strongest)) strongest = pull;
  if (!force.rotates()) return strongest;
  double farthest = 0.0;
  for (unsigned k = 0; k < 8; ++k) {
    const Vec3 corner{k & 1u ? c.domain.max.x : c.domain.min.x, k & 2u ? c.domain.max.y : c.domain.min.y,
                      k & 4u ? c.domain.max.z : c.domain.min.z};
    const Vec3 arm = corner - force.point;
    farthest = greatest(farthest, norm(arm - dot(arm, force.axis) * force.axis));
  }
  const double bound = gravity + square(2.0 * pi * force.rotation) * farthest;
  return norm(strongest) > 0.0 ? (bound / norm(strongest)) * strongest : Vec3{0, 0, -bound};
}

}  // namespace pulvis
