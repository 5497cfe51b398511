// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/cohesion/bridge.hpp"

namespace pulvis::laws::cohesion {

/// Capillary bridge after the full fit of Willett et al.
///
///   F = 2 pi R sigma exp(f1 - f2 exp(f3 ln S + f4 ln^2 S))      [N]   (1)
///   S = (h/2)/sqrt(V/R),  R = 2 R*                               [-]   (2)
///
/// f1 to f4 are polynomials in ln(V/R^3) and the contact angle (see `mix`). Volume, formation, rupture and
/// viscous part: cohesion/bridge.hpp.
///
/// Source     C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville, Langmuir 16 (2000) 9396-9405,
///            doi:10.1021/la000657y, the polynomials at its end.
/// Symbols    sigma surface tension, theta contact angle (rad), h gap, V volume of the bridge.
/// Valid      V/R^3 from 0.001 to 0.1: within 3 % of the Young-Laplace equation for theta up to 40 degrees,
///            within 6 % at 50; at V/R^3 = 1e-4 within 4 and 6 %. No weight of the liquid. A wall counts as a
///            sphere of R = 2 R_i (Derjaguin).
/// Touch      forms when the solids touch (default) or at the rupture distance on approach.
/// Separation at the rupture distance h_r, where the force is small but not zero.
/// Energy     each bridge that forms on touch and breaks at h_r takes the integral of F from 0 to h_r.
/// Friction   limited by the force without the bridge's pull: the grains press on each other with that force.
/// Tests      tests/laws/capillary_test.cpp.
struct CapillaryWillett {
  static constexpr const char* name = "capillary_willett";
  static constexpr bool acts = true, reaches = true, needs_sizes = true, is_viscous = true,
                        has_pull_off = true;
  static constexpr bool states_energy = false;  // no closed form
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    BridgePair bridge;
    double f1[4], f2[3], f3[4], f4[3];  ///< polynomials in ln(V/R^3)
  };
  static constexpr auto& parameters = bridge_parameters;

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    const double t = pair.contact_angle, t2 = t * t;
    return {mix_bridge(pair, choices),
            {-0.44507 + 0.050832 * t - 1.1466 * t2, -0.1119 - 0.000411 * t - 0.1490 * t2,
             -0.012101 - 0.0036456 * t - 0.01255 * t2, -0.0005 - 0.0003505 * t - 0.00029076 * t2},
            {1.9222 - 0.57473 * t - 1.2918 * t2, -0.0668 - 0.1201 * t - 0.22574 * t2,
             -0.0013375 - 0.0068988 * t - 0.01137 * t2},
            {1.268 - 0.01396 * t - 0.23566 * t2, 0.198 + 0.092 * t - 0.06418 * t2,
             0.02232 + 0.02238 * t - 0.009853 * t2, 0.0008585 + 0.001318 * t - 0.00053 * t2},
            {-0.010703 + 0.073776 * t - 0.34742 * t2, 0.03345 + 0.04543 * t - 0.09056 * t2,
             0.0018574 + 0.004456 * t - 0.006257 * t2}};
  }

  /// (1), N.
  PULVIS_INLINE static double force(double gap, double volume, double radius, const Pair& pair) {
    const double l = loop_logarithm(volume / (radius * radius * radius));
    const double f1 = pair.f1[0] + l * (pair.f1[1] + l * (pair.f1[2] + l * pair.f1[3]));
    const double f2 = pair.f2[0] + l * (pair.f2[1] + l * pair.f2[2]);
    const double f3 = pair.f3[0] + l * (pair.f3[1] + l * (pair.f3[2] + l * pair.f3[3]));
    const double f4 = pair.f4[0] + l * (pair.f4[1] + l * pair.f4[2]);
    // Below S = 1e-9 the inner exponential has died away; there the logarithm is cut off.
    const double log_s = loop_logarithm(greatest(0.5 * gap / root(volume / radius), 1e-9));
    const double inner = loop_exponential(log_s * (f3 + f4 * log_s));
    return 2.0 * pi * radius * pair.bridge.tension * loop_exponential(f1 - f2 * inner);
  }

  static double longest_gap(double radius, const Pair& pair) { return longest_bridge(radius, pair.bridge); }
  static bool acts_on_approach(const Pair& pair) { return pair.bridge.on_approach > 0.5; }
  PULVIS_INLINE static double separation_gap(const Touch& touch, const Pair& pair) {
    return bridge_rupture(bridge_volume(touch, pair.bridge), bridge_radius(touch), pair.bridge);
  }
  PULVIS_INLINE static double formation_gap(const Touch& touch, const Pair& pair) {
    return pair.bridge.on_approach * separation_gap(touch, pair);
  }
  PULVIS_INLINE static Attraction attraction(const Touch& touch, const Pair& pair) {
    const double radius = bridge_radius(touch), volume = bridge_volume(touch, pair.bridge);
    return bridge_attraction(touch, pair.bridge, force(bridge_gap(touch), volume, radius, pair),
                             force(0.0, volume, radius, pair));
  }
};

}  // namespace pulvis::laws::cohesion
