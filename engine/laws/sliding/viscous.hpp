// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::sliding {

/// Viscous friction up to Coulomb's limit, without memory.
///
///   F_t = -v_t min(c_t, mu N/|v_t|)    [N]
///
/// Source     P. K. Haff, B. T. Werner, Powder Technol. 48 (1986) 239-245, doi:10.1016/0032-5910(86)80048-1 (the
///            form; c_t is here that of the damping law).
/// Symbols    N the limiting normal force (see ContactLaw), mu Coulomb's coefficient, c_t from the damping law,
///            without which nothing acts.
/// Valid      flowing powder. Nothing holds at rest: heaps and beds creep.
/// Touch      force zero without slip. Separation: nothing to forget.
/// Energy     dissipative.
/// Tests      tests/laws/sliding_test.cpp.
struct Viscous {
  static constexpr const char* name = "viscous";
  static constexpr SpringKind spring = SpringKind::none;
  static constexpr bool remembers_grip = false;
  struct Pair {
    double friction;  ///< mu, -
  };
  static constexpr std::array parameters{needs::coulomb_friction};

  static Pair mix(const MaterialPair& pair, const Choices&, const Stiffness&) { return {pair.friction}; }

  PULVIS_INLINE static Vec3 slide(const Touch& touch, const Vec3& slip_velocity, double /*contact_size*/,
                                  double limiting_force, double dashpot, const Pair& pair, Vec3& spring,
                                  double& /*grip*/) {
    const Vec3 slip = in_plane(slip_velocity, touch.normal);
    const double trial = dashpot * norm(slip), limit = pair.friction * limiting_force;
    spring = {};
    return -(select(trial > limit, limit / greatest(trial, 1e-300), 1.0) * dashpot) * slip;
  }
};

}  // namespace pulvis::laws::sliding
