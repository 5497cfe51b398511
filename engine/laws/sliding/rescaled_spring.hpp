// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::sliding {

/// Incremental spring whose force shrinks with the stiffness of an opening contact (Thornton).
///
///   F <- carried F * min(1, a/a_before) - k_t v_t dt     [N]   (1)
///   k_t = 8 G* a (linear laws: a share of k_n)           [N/m] (2)
///   stick, |F| <= mu N:  F_t = F - c_t v_t               [N]   (3)
///   slip:  F is reset to length mu N and F_t = F         [N]   (4)
///
/// a_before is the contact size at the end of the step before. Carried as in incremental_spring.
///
/// Source     C. Thornton, S. J. Cummins, P. W. Cleary, Powder Technol. 233 (2013) 30-46,
///            doi:10.1016/j.powtec.2012.08.012, eq. 18b (the rescaling on unloading; in LAMMPS
///            "mindlin_rescale/force"); (2) R. D. Mindlin, J. Appl. Mech. 16 (1949) 259-268,
///            doi:10.1115/1.4009973.
/// Symbols    N the limiting normal force (see ContactLaw), mu Coulomb's coefficient, c_t from the damping law.
/// Valid      no micro-slip. With linear normal laws a is k_n and stays, so this is the incremental spring.
/// Touch      F = 0. Separation: F is forgotten.
/// Energy     loading adds none and unloading gives none back that was not put in; slip and dashpot dissipate.
/// Tests      tests/laws/sliding_test.cpp.
struct RescaledSpring {
  static constexpr const char* name = "rescaled_spring";
  static constexpr SpringKind spring = SpringKind::shrinking;
  static constexpr bool remembers_grip = true;
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

  /// Force on the first, N; `spring` is the spring's force, N, `grip` the contact size; before and after.
  PULVIS_INLINE static Vec3 slide(const Touch& touch, const Vec3& slip_velocity, double contact_size,
                                  double limiting_force, double dashpot, const Pair& pair, Vec3& spring,
                                  double& grip) {
    const double shrink = select(contact_size < grip, contact_size / greatest(grip, 1e-300), 1.0);
    const double step = pair.stiffness * contact_size * touch.dt;
    const Vec3 carried = shrink * carried_to_middle(spring, touch);
    const Vec3 force = in_plane(carried - step * slip_velocity, touch.normal);
    const double trial = norm(force), limit = pair.friction * limiting_force;
    const bool slips = trial > limit;
    spring = select(slips, limit / greatest(trial, 1e-300), 1.0) * force;
    grip = contact_size;
    return spring - select(slips, 0.0, dashpot) * in_plane(slip_velocity, touch.normal);
  }
};

}  // namespace pulvis::laws::sliding
