// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::rolling {

/// Elastic-plastic spring against rolling with a viscous part below its limit ("EPSD").
///
///   T_k <- P_n (carried T_k - k_r omega_r dt),  |T_k| <= mu_r R* N     [N m]      (1)
///   k_r = 2.25 k_n mu_r^2 R*^2                                      [N m/rad]  (2)
///   C_r = 2 eta_r sqrt(I_r k_r)                                     [N m s]    (3)
///   T = T_k - C_r omega_r while |T_k| < mu_r R* N, else T = T_k                (4)
///
/// k_n is the secant stiffness F_n/delta of the normal law (Hertz: (4/3) E* a) and
/// 1/I_r = 1/(1.4 m_i R_i^2) + 1/(1.4 m_j R_j^2); a wall counts as infinitely heavy.
///
/// Source     J. Ai et al., Powder Technol. 206 (2011) 269-282, doi:10.1016/j.powtec.2010.09.030 (type C);
///            the factor 2.25 for spheres, I_r and f = 0 at the limit as in the LIGGGHTS family's epsd, whose
///            documentation quotes 2.25 from there.
/// Symbols    N the limiting normal force (see ContactLaw), eta_r rolling viscosity.
/// Valid      as elastic_plastic; eta_r damps small rocking about rest.
/// Touch      T_k = 0. Separation: T_k is forgotten.
/// Energy     T_k^2/(2 k_r) stored at fixed k_r; the rest dissipates.
/// Tests      tests/laws/rolling_test.cpp, validation/rolling.cpp.
struct ElasticPlasticViscous {
  static constexpr const char* name = "elastic_plastic_viscous";
  static constexpr SpringKind spring = SpringKind::force;
  static constexpr bool needs_sizes = true;
  struct Pair {
    double stiffness;  ///< 2.25 k_n mu_r^2 over the contact size
    double viscosity;  ///< 2 eta_r, -
    double friction;   ///< mu_r, -
  };
  static constexpr std::array parameters{
      needs::rolling_friction,
      Parameter{"rolling_viscosity", &MaterialPair::rolling_viscosity, 0.0, 10.0, "-", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness& stiffness) {
    return {2.25 * stiffness.secant * square(pair.rolling_friction), 2.0 * pair.rolling_viscosity,
            pair.rolling_friction};
  }

  /// k_r, N m/rad.
  PULVIS_INLINE static double spring_stiffness(double contact_size, double radius, const Pair& pair) {
    return pair.stiffness * contact_size * square(radius);
  }

  PULVIS_INLINE static Vec3 roll(const Touch& touch, double contact_size, double limiting_force,
                                 const Pair& pair, Vec3& spring) {
    const double stiffness = pair.stiffness * contact_size * square(touch.radius);
    const Vec3 spin = in_plane(touch.spin, touch.half_normal);
    const Vec3 moved = carried_to_middle(spring, touch) - (stiffness * touch.dt) * spin;
    const Vec3 torque = in_plane(moved, touch.normal);
    const double size = norm(torque), limit = pair.friction * touch.radius * limiting_force;
    const bool yields = size >= limit;
    spring = select(yields, limit / greatest(size, 1e-300), 1.0) * torque;
    const double viscosity = pair.viscosity * root(rolling_inertia(touch) * stiffness);
    return spring - select(yields, 0.0, viscosity) * in_plane(spin, touch.normal);
  }
};

}  // namespace pulvis::laws::rolling
