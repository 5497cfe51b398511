// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/cohesion/bridge.hpp"

namespace pulvis::laws::cohesion {

/// Capillary bridge after Soulie et al. (what LIGGGHTS-PFM calls "Mikami" and LIGGGHTS-PUBLIC "easo").
///
///   F = pi sigma sqrt(R_i R_j) (c + exp(a h/R_2 + b)),  v = V/R_2^3      [N]   (1)
///   a = -1.1 v^(-0.53)                                                   [-]   (2)
///   b = (-0.148 ln v - 0.96) theta^2 - 0.0082 ln v + 0.48                [-]   (3)
///   c = 0.0018 ln v + 0.078                                              [-]   (4)
///
/// R_2 is the larger radius. Volume, formation, rupture and viscous part: cohesion/bridge.hpp.
///
/// Source     F. Soulie, F. Cherblanc, M. S. El Youssoufi, C. Saix, Int. J. Numer. Anal. Meth. Geomech. 30
///            (2006) 213-228, doi:10.1002/nag.476, eq. 13 and 14.
/// Symbols    sigma surface tension, theta contact angle (rad), h gap, V volume of the bridge.
/// Valid      within 13 % of the Young-Laplace equation for V/R_2^3 = 0.001 to 0.1 and theta up to 20 degrees; off
///            by up to 37 % at 40 and 62 % at 50 degrees, and by 43 % at V/R_2^3 = 1e-4 and 20 degrees. A wall
///            counts as two spheres of 2 R_i (Derjaguin).
/// Touch      forms when the solids touch (default) or at the rupture distance on approach.
/// Separation at the rupture distance h_r, where the force is small but not zero.
/// Energy     each bridge that forms on touch and breaks at h_r takes the integral of F from 0 to h_r.
/// Friction   limited by the force without the bridge's pull: the grains press on each other with that force.
/// Tests      tests/laws/capillary_test.cpp.
struct CapillarySoulie {
  static constexpr const char* name = "capillary_soulie";
  static constexpr bool acts = true, reaches = true, needs_sizes = true, is_viscous = true,
                        has_pull_off = true;
  static constexpr bool states_energy = false;  // no closed form
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    BridgePair bridge;
    double square_of_angle;  ///< theta^2
  };
  static constexpr auto& parameters = bridge_parameters;

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    return {mix_bridge(pair, choices), square(pair.contact_angle)};
  }

  /// (1), N; `mean` is sqrt(R_i R_j) and `larger` R_2, m.
  PULVIS_INLINE static double force(double gap, double volume, double mean, double larger, const Pair& pair) {
    const double l = loop_logarithm(volume / (larger * larger * larger));
    const double a = -1.1 * loop_exponential(-0.53 * l);
    const double b = (-0.148 * l - 0.96) * pair.square_of_angle - 0.0082 * l + 0.48;
    const double c = 0.0018 * l + 0.078;
    return pi * pair.bridge.tension * mean * (c + loop_exponential(a * gap / larger + b));
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
    const bool wall = !(touch.radius_second > 0.0);
    const double first = select(wall, bridge_radius(touch), touch.radius_first);
    const double second = select(wall, bridge_radius(touch), touch.radius_second);
    const double mean = root(first * second), larger = greatest(first, second);
    const double volume = bridge_volume(touch, pair.bridge);
    return bridge_attraction(touch, pair.bridge, force(bridge_gap(touch), volume, mean, larger, pair),
                             force(0.0, volume, mean, larger, pair));
  }
};

}  // namespace pulvis::laws::cohesion
