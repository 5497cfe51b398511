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

  /// Acceleration at `x` that does not depend on velocity, m/s^2:
  ///   g - Omega x (Omega x r) - dOmega/dt x r,  r = x - point
  /// (gravity, centrifugal and Euler acceleration; L. D. Landau, E. M. Lifshitz, Mechanics, section 39).
  PULVIS_INLINE Vec3 at(const Vec3& x) const {
    if (!rotating) return gravity;
    const Vec3 r = x - point;
    return gravity - cross(spin, cross(spin, r)) - cross(spin_rate, r);
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
  bool rotates() const { return rotation != 0.0; }

 private:
  Vec3 gravity_at_rest(double time) const;
};

}  // namespace pulvis
