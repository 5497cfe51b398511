// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::cohesion {

/// Van der Waals attraction after Hamaker, with cut-off.
///
///   F_c = A_H R*/(6 h_s^2),  h_s = greatest of h and h_c      [N]    (1)
///   F_c = 0 beyond h_max                                             (2)
///
/// Source     H. C. Hamaker, Physica 4 (1937) 1058-1072, doi:10.1016/S0031-8914(37)80203-7, in Derjaguin's limit
///            h << R*. Equal spheres of radius R: A_H R/(12 h^2).
/// Symbols    A_H Hamaker's constant, h gap, h_c shortest gap (cut-off, some 0.2 to 0.4 nm for clean surfaces),
///            h_max longest gap.
/// Valid      h << R*, no retardation (h below some 10 nm). Not a law for coarse-grained parcels unless h_c is
///            scaled with them.
/// Touch      acts from h_max on, on approach too, where the force jumps to A_H R*/(6 h_max^2).
/// Separation at h_max.
/// Energy     conservative; from contact to h_max it takes A_H R*/6 (1/h_c - 1/h_max).
/// Friction   limited by the force without the attraction.
/// Tests      tests/laws/cohesion_test.cpp.
struct Hamaker {
  static constexpr const char* name = "hamaker";
  static constexpr bool acts = true, reaches = true, needs_sizes = false, is_viscous = false,
                        has_pull_off = true;
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    double sixth;     ///< A_H/6, J
    double shortest;  ///< h_c, m
    double longest;   ///< h_max, m
  };
  static constexpr std::array parameters{
      Parameter{"hamaker_constant", &MaterialPair::hamaker_constant, 1e-24, 1e-15, "J",
                PullOff::grows_with(1, -1)},
      Parameter{"shortest_gap", &MaterialPair::shortest_gap, 1e-11, 1e-3, "m", PullOff::apart()},
      Parameter{"longest_gap", &MaterialPair::longest_gap, 1e-11, 1e-2, "m", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices&) {
    return {pair.hamaker_constant / 6.0, pair.shortest_gap, pair.longest_gap};
  }

  static double longest_gap(double, const Pair& pair) { return pair.longest; }
  static bool acts_on_approach(const Pair&) { return true; }
  PULVIS_INLINE static double separation_gap(const Touch&, const Pair& pair) { return pair.longest; }
  PULVIS_INLINE static double formation_gap(const Touch&, const Pair& pair) { return pair.longest; }
  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    const double gap = greatest(-touch.overlap, pair.shortest);
    const double scale = pair.sixth * touch.radius;
    return {scale / (gap * gap), scale / (pair.shortest * pair.shortest), 0.0, 0.0};
  }
  static constexpr bool states_energy = true;
  PULVIS_INLINE static double stored(const Touch& touch, const Pair& pair) {
    const double gap = least(greatest(-touch.overlap, pair.shortest), pair.longest);
    const double nearer = pair.shortest - least(-touch.overlap, pair.shortest);
    return -pair.sixth * touch.radius *
           (1.0 / gap - 1.0 / pair.longest + nearer / (pair.shortest * pair.shortest));
  }
};

}  // namespace pulvis::laws::cohesion
