// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/cohesion/bridge.hpp"

namespace pulvis::laws::cohesion {

/// Capillary bridge after the closed form of Willett et al.
///
///   F = 2 pi R sigma cos(theta)/(1 + 2.1 S + 10 S^2)      [N]   (1)
///   S = (h/2)/sqrt(V/R),  R = 2 R*                         [-]   (2)
///
/// Volume, formation, rupture and viscous part: cohesion/bridge.hpp.
///
/// Source     C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville, Langmuir 16 (2000) 9396-9405,
///            doi:10.1021/la000657y, eq. 12. Codes that take the whole gap, s = 2 S, write 1 + 1.05 s + 2.5 s^2.
/// Symbols    sigma surface tension, theta contact angle (rad), h gap, V volume of the bridge.
/// Valid      small bridges. For V/R^3 = 0.001 to 0.03 and theta up to 20 degrees it lies 7 to 20 % above the
///            Young-Laplace equation near contact and 17 to 30 % below it near rupture (at 50 degrees up to 36 %
///            above and 56 % below). A wall counts as a sphere of R = 2 R_i (Derjaguin; YADE takes R_i and gets
///            half the force).
/// Touch      forms when the solids touch (default) or at the rupture distance on approach.
/// Separation at the rupture distance h_r, where the force is small but not zero.
/// Energy     each bridge that forms on touch and breaks at h_r takes the integral of F from 0 to h_r.
/// Friction   limited by the force without the bridge's pull: the grains press on each other with that force.
/// Tests      tests/laws/capillary_test.cpp.
struct CapillaryWillettClosed {
  static constexpr const char* name = "capillary_willett_closed";
  static constexpr bool acts = true, reaches = true, needs_sizes = true, is_viscous = true,
                        has_pull_off = true;
  static constexpr bool states_energy = false;  // no closed form
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    BridgePair bridge;
    double cosine;  ///< cos(theta)
  };
  static constexpr auto& parameters = bridge_parameters;

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    return {mix_bridge(pair, choices), cosine_of_cycles(pair.contact_angle / (2.0 * pi))};
  }

  /// (1), N.
  PULVIS_INLINE static double force(double gap, double volume, double radius, const Pair& pair) {
    const double s = 0.5 * gap / root(volume / radius);
    return 2.0 * pi * radius * pair.bridge.tension * pair.cosine / (1.0 + s * (2.1 + 10.0 * s));
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
