// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/stroke.hpp"

#include <fmt/format.h>

namespace pulvis::motions {
namespace {

/// One pass, as it comes out: it may be too short for the speed that was asked for.
struct Pass {
  double speed, ramp, duration;

  explicit Pass(const Stroke& s)
      : speed(least(s.speed, root(s.acceleration * s.distance))),
        ramp(speed / s.acceleration),
        duration(s.distance / speed + ramp) {}

  /// The way after the time t, m.
  double way(const Stroke& s, double t) const {
    if (t <= 0.0) return 0.0;
    if (t >= duration) return s.distance;
    if (t < ramp) return 0.5 * s.acceleration * t * t;
    if (t < duration - ramp) return speed * (t - 0.5 * ramp);
    return s.distance - 0.5 * s.acceleration * square(duration - t);
  }
};

}  // namespace

Rigid Stroke::displacement(double t) const {
  const Pass pass(*this);
  const double period = pass.duration + pause;
  const int number = static_cast<int>(least(t / period, passes - 1.0));
  const double way = pass.way(*this, t - number * period);
  return Rigid::translation((number % 2 == 0 ? way : distance - way) * direction);
}

Peaks Stroke::peaks() const { return {.speed = Pass(*this).speed, .acceleration = acceleration}; }

std::optional<double> Stroke::duration() const {
  return passes * Pass(*this).duration + (passes - 1.0) * pause;
}

Fault Stroke::fault() const {
  if (passes < 1) return fmt::format("the passes must be at least 1, but are {}", passes);
  return first_of({unless_above_zero("distance", distance, "m"), unless_unit_vector("direction", direction),
                   unless_above_zero("speed", speed, "m/s"),
                   unless_above_zero("acceleration", acceleration, "m/s^2"),
                   unless_not_negative("pause", pause, "s")});
}

}  // namespace pulvis::motions
