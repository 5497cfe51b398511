// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <concepts>

#include "engine/laws/parts.hpp"

namespace pulvis::laws {

template <class Part>
concept HasPair = requires(const MaterialPair& pair, const Choices& choices) {
  { Part::name } -> std::convertible_to<const char*>;
  { Part::mix(pair, choices) } -> std::same_as<typename Part::Pair>;
};
template <class Part>
concept NormalLaw = HasPair<Part> && requires(double x, const typename Part::Pair& pair) {
  { Part::normal(x, x, pair) } -> std::same_as<Normal>;
  { Part::separation_gap(x, pair) } -> std::same_as<double>;
};

/// A contact law put together from its parts at compile time. The same law acts between parcels and on
/// walls.
///
///   v_n = v . n_h  (closing speed),  v_t = v - v_n n_h               mid-step
///   F_n = F_elastic + c_n v_n
///   N   = |F_elastic + shift|            limit "elastic" (default), or
///         |F_elastic + shift + c_n v_n|  limit "total" (as LIGGGHTS): limits friction and rolling
///   force on the first = -F_n n + F_t
///
/// Why "elastic": the dashpot's impulse over a collision vanishes, so gross sliding gets the friction
/// impulse mu m v_n (1 + e) only with the force that has no dashpot in it.
template <NormalLaw NormalPart, HasPair DampingPart, HasPair SlidingPart, HasPair RollingPart>
struct ContactLaw {
  using NormalType = NormalPart;
  using DampingType = DampingPart;
  using SlidingType = SlidingPart;
  using RollingType = RollingPart;

  struct Pair {
    typename NormalPart::Pair normal;
    typename DampingPart::Pair damping;
    typename SlidingPart::Pair sliding;
    typename RollingPart::Pair rolling;
    double dashpot_in_limit;  ///< 1: limit "total", 0: "elastic"
  };

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    return {NormalPart::mix(pair, choices), DampingPart::mix(pair, choices), SlidingPart::mix(pair, choices),
            RollingPart::mix(pair, choices), choices.limit_includes_dashpot ? 1.0 : 0.0};
  }

  PULVIS_INLINE static Response evaluate(const Touch& touch, const History& old, const Pair& pair) {
    // A contact begins at zero gap and, once begun, lasts to the law's separation gap.
    const double gap = NormalPart::separation_gap(touch.radius, pair.normal);
    const double lowest = select(touch.was_touching > 0.5, -gap, 0.0);
    const double touching = select(touch.overlap > lowest, 1.0, 0.0);

    const Normal normal = NormalPart::normal(touch.overlap, touch.radius, pair.normal);
    const auto damping = DampingPart::coefficients(normal, touch.mass, pair.damping);

    const double closing = dot(touch.velocity, touch.half_normal);
    const Vec3 slip_velocity = touch.velocity - closing * touch.half_normal;
    const double dashpot = damping.normal * closing;
    const double force = normal.elastic + dashpot;
    const double limiting = magnitude(normal.elastic + normal.limit_shift + pair.dashpot_in_limit * dashpot);

    Vec3 spring = old.slide;
    const Vec3 tangential = SlidingPart::slide(touch, slip_velocity, normal.contact_radius, limiting,
                                               damping.tangential, pair.sliding, spring);
    const Vec3 torque = RollingPart::roll(touch, normal.contact_radius, limiting, old.roll, pair.rolling);

    return {touching,
            touching * (tangential - force * touch.normal),
            touching * tangential,
            touching * torque,
            {touching * spring, touching * torque}};
  }
};

}  // namespace pulvis::laws
