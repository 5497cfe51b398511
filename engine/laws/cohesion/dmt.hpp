// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::cohesion {

/// Constant attraction of stiff small spheres in contact (Derjaguin, Muller, Toporov).
///
///   F_c = 2 pi W R* = F_po      [N]
///
/// Source     B. V. Derjaguin, V. M. Muller, Yu. P. Toporov, J. Colloid Interface Sci. 53 (1975) 314-326,
///            doi:10.1016/0021-9797(75)90018-1, eq. 41.
/// Symbols    W work of adhesion of the pair, R* reduced radius.
/// Valid      on Hertz, Tabor number (R* W^2/(E*^2 z0^3))^(1/3) below about 0.1 (hard, small, little sticky).
///            Softened parcels usually leave this range: then JKR. The attraction across a gap is left out.
/// Touch      at delta = 0, where the force jumps from 0 to -F_po.
/// Separation at delta = 0, where it jumps back.
/// Energy     F_po delta: the attraction itself is conservative.
/// Friction   limited by the force without the attraction (F + F_po), as DMT's contact area is that of Hertz.
/// Tests      tests/laws/cohesion_test.cpp.
struct Dmt {
  static constexpr const char* name = "dmt";
  static constexpr bool acts = true, reaches = false, needs_sizes = false, is_viscous = false,
                        has_pull_off = true;
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    double pull_off;  ///< F_po/R*, N/m
  };
  static constexpr std::array parameters{needs::work_of_adhesion};

  static Pair mix(const MaterialPair& pair, const Choices&) { return {2.0 * pi * pair.work_of_adhesion}; }

  static double longest_gap(double, const Pair&) { return 0.0; }
  static bool acts_on_approach(const Pair&) { return false; }
  PULVIS_INLINE static double separation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static double formation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    const double pull_off = pair.pull_off * touch.radius;
    return {pull_off, pull_off, 0.0, 0.0};
  }
  static constexpr bool states_energy = true;
  PULVIS_INLINE static double stored(const Touch& touch, const Pair& pair) {
    return -pair.pull_off * touch.radius * greatest(touch.overlap, 0.0);
  }
};

}  // namespace pulvis::laws::cohesion
