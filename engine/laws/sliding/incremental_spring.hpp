// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::sliding {

/// Tangential spring that adds up its force, with dashpot while it sticks and Coulomb's limit.
///
///   F <- carried F - k_t v_t dt                          [N]   (1)
///   k_t = 8 G* a (linear laws: a share of k_n)           [N/m] (2)
///   stick, |F| <= mu N:  F_t = F - c_t v_t               [N]   (3)
///   slip:  F is reset to length mu N and F_t = F         [N]   (4)
///
/// "Carried" is carried_along in parts.hpp: projected on the contact planes in the middle and at the end of
/// the step, and turned by the spin both bodies share about the normal. The dashpot never enters F, so the
/// result does not depend on the time step.
///
/// Source     P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47-65, doi:10.1680/geot.1979.29.1.47;
///            (2) R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268, doi:10.1115/1.4009973 (compliance without
///            slip).
/// Symbols    N the limiting normal force (see ContactLaw), mu Coulomb's coefficient, c_t from the damping law.
/// Valid      as the total spring; an opening contact keeps its force until Coulomb's limit cuts it, which
///            can give energy back that was never put in (see rescaled_spring).
/// Touch      F = 0. Separation: F is forgotten.
/// Energy     F^2/(2 k_t) stored at fixed k_t; slip and dashpot dissipate.
/// Tests      tests/laws/sliding_test.cpp.
struct IncrementalSpring {
  static constexpr const char* name = "incremental_spring";
  static constexpr SpringKind spring = SpringKind::force;
  static constexpr bool remembers_grip = false;
  struct Pair {
    double stiffness;  ///< k_t over the contact size
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

  /// Force on the first, N; `spring` is the spring's force, N, before and after.
  PULVIS_INLINE static Vec3 slide(const Touch& touch, const Vec3& slip_velocity, double contact_size,
                                  double limiting_force, double dashpot, const Pair& pair, Vec3& spring,
                                  double& /*grip*/) {
    const double step = pair.stiffness * contact_size * touch.dt;
    const Vec3 force = in_plane(carried_to_middle(spring, touch) - step * slip_velocity, touch.normal);
    const double trial = norm(force), limit = pair.friction * limiting_force;
    const bool slips = trial > limit;
    spring = select(slips, limit / greatest(trial, 1e-300), 1.0) * force;
    return spring - select(slips, 0.0, dashpot) * in_plane(slip_velocity, touch.normal);
  }
};

}  // namespace pulvis::laws::sliding
