// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/rotation.hpp"

namespace pulvis::motions {

Rigid Rotation::displacement(double t) const {
  const double cycles = t < ramp ? rate * (t * t / (2.0 * ramp)) : rate * (t - 0.5 * ramp);
  return Rigid::rotation(cycles, point, axis);
}

Peaks Rotation::peaks() const {
  const double full = 2.0 * pi * magnitude(rate);
  return {.rate = full, .angular_acceleration = ramp > 0.0 ? full / ramp : 0.0, .point = point, .axis = axis};
}

std::optional<double> Rotation::cycle() const {
  if (rate == 0.0) return std::nullopt;
  return 1.0 / magnitude(rate);
}

Fault Rotation::fault() const {
  return first_of({unless_finite("point", point), unless_unit_vector("axis", axis),
                   unless_finite("rate", rate), unless_not_negative("ramp", ramp, "s")});
}

}  // namespace pulvis::motions
