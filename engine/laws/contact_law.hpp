// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <concepts>

#include "engine/laws/parts.hpp"

// How the parts of a contact law work together. The same law acts between parcels and on walls.
//
//   v_n = v . n_h  (closing speed),  v_t = v - v_n n_h               mid-step
//   F_n = F_elastic + F_d - F_c + c_b v_n      F_c, c_b: pull and viscosity of the law of cohesion
//   F_d = c_n v_n/(1 + c_n dt/(4 m*))          see dashpot_force
//   N   = |F_elastic + shift + limit|              limits friction and rolling
//   limit "elastic" (default): 0;  "total" (as LIGGGHTS): F_d
//   with cohesion "without": nothing more; "with": - F_c; "shifted": - F_c + 2 F_po
//   force on the first = -F_n n + F_t
//
// Why "elastic": the dashpot's impulse over a collision vanishes, so gross sliding gets the friction
// impulse mu m v_n (1 + e) only with the force that has no dashpot in it. What a normal law with adhesion of its
// own does is in its `shift`.
//
// The parts are evaluated one after the other (reach of cohesion, normal, damping, cohesion, sliding, rolling and
// twisting, viscous drag of cohesion), each for a whole block of contacts, with what stands between them in
// arrays: so the program holds code for the sum of all parts, not for every combination.
namespace pulvis::laws {

template <class Part>
concept NamedPart = requires {
  { Part::name } -> std::convertible_to<const char*>;
  Part::parameters.size();
};

template <class Part>
concept NormalPart = NamedPart<Part> &&
    requires(double x, const typename Part::Pair& pair, const MaterialPair& material, const Choices& choices,
             const Touch& touch) {
  { Part::mix(material, choices) } -> std::same_as<typename Part::Pair>;
  { Part::stiffness(material, choices) } -> std::same_as<Stiffness>;
  { Part::normal(touch, pair, x, x) } -> std::same_as<Normal>;
  { Part::separation_gap(x, pair) } -> std::same_as<double>;
  { Part::adhesive } -> std::convertible_to<bool>;  // has cohesion of its own
};

template <class Part>
concept CohesionPart = NamedPart<Part> &&
    requires(double x, const typename Part::Pair& pair, const MaterialPair& material, const Choices& choices,
             const Touch& touch) {
  { Part::mix(material, choices) } -> std::same_as<typename Part::Pair>;
  { Part::attraction(touch, pair) } -> std::same_as<Attraction>;
  { Part::separation_gap(touch, pair) } -> std::same_as<double>;
  { Part::formation_gap(touch, pair) } -> std::same_as<double>;
  { Part::longest_gap(x, pair) } -> std::same_as<double>;  // bound for all pairs up to a radius
  { Part::acts_on_approach(pair) } -> std::same_as<bool>;
  { Part::standard_limit } -> std::convertible_to<CohesionLimit>;
};

/// A part that is mixed after the normal law and may ask for its stiffness.
template <class Part>
concept FollowingPart = NamedPart<Part> &&
    requires(const MaterialPair& material, const Choices& choices, const Stiffness& stiffness) {
  { Part::mix(material, choices, stiffness) } -> std::same_as<typename Part::Pair>;
};

/// Constants that belong to no part.
struct Whole {
  double dashpot_in_limit;   ///< 1: limit "total", 0: "elastic"
  double pull_in_limit;      ///< 1: F_c is taken off, 0: not
  double pull_off_in_limit;  ///< how many F_po are added
};

/// 1 where a contact exists now, else 0: it begins at one gap and, once begun, lasts to another.
PULVIS_INLINE double touches(double overlap, double was_touching, double formation_gap,
                             double separation_gap) {
  const double lowest = select(was_touching > 0.5, -separation_gap, -formation_gap);
  return select(overlap > lowest, 1.0, 0.0);
}

/// Closing speed, m/s.
PULVIS_INLINE double closing_speed(const Touch& touch) { return dot(touch.velocity, touch.half_normal); }

/// Force of the normal dashpot, N:  c v_n/(1 + c dt/(4 m*)).
/// v_n is half a step old. By that alone a damped oscillator gains a factor (1 + c dt/(2 m*)) in its damping and,
/// since the spring pulled meanwhile, in its stiffness: in its damping ratio the root of it. The divisor takes that
/// back to first order in dt, so that collisions show the restitution asked for; at rest it changes nothing.
PULVIS_INLINE double dashpot_force(double coefficient, double closing, const Touch& touch) {
  return coefficient * closing * touch.mass / (touch.mass + 0.25 * touch.dt * coefficient);
}

/// Tangential velocity in the contact plane in the middle of the step, m/s.
PULVIS_INLINE Vec3 slip_velocity(const Touch& touch, double closing) {
  return touch.velocity - closing * touch.half_normal;
}

/// Normal force that limits friction and rolling, N, before its magnitude is taken.
PULVIS_INLINE double limiting_force(const Normal& normal, double dashpot_force, const Whole& whole) {
  return normal.elastic + normal.limit_shift + whole.dashpot_in_limit * dashpot_force;
}

/// The same with cohesion. Bodies that are drawn to each other across a gap do not rub.
PULVIS_INLINE double limiting_force(double limit, double contact_size, const Attraction& a,
                                    const Whole& whole) {
  const double all = limit - whole.pull_in_limit * a.pull + whole.pull_off_in_limit * a.pull_off;
  return select(contact_size > 0.0, all, 0.0);
}

/// Viscous force of a liquid between the surfaces on the first, N.
PULVIS_INLINE Vec3 drag_force(const Vec3& slip, const Vec3& normal, double viscous) {
  return -viscous * in_plane(slip, normal);
}

/// The contact normal a step ago: the one now, reflected about that in the middle of the step.
PULVIS_INLINE Vec3 normal_before(const Vec3& normal, const Vec3& half_normal) {
  return 2.0 * dot(normal, half_normal) * half_normal - normal;
}

}  // namespace pulvis::laws
