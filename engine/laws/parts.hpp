// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

// What the parts of a contact law are given and what they return. A part is a stateless struct with
// static functions: it never sees a parcel, a wall, a list, a thread or a file. See NOTATION for signs.
namespace pulvis::laws {

/// Material properties of a pair, mixed once per pair of species. SI.
struct MaterialPair {
  double effective_modulus = 0.0;        ///< E*, Pa: 1/E* = (1-nu_i^2)/E_i + (1-nu_j^2)/E_j
  double effective_shear_modulus = 0.0;  ///< G*, Pa: 1/G* = 2(2-nu_i)(1+nu_i)/E_i + 2(2-nu_j)(1+nu_j)/E_j
  double work_of_adhesion = 0.0;         ///< W, J/m^2
  double restitution = 1.0;              ///< e, -
  double friction = 0.0;                 ///< mu, -
  double rolling_friction = 0.0;         ///< mu_r, -
};

/// Named choices of a law that change a formula, not the set of parts.
struct Choices {
  bool limit_includes_dashpot = false;  ///< friction_limit = "total" instead of "elastic"
  bool damping_on_jkr_radius = false;   ///< damping_radius = "jkr_radius" instead of "hertz"
};

/// Two bodies in contact, seen at the end of a step. `first` is the one with the lower id, or the parcel
/// at a wall; the normal points from the first to the second.
struct Touch {
  double overlap;       ///< delta, m; negative: gap
  double radius;        ///< R*, m; 1/R* = 1/R_i + 1/R_j, a flat wall has 1/R = 0
  double mass;          ///< m*, kg; a wall has infinite mass
  double was_touching;  ///< 1 if the contact existed at the end of the step before, else 0
  Vec3 normal;          ///< n at the end of the step, unit vector
  Vec3 half_normal;     ///< n in the middle of the step, unit vector
  Vec3 velocity;        ///< of the first against the second at the contact, mid-step, m/s
  Vec3 spin;            ///< omega_first - omega_second, mid-step, rad/s
  double dt;            ///< s
};

/// Normal law: force without dashpot, and the sizes that stiffnesses are proportional to.
struct Normal {
  double elastic;       ///< F_n, N; positive pushes apart
  double contact_size;  ///< a, m (linear laws: k_n, N/m); stiffnesses are those of `Stiffness` times it
  double damping_size;  ///< the same for dashpots; Hertz, JKR: sqrt(R* delta); 0 without overlap
  double limit_shift;   ///< N; added to F_n before it limits friction and rolling
};

/// Stiffnesses of a normal law over its contact size, Pa (linear laws: without unit).
struct Stiffness {
  double normal;         ///< S_n = dF_n/d(delta); Hertz: 2 E*
  double tangential;     ///< k_t; Hertz: 8 G*
  double damping_shape;  ///< f in c = -2 f beta sqrt(S m*); Hertz: sqrt(5/6), linear: 1
};

/// Coefficients of the dashpots, kg/s.
struct Dashpots {
  double normal, tangential;
};

/// What a contact remembers from step to step.
struct History {
  Vec3 slide;  ///< xi, m: tangential spring of the sliding law
  Vec3 roll;   ///< N m: torque of the rolling law on the first
};

/// Result of a law. A contact that does not exist gives zeros, also in its history.
struct Response {
  double touching;   ///< 1 or 0
  Vec3 force;        ///< on the first, N; the second gets the opposite
  Vec3 tangential;   ///< the tangential part of `force`, N
  Vec3 roll_torque;  ///< on the first, N m; the second gets the opposite
  History history;
};

/// Component of `a` in the plane with unit normal `n`.
PULVIS_INLINE Vec3 in_plane(const Vec3& a, const Vec3& n) { return a - dot(a, n) * n; }

}  // namespace pulvis::laws
