// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::cohesion {

/// Simplified JKR with a linear contact area, "SJKR2". Two forks of the LIGGGHTS family take areas that differ by
/// a factor of two between parcels, so calibrated values of k_c do too; each has its own name here.
///
///   F_c = k_c A                                                [N]
///   sjkr2_reduced_radius:        A = 2 pi delta R*             [m^2]  (LIGGGHTS-PFM)
///   sjkr2_twice_reduced_radius:  A = 2 pi delta (2 R*)         [m^2]  (LIGGGHTS-PUBLIC)
///   wall, both:                  A = 2 pi delta R_i            [m^2]
///
/// Source     no paper: "cohesion sjkr2" of LIGGGHTS-PUBLIC 3.8.0 and of LIGGGHTS-PFM, January 2024.
/// Symbols    k_c cohesion energy density of the pair, J/m^3.
/// Valid      as sjkr; with f = 1 or 2 for the two areas, on Hertz the overlap without force is
///            (1.5 pi f k_c/E*)^2 R* and the strongest pull (2/3) pi^3 (f k_c)^3 R*^2/E*^2 at 4/9 of it.
/// Touch      at delta = 0 with zero force. Separation at delta = 0.
/// Energy     conservative: k_c A delta/2.
/// Friction   as sjkr.
/// Tests      tests/laws/cohesion_test.cpp.
struct Sjkr2ReducedRadius {
  static constexpr const char* name = "sjkr2_reduced_radius";
  static constexpr bool acts = true, reaches = false, needs_sizes = true, is_viscous = false,
                        has_pull_off = false;
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    double per_area;  ///< 2 pi k_c, Pa
  };
  static constexpr std::array parameters{needs::cohesion_energy_density};

  static Pair mix(const MaterialPair& pair, const Choices&) {
    return {2.0 * pi * pair.cohesion_energy_density};
  }

  static double longest_gap(double, const Pair&) { return 0.0; }
  static bool acts_on_approach(const Pair&) { return false; }
  PULVIS_INLINE static double separation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static double formation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    return {pair.per_area * greatest(touch.overlap, 0.0) * touch.radius, 0.0, 0.0, 0.0};
  }
  static constexpr bool states_energy = true;
  PULVIS_INLINE static double stored(const Touch& touch, const Pair& pair) {
    return -0.5 * attraction(touch, pair).pull * greatest(touch.overlap, 0.0);
  }
};

/// See Sjkr2ReducedRadius.
struct Sjkr2TwiceReducedRadius : Sjkr2ReducedRadius {
  static constexpr const char* name = "sjkr2_twice_reduced_radius";

  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    const double twice = select(touch.radius_second > 0.0, 2.0, 1.0);
    return {twice * pair.per_area * greatest(touch.overlap, 0.0) * touch.radius, 0.0, 0.0, 0.0};
  }
  PULVIS_INLINE static double stored(const Touch& touch, const Pair& pair) {
    return -0.5 * attraction(touch, pair).pull * greatest(touch.overlap, 0.0);
  }
};

}  // namespace pulvis::laws::cohesion
