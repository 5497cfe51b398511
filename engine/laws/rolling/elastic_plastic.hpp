// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::rolling {

/// Elastic-plastic spring against rolling, without viscous part ("EPSD2").
///
///   T <- P_n (carried T - k_r omega_r dt)     [N m]        (1)
///   k_r = k_t R*^2 = 8 G* a R*^2          [N m/rad]    (2)
///   |T| <= mu_r R* N                      [N m]        (3)
///
/// omega_r is the relative spin without its part along the normal; carried as in total_spring.
///
/// Source     K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285-292,
///            doi:10.1061/(ASCE)0733-9399(1998)124:3(285); J. Ai et al., Powder Technol. 206 (2011) 269-282,
///            doi:10.1016/j.powtec.2010.09.030 (type C); stiffness (2) as in the LIGGGHTS family's epsd2.
/// Symbols    N the limiting normal force (see ContactLaw), mu_r coefficient of rolling friction.
/// Valid      quasi-static rolling of near-round grains; mu_r stands in for shape. Small rocking about rest is not
///            damped.
/// Touch      T = 0. Separation: T is forgotten.
/// Energy     T^2/(2 k_r) stored at fixed k_r; the limit dissipates.
/// Tests      tests/laws/rolling_test.cpp, validation/rolling.cpp, validation/rolling_pile.cpp.
struct ElasticPlastic {
  static constexpr const char* name = "elastic_plastic";
  static constexpr SpringKind spring = SpringKind::force;
  static constexpr bool needs_sizes = false;
  struct Pair {
    double stiffness;  ///< k_t/a, Pa
    double friction;   ///< mu_r, -
  };

  static constexpr std::array parameters{needs::rolling_friction};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness& stiffness) {
    return {stiffness.tangential, pair.rolling_friction};
  }

  /// k_r, N m/rad.
  PULVIS_INLINE static double spring_stiffness(double contact_size, double radius, const Pair& pair) {
    return pair.stiffness * contact_size * square(radius);
  }

  /// The torque as it would be without the limit, N m.
  PULVIS_INLINE static Vec3 trial(const Touch& touch, double contact_size, const Pair& pair,
                                  const Vec3& spring) {
    const double stiffness = pair.stiffness * contact_size * square(touch.radius);
    const Vec3 spin = in_plane(touch.spin, touch.half_normal);
    const Vec3 moved = carried_to_middle(spring, touch) - (stiffness * touch.dt) * spin;
    return in_plane(moved, touch.normal);
  }
  PULVIS_INLINE static Vec3 limited(const Touch& touch, double limiting_force, const Pair& pair,
                                    const Vec3& torque) {
    const double size = norm(torque);
    const double limit = pair.friction * touch.radius * limiting_force;
    return select(size > limit, limit / greatest(size, 1e-300), 1.0) * torque;
  }
  /// Torque on the first, N m; `spring` is the part of it that is remembered, before and after.
  PULVIS_INLINE static Vec3 roll(const Touch& touch, double contact_size, double limiting_force,
                                 const Pair& pair, Vec3& spring) {
    spring = limited(touch, limiting_force, pair, trial(touch, contact_size, pair, spring));
    return spring;
  }
};

/// No resistance to rolling.
struct None {
  static constexpr const char* name = "none";
  static constexpr SpringKind spring = SpringKind::none;
  static constexpr bool needs_sizes = false;
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};
  static Pair mix(const MaterialPair&, const Choices&, const Stiffness&) { return {}; }
  PULVIS_INLINE static Vec3 roll(const Touch&, double, double, const Pair&, Vec3& spring) {
    spring = {};
    return {};
  }
};

}  // namespace pulvis::laws::rolling
