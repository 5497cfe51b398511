// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <concepts>

#include "engine/laws/parts.hpp"

// How the parts of a contact law work together. The same law acts between parcels and on walls.
//
//   v_n = v . n_h  (closing speed),  v_t = v - v_n n_h               mid-step
//   F_n = F_elastic + c_n v_n
//   N   = |F_elastic + shift|            limit "elastic" (default), or
//         |F_elastic + shift + c_n v_n|  limit "total" (as LIGGGHTS): limits friction and rolling
//   force on the first = -F_n n + F_t
//
// Why "elastic": the dashpot's impulse over a collision vanishes, so gross sliding gets the friction
// impulse mu m v_n (1 + e) only with the force that has no dashpot in it.
//
// The parts are evaluated one after the other (normal, damping, sliding, rolling), each for a whole block of
// contacts, with what stands between them in arrays: so the program holds code for the sum of all parts, not
// for every combination.
namespace pulvis::laws {

template <class Part>
concept NormalPart = requires(double x, const typename Part::Pair& pair, const MaterialPair& material,
                              const Choices& choices) {
  { Part::name } -> std::convertible_to<const char*>;
  { Part::mix(material, choices) } -> std::same_as<typename Part::Pair>;
  { Part::stiffness(material) } -> std::same_as<Stiffness>;
  { Part::normal(x, x, pair) } -> std::same_as<Normal>;
  { Part::separation_gap(x, pair) } -> std::same_as<double>;
};

/// A part that is mixed after the normal law and may ask for its stiffness.
template <class Part>
concept FollowingPart = requires(const MaterialPair& material, const Choices& choices,
                                 const Stiffness& stiffness) {
  { Part::name } -> std::convertible_to<const char*>;
  { Part::mix(material, choices, stiffness) } -> std::same_as<typename Part::Pair>;
};

/// Constants that belong to no part.
struct Whole {
  double dashpot_in_limit;  ///< 1: limit "total", 0: "elastic"
};

/// 1 where the contact exists now, else 0: it begins at zero gap and, once begun, lasts to the law's
/// separation gap.
PULVIS_INLINE double touches(double overlap, double was_touching, double separation_gap) {
  const double lowest = select(was_touching > 0.5, -separation_gap, 0.0);
  return select(overlap > lowest, 1.0, 0.0);
}

/// Closing speed, m/s.
PULVIS_INLINE double closing_speed(const Touch& touch) { return dot(touch.velocity, touch.half_normal); }

/// Tangential velocity in the contact plane in the middle of the step, m/s.
PULVIS_INLINE Vec3 slip_velocity(const Touch& touch, double closing) {
  return touch.velocity - closing * touch.half_normal;
}

/// Normal force that limits friction and rolling, N.
PULVIS_INLINE double limiting_force(const Normal& normal, double dashpot_force, const Whole& whole) {
  return magnitude(normal.elastic + normal.limit_shift + whole.dashpot_in_limit * dashpot_force);
}

}  // namespace pulvis::laws
