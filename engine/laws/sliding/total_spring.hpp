// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::sliding {

/// Tangential spring in its total-displacement form, with dashpot while it sticks and Coulomb's limit.
///
///   xi <- carried xi + v_t dt, then xi <- P_n xi  [m]   (1)
///   k_t = 8 G* a (linear laws: a share of k_n)     [N/m] (2)
///   stick, k_t |xi| <= mu N:  F_t = -k_t xi - c_t v_t  [N]   (3)
///   slip:  |xi| is reset to mu N/k_t and F_t = -k_t xi [N]   (4)
///
/// "Carried" projects on the contact plane in the middle of the step and turns with the spin both bodies share
/// about the normal (carried_to_middle in parts.hpp), P_n projects on the plane at its end, v_t is the mid-step
/// velocity in the mid-step plane: the spring never mixes two instants (velocities synchronised after
/// D. R. Vyas et al., Comput. Phys. Commun. 310 (2025) 109524, doi:10.1016/j.cpc.2025.109524).
///
/// Source     (2) R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973 (compliance without
///            slip); (1), (3), (4) after P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47-65,
///            doi:10.1680/geot.1979.29.1.47.
/// Symbols    N the limiting normal force (see ContactLaw), mu Coulomb's coefficient, c_t from the damping law.
/// Valid      no micro-slip: stick is one spring. The spring follows the whole displacement, so F_t changes
///            with k_t when the contact opens or closes.
/// Touch      xi = 0. Separation: xi is forgotten.
/// Energy     k_t xi^2/2 stored at fixed k_t; slip and dashpot dissipate.
/// Tests      tests/laws/sliding_test.cpp, tests/verification/incline_test.cpp,
///            validation/chung_ooi.cpp.
struct TotalSpring {
  static constexpr const char* name = "total_spring";
  static constexpr SpringKind spring = SpringKind::displacement;
  static constexpr bool remembers_grip = false;
  struct Pair {
    double stiffness;  ///< k_t/a, Pa
    double friction;   ///< mu, -
  };

  static constexpr std::array parameters{needs::coulomb_friction};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness& stiffness) {
    return {stiffness.tangential, pair.friction};
  }

  /// k_t, N/m.
  PULVIS_INLINE static double spring_stiffness(double contact_size, const Pair& pair) {
    return pair.stiffness * contact_size;
  }

  /// The spring as it would be without the limit, m.
  PULVIS_INLINE static Vec3 trial(const Touch& touch, const Vec3& slip_velocity, const Vec3& xi) {
    return in_plane(carried_to_middle(xi, touch) + touch.dt * slip_velocity, touch.normal);
  }
  /// Force on the first, N; `xi` is the spring, m, before and after the limit.
  PULVIS_INLINE static Vec3 limited(const Touch& touch, const Vec3& slip_velocity, double contact_size,
                                    double limiting_force, double dashpot, const Pair& pair, Vec3& xi) {
    const Vec3 spring = xi;
    const double stiffness = pair.stiffness * contact_size;
    const double trial = stiffness * norm(spring);
    const double limit = pair.friction * limiting_force;
    const bool slips = trial > limit;
    const double scale = select(slips, limit / greatest(trial, 1e-300), 1.0);
    const double damping = select(slips, 0.0, dashpot);
    xi = scale * spring;
    return -(stiffness * xi) - damping * in_plane(slip_velocity, touch.normal);
  }
  /// Force on the first, N; `xi` is the spring, m, before and after.
  PULVIS_INLINE static Vec3 slide(const Touch& touch, const Vec3& slip_velocity, double contact_size,
                                  double limiting_force, double dashpot, const Pair& pair, Vec3& xi,
                                  double& /*grip*/) {
    xi = trial(touch, slip_velocity, xi);
    return limited(touch, slip_velocity, contact_size, limiting_force, dashpot, pair, xi);
  }
};

/// Frictionless.
struct None {
  static constexpr const char* name = "none";
  static constexpr SpringKind spring = SpringKind::none;
  static constexpr bool remembers_grip = false;
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};
  static Pair mix(const MaterialPair&, const Choices&, const Stiffness&) { return {}; }
  PULVIS_INLINE static Vec3 slide(const Touch&, const Vec3&, double, double, double, const Pair&, Vec3& xi,
                                  double&) {
    xi = {};
    return {};
  }
};

}  // namespace pulvis::laws::sliding
