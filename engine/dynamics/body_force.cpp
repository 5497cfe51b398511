// SPDX-License-Identifier: Apache-2.0
#include "engine/dynamics/body_force.hpp"

#include <algorithm>

#include "engine/math/rigid.hpp"

namespace pulvis {

Vec3 BodyForce::gravity_at_rest(double time) const {
  if (times.empty()) return gravity;
  if (time <= times.front()) return table.front();
  if (time >= times.back()) return table.back();
  const auto after =
      static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const double share = (time - times[after - 1]) / (times[after] - times[after - 1]);
  return table[after - 1] + share * (table[after] - table[after - 1]);
}

ForceField BodyForce::at(double time) const {
  ForceField field;
  field.gravity = gravity_at_rest(time);
  if (!rotates()) return field;
  field.rotating = true;
  field.point = point;
  // Turns so far: even speeding-up, then constant rotation.
  const double ramped = least(time, ramp);
  const double turns =
      (ramp > 0.0 ? rotation * square(ramped) / (2.0 * ramp) : 0.0) + rotation * (time - ramped);
  field.gravity = Rigid::rotation(-turns, {}, axis).turn(field.gravity);
  const double full = 2.0 * pi * rotation;
  field.spin = (full * share_of_rotation(time)) * axis;
  if (time < ramp) field.spin_rate = (full / ramp) * axis;
  return field;
}

ForceField BodyForce::at(double time, double other) const {
  ForceField field = at(time);
  if (field.rotating && ramp > 0.0)
    field.spin_rate =
        (2.0 * pi * rotation * (share_of_rotation(other) - share_of_rotation(time)) / (other - time)) * axis;
  return field;
}

}  // namespace pulvis
