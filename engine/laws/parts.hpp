// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "engine/laws/material_pair.hpp"
#include "engine/math/vec3.hpp"

// What the parts of a contact law are given and what they return. A part is a stateless struct with
// static functions: it never sees a parcel, a wall, a list, a thread or a file. See NOTATION for signs.
namespace pulvis::laws {

/// Two bodies in contact, seen at the end of a step. `first` is the one with the lower id, or the parcel
/// at a wall; the normal points from the first to the second.
struct Touch {
  double overlap;            ///< delta, m; negative: gap
  double radius;             ///< R*, m; 1/R* = 1/R_i + 1/R_j, a flat wall has 1/R = 0
  double mass;               ///< m*, kg; a wall has infinite mass
  double was_touching;       ///< 1 if the contact existed at the end of the step before, else 0
  Vec3 normal;               ///< n at the end of the step, unit vector
  Vec3 half_normal;          ///< n_h in the middle of the step, unit vector
  Vec3 velocity;             ///< of the first against the second at the contact, mid-step, m/s
  Vec3 spin;                 ///< omega_first - omega_second, mid-step, rad/s
  double dt;                 ///< s
  double shared_spin = 0.0;  ///< (omega_first + omega_second) . n_h/2, rad/s
  // For parts that say so (needs_sizes); a wall has zeros here.
  double radius_first = 0.0, radius_second = 0.0;  ///< m
  double mass_first = 0.0, mass_second = 0.0;      ///< kg
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
  double secant;         ///< F_n/delta; Hertz: (4/3) E*
  double damping_shape;  ///< f in c = -2 f beta sqrt(S m*); Hertz: sqrt(5/6), linear: 1
};

/// Coefficients of the dashpots, kg/s.
struct Dashpots {
  double normal, tangential;
};

/// Energy that a contact stores, J, against bodies that do not touch.
struct Stored {
  double elastic;   ///< of normal deformation
  double cohesive;  ///< of surfaces that stick together; negative
};

/// How a spring of the sliding, rolling or twisting law is remembered.
enum class SpringKind {
  none,          ///< there is none: all of the law's work is lost
  displacement,  ///< its length: the force follows the stiffness
  force,         ///< its force
  shrinking      ///< its force, which shrinks with the stiffness of an opening contact
};

/// What a law of cohesion adds to a normal law that knows none.
struct Attraction {
  double pull;                                ///< N, positive pulls together
  double pull_off;                            ///< N: the pull at the moment of touch; 0 if the law knows none
  double viscous_normal, viscous_tangential;  ///< kg/s: of a liquid between the surfaces
};

/// What a contact remembers from step to step; what each number means is up to the law.
struct Past {
  Vec3 slide;             ///< tangential spring of the sliding law, m or N
  Vec3 roll;              ///< N m: torques of the rolling law and, along the normal, of the twisting law
  double plastic = 0.0;   ///< of the normal law
  double adhesion = 0.0;  ///< of the normal law
  double grip = 0.0;      ///< of the sliding law
};

// How it is stored: most laws need the springs only, and a list of contacts is read and written in every step.
struct History {
  Vec3 slide, roll;
};
struct Memory {
  double plastic = 0.0, adhesion = 0.0, grip = 0.0;
};

/// Result of a law. A contact that does not exist gives zeros, also in its history.
struct Response {
  double touching;   ///< 1 or 0
  Vec3 force;        ///< on the first, N; the second gets the opposite
  Vec3 tangential;   ///< the part of `force` from sliding, N
  Vec3 drag;         ///< the tangential part of `force` from a liquid between the surfaces, N
  Vec3 roll_torque;  ///< on the first, N m; the second gets the opposite
  Past history;
};

/// Component of `a` in the plane with unit normal `n`.
PULVIS_INLINE Vec3 in_plane(const Vec3& a, const Vec3& n) { return a - dot(a, n) * n; }

/// A vector of the contact plane of the step before, taken along to the middle of this one: projected, and turned
/// there by the spin the two bodies share about the normal, so that springs turn with bodies that spin
/// together. With t = w dt/2 the turn has the cosine 1 - 2 t^2 (1 - t^2) and the sine 2 t (1 - t^2): no division,
/// off by t^3 in the angle, and shorter by 2 t^6 only.
PULVIS_INLINE Vec3 carried_to_middle(const Vec3& a, const Touch& touch) {
  const Vec3 v = in_plane(a, touch.half_normal);
  const double t = least(greatest(0.5 * touch.shared_spin * touch.dt, -1.0), 1.0);
  const double rest = 1.0 - t * t;
  return (1.0 - 2.0 * t * t * rest) * v + (2.0 * t * rest) * cross(touch.half_normal, v);
}

/// 1/I_r = 1/I_i + 1/I_j with I = 1.4 m R^2, kg m^2: two spheres that roll about their contact.
PULVIS_INLINE double rolling_inertia(const Touch& touch) {
  const double first = 1.4 * touch.mass_first * square(touch.radius_first);
  const double second = 1.4 * touch.mass_second * square(touch.radius_second);
  return select(second > 0.0, first * second / greatest(first + second, 1e-300), first);
}

}  // namespace pulvis::laws
