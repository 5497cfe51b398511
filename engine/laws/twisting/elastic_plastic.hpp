// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::twisting {

/// Elastic-plastic spring against twisting: relative spin about the normal.
///
///   T_k <- T_k - k_w omega_n dt,  |T_k| <= mu_w R* N              [N m]        (1)
///   k_w = k_t R*^2,  c_w = c_t R*^2                    [N m/rad], [N m s]      (2)
///   T = T_k - c_w omega_n while |T_k| < mu_w R* N, else T = T_k                (3)
///
/// (2) is the spring and dashpot of sliding at the lever R*. Without the dashpot nothing would damp a sphere on a
/// floor: its spin about the normal moves no other spring.
///
/// Source     the rolling spring of K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285-292,
///            doi:10.1061/(ASCE)0733-9399(1998)124:3(285), put about the normal; (2) is our choice, that of
///            rolling/elastic_plastic. S. Luding, Granul. Matter 10 (2008) 235-246,
///            doi:10.1007/s10035-008-0099-x, has such a torsion spring too.
/// Symbols    N the limiting normal force (see ContactLaw), mu_w coefficient of twisting friction, omega_n part of
///            the relative spin along the normal, c_t from the damping law.
/// Valid      mu_w stands in for the shape of grains; a smooth contact circle of radius a has (3 pi/16) mu a/R*
///            under Hertz's pressure, (2/3) mu a/R* under an even one.
/// Touch      T_k = 0. Separation: T_k is forgotten.
/// Energy     T_k^2/(2 k_w) stored at fixed k_w; limit and dashpot dissipate.
/// Tests      tests/laws/rolling_test.cpp, tests/laws/parts_test.cpp, validation/rolling_pile.cpp.
struct ElasticPlastic {
  static constexpr const char* name = "elastic_plastic";
  static constexpr bool acts = true;
  struct Pair {
    double stiffness;  ///< k_t over the contact size
    double friction;   ///< mu_w, -
  };
  static constexpr std::array parameters{
      Parameter{"twisting_friction", &MaterialPair::twisting_friction, 0.0, 10.0, "-", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness& stiffness) {
    return {stiffness.tangential, pair.twisting_friction};
  }

  /// k_w, N m/rad.
  PULVIS_INLINE static double spring_stiffness(double contact_size, double radius, const Pair& pair) {
    return pair.stiffness * contact_size * square(radius);
  }

  /// Torque about the normal on the first, N m; `spring` is the part of it that is remembered, before and after.
  PULVIS_INLINE static double twist(const Touch& touch, double contact_size, double limiting_force,
                                    double dashpot, const Pair& pair, double& spring) {
    const double stiffness = pair.stiffness * contact_size * square(touch.radius);
    const double spin = dot(touch.spin, touch.half_normal);
    const double torque = spring - (stiffness * touch.dt) * spin;
    const double limit = pair.friction * touch.radius * limiting_force;
    const bool yields = magnitude(torque) > limit;
    spring = least(greatest(torque, -limit), limit);
    return spring - select(yields, 0.0, dashpot * square(touch.radius)) * spin;
  }
};

/// No resistance to twisting.
struct None {
  static constexpr const char* name = "none";
  static constexpr bool acts = false;
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};
  static Pair mix(const MaterialPair&, const Choices&, const Stiffness&) { return {}; }
  PULVIS_INLINE static double twist(const Touch&, double, double, double, const Pair&, double& spring) {
    spring = 0.0;
    return 0.0;
  }
};

}  // namespace pulvis::laws::twisting
