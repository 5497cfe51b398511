// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "case/case.hpp"

namespace pulvis {

/// Acceleration by gravity and the rotating frame in the middle of the domain at a time (s), m/s^2.
inline Vec3 pull_at(const Case& c, double time) {
  return c.body_force.at(time).at(0.5 * (c.domain.min + c.domain.max));
}

/// The largest of them over the run's table of gravity and at full rotation: what falls, falls no faster.
inline Vec3 strongest_pull(const Case& c) {
  Vec3 strongest = pull_at(c, c.body_force.ramp);
  for (const double time : c.body_force.times)
    if (const Vec3 pull = pull_at(c, greatest(time, c.body_force.ramp)); norm(pull) > norm(strongest))
      strongest = pull;
  return strongest;
}

}  // namespace pulvis
