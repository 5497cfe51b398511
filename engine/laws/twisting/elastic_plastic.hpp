// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::twisting {

/// Elastic-plastic spring against twisting: relative spin about the normal.
///
///   T <- T - k_w omega_n dt,  |T| <= mu_w R* N      [N m]        (1)
///   k_w = k_t R*^2                                  [N m/rad]    (2)
///
/// Source     the rolling spring of K. Iwashita, M. Oda, J. Eng. Mech. 124 (1998) 285-292,
///            doi:10.1061/(ASCE)0733-9399(1998)124:3(285), put about the normal; (2) is our choice, that of
///            rolling/elastic_plastic. S. Luding, Granul. Matter 10 (2008) 235-246,
///            doi:10.1007/s10035-008-0099-x, has such a torsion spring too.
/// Symbols    N the limiting normal force (see ContactLaw), mu_w coefficient of twisting friction, omega_n part of
///            the relative spin along the normal.
/// Valid      mu_w stands in for the shape of grains; a smooth contact circle of radius a has (3 pi/16) mu a/R*
///            under Hertz's pressure, (2/3) mu a/R* under an even one.
/// Touch      T = 0. Separation: T is forgotten.
/// Energy     T^2/(2 k_w) stored at fixed k_w; the limit dissipates.
/// Tests      tests/laws/rolling_test.cpp.
struct ElasticPlastic {
  static constexpr const char* name = "elastic_plastic";
  static constexpr bool acts = true;
  struct Pair {
    double stiffness;  ///< k_t over the contact size
    double friction;   ///< mu_w, -
  };
  static constexpr std::array parameters{
      Parameter{"twisting_friction", &MaterialPair::twisting_friction, 0.0, 10.0, "-"}};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness& stiffness) {
    return {stiffness.tangential, pair.twisting_friction};
  }

  /// Torque about the normal on the first, N m; it is its own history.
  PULVIS_INLINE static double twist(const Touch& touch, double contact_size, double limiting_force,
                                    double old_torque, const Pair& pair) {
    const double stiffness = pair.stiffness * contact_size * square(touch.radius);
    const double torque = old_torque - (stiffness * touch.dt) * dot(touch.spin, touch.half_normal);
    const double limit = pair.friction * touch.radius * limiting_force;
    return least(greatest(torque, -limit), limit);
  }
};

/// No resistance to twisting.
struct None {
  static constexpr const char* name = "none";
  static constexpr bool acts = false;
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};
  static Pair mix(const MaterialPair&, const Choices&, const Stiffness&) { return {}; }
  PULVIS_INLINE static double twist(const Touch&, double, double, double, const Pair&) { return 0.0; }
};

}  // namespace pulvis::laws::twisting
