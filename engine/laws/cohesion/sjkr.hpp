// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::cohesion {

/// Simplified JKR: attraction in proportion to the contact area of two rigid spheres.
///
///   F_c = k_c A                                                             [N]    (1)
///   A = (pi/4) (r - R_i - R_j)(r + R_i - R_j)(r - R_i + R_j)(r + R_i + R_j)/(-r^2)  [m^2]  (2)
///   wall: A = pi (R_i^2 - r^2)                                              [m^2]  (3)
///
/// r is the distance of the centres (wall: of the centre from it). With q = 1/(R_i R_j), zero at a wall, both are
///   A = (pi/4) delta (4 - 2 delta/R* + delta^2 q)(2/R* - delta q)/(1/R* - delta q)^2       (4)
///
/// Source     no paper: "cohesion sjkr" of LIGGGHTS-PUBLIC 3.8.0 and LIGGGHTS-PFM (the sign of (2) as in their
///            source). (4) is our rearrangement of the circle in which two spheres cut each other.
/// Symbols    k_c cohesion energy density of the pair, J/m^3.
/// Valid      a model of its own, not JKR: no pull-off force without load, no memory. On Hooke the contact
///            collapses if 2 pi k_c R* exceeds k_n. On Hertz the overlap without force is (1.5 pi k_c/E*)^2 R*:
///            keep k_c below 0.02 E*. k_c must be calibrated anew if E* changes, as k_c ~ E*^(2/3).
/// Touch      at delta = 0 with zero force. Separation at delta = 0.
/// Energy     conservative.
/// Friction   limited by the force without the attraction, as in LIGGGHTS-PUBLIC unless tangential_reduce is
///            on; LIGGGHTS-PFM takes the force with it ("with").
/// Tests      tests/laws/cohesion_test.cpp.
struct Sjkr {
  static constexpr const char* name = "sjkr";
  static constexpr bool acts = true, reaches = false, needs_sizes = true, is_viscous = false,
                        has_pull_off = false;
  static constexpr bool states_energy = false;  // no closed form
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    double density;  ///< k_c, Pa
  };
  static constexpr std::array parameters{needs::cohesion_energy_density};

  static Pair mix(const MaterialPair& pair, const Choices&) { return {pair.cohesion_energy_density}; }

  static double longest_gap(double, const Pair&) { return 0.0; }
  static bool acts_on_approach(const Pair&) { return false; }
  PULVIS_INLINE static double separation_gap(const Touch&, const Pair&) { return 0.0; }
  PULVIS_INLINE static double formation_gap(const Touch&, const Pair&) { return 0.0; }
  /// (4), m^2.
  PULVIS_INLINE static double area(const Touch& touch) {
    const double delta = greatest(touch.overlap, 0.0), curvature = 1.0 / touch.radius;
    const double product = touch.radius_first * touch.radius_second;
    const double q = select(product > 0.0, 1.0 / greatest(product, 1e-300), 0.0);
    const double sides = 4.0 - 2.0 * delta * curvature + delta * delta * q;
    return 0.25 * pi * delta * sides * (2.0 * curvature - delta * q) / square(curvature - delta * q);
  }
  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    return {pair.density * area(touch), 0.0, 0.0, 0.0};
  }
};

}  // namespace pulvis::laws::cohesion
