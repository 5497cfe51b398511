// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// What pulls on every parcel at one moment, in the frame the parcels are seen from.
struct ForceField {
  Vec3 gravity;           ///< m/s^2
  bool rotating = false;  ///< whether the frame turns; the rest counts only then
  Vec3 point;             ///< m, on the axis
  Vec3 spin;              ///< Omega, rad/s
  Vec3 spin_rate;         ///< dOmega/dt, rad/s^2

  /// Acceleration by gravity and the centrifugal force at `x`, m/s^2: g - Omega x (Omega x r), r = x - point.
  /// What depends on velocity, and -dOmega/dt x r, are added where velocities change (integrate.cpp); all
  /// after L. D. Landau, E. M. Lifshitz, Mechanics, section 39.
  PULVIS_INLINE Vec3 at(const Vec3& x) const {
    if (!rotating) return gravity;
    return gravity - cross(spin, cross(spin, x - point));
  }
};

/// The accelerations that act on all parcels alike, as functions of time. Gravity may follow a table; the
/// frame may rotate about an axis (the arm of a centrifuge), speeding up evenly in the beginning. The walls
/// then rest in the rotating frame, and gravity turns round in it.
struct BodyForce {
  Vec3 gravity{0, 0, -9.81};    ///< m/s^2; at time 0, in the frame at rest, if there is no table
  std::vector<double> times;    ///< s, ascending; of the table
  std::vector<Vec3> table;      ///< m/s^2 at these times; straight lines between, the ends beyond
  double rotation = 0.0;        ///< full turns per second of the frame; 0: it rests
  double ramp = 0.0;            ///< s in which the rotation grows from 0, evenly
  Vec3 axis{0, 0, 1}, point{};  ///< unit vector; m

  ForceField at(double time) const;
  /// The same, but for dOmega/dt, which is the mean from there to `other` (s): a half step over which the
  /// speeding-up ends then gains what it should.
  ForceField at(double time, double other) const;
  bool rotates() const { return rotation != 0.0; }

 private:
  Vec3 gravity_at_rest(double time) const;
  double share_of_rotation(double time) const { return ramp > 0.0 ? least(time, ramp) / ramp : 1.0; }
};

}  // namespace pulvis
