// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/cohesion/bridge.hpp"

namespace pulvis::laws::cohesion {

/// Capillary bridge after Rabinovich et al.
///
///   F = 2 pi R sigma (cos(theta)/(1 + h/(2 d)) + sin(alpha) sin(alpha + theta))    [N]   (1)
///   2 d = -h + sqrt(h^2 + 2 V/(pi R))                                                [m]   (2)
///   alpha^2 = 2 d/R,  R = 2 R*                                                       [-]   (3)
///
/// Volume, formation, rupture and viscous part: cohesion/bridge.hpp.
///
/// Source     Y. I. Rabinovich, M. S. Esayanur, B. M. Moudgil, Langmuir 21 (2005) 10992-10997,
///            doi:10.1021/la0517639: (1) eq. 19, (2) eq. 20, (3) eq. A3. P. Lambert et al., Langmuir 24 (2008)
///            3157-3163, leave the sine term out.
/// Symbols    sigma surface tension, theta contact angle (rad), h gap, V volume of the bridge.
/// Valid      small bridges and contact angles: from 18 % below to 50 % above the Young-Laplace equation for
///            V/R^3 = 0.001 to 0.03 and theta up to 20 degrees, up to 110 % above at 50 degrees:
///            capillary_willett is the better choice. With R = 2 R* (YADE) the first term is
///            2 pi R_i sigma cos(theta) for equal spheres in contact; LIGGGHTS-PUBLIC's "washino" puts R* in the
///            place of R and gets half of it.
/// Touch      forms when the solids touch (default) or at the rupture distance on approach.
/// Separation at the rupture distance h_r, where the force is small but not zero.
/// Energy     each bridge that forms on touch and breaks at h_r takes the integral of F from 0 to h_r.
/// Friction   limited by the force without the bridge's pull: the grains press on each other with that force.
/// Tests      tests/laws/capillary_test.cpp.
struct CapillaryRabinovich {
  static constexpr const char* name = "capillary_rabinovich";
  static constexpr bool acts = true, reaches = true, needs_sizes = true, is_viscous = true,
                        has_pull_off = true;
  static constexpr bool states_energy = false;  // no closed form
  static constexpr CohesionLimit standard_limit = CohesionLimit::without;
  struct Pair {
    BridgePair bridge;
    double cosine, sine;  ///< of theta
  };
  static constexpr auto& parameters = bridge_parameters;

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    const double cycles = pair.contact_angle / (2.0 * pi);
    return {mix_bridge(pair, choices), cosine_of_cycles(cycles), sine_of_cycles(cycles)};
  }

  /// (1), N. h/(2 d) is written as (h^2 + h sqrt(h^2 + w))/w with w = 2 V/(pi R), without cancellation, as is 2 d
  /// as w/(h + sqrt(h^2 + w)).
  PULVIS_INLINE static double force(double gap, double volume, double radius, const Pair& pair) {
    const double w = 2.0 * volume / (pi * radius);
    const double far = gap + root(gap * gap + w);
    const double alpha = least(root(w / (far * radius)), 2.0);
    const double sine = loop_sine(alpha), cosine = loop_cosine(alpha);
    const double ring = sine * (sine * pair.cosine + cosine * pair.sine);
    return 2.0 * pi * radius * pair.bridge.tension * (pair.cosine / (1.0 + gap * far / w) + ring);
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
