// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/normal/hooke.hpp"

namespace pulvis::laws::normal {

/// Linear, elasto-plastic, adhesive contact (Luding).
///
///   loading     F = k_1 delta                                                     [N]    (1)
///   unloading   F = k_2 (delta - delta_m) + k_1 delta_m                           [N]    (2)
///   adhesion    F = -k_c delta, where (2) would be lower                          [N]    (3)
///   k_2 = k_1 + (k_p - k_1) delta_m/delta_l                                       [N/m]  (4)
///   delta_l = k_p/(k_p - k_1) phi_F 2 R*                                          [m]    (5)
///   on (3):  delta_m = (delta + sqrt(delta^2 + 4 (k_1 + k_c) delta delta_l/(k_p - k_1)))/2     (6)
///
/// delta_m is the largest overlap so far, at most delta_l: a deeper contact is elastic with k_p. (6) puts (2)
/// through the present point, so that a contact loaded again from the adhesive line follows (2) from there.
///
/// Source     S. Luding, Granul. Matter 10 (2008) 235-246, doi:10.1007/s10035-008-0099-x: (1) to (3) eq. 6, (5)
///            eq. 7, (4) eq. 8; (6) is the exact root of (2) = (3) with (4). LIGGGHTS-PUBLIC's "luding" takes
///            (k_2 + k_c)/(k_2 - k_1) delta with the k_2 of the step before in its place.
/// Symbols    k_1 as k_n of hooke, k_p = plastic_ratio k_1, k_c = adhesion_ratio k_1, phi_F plasticity depth.
/// Valid      a model of powder grains that yield; stiffnesses are calibrated, not measured.
/// Touch      at delta = 0 with zero force, delta_m = 0. Separation at delta = 0: delta_m is forgotten.
///            Strongest pull k_c delta at delta = (k_2 - k_1)/(k_2 + k_c) delta_m.
/// Energy     each loading to delta_m loses the triangle between (1), (2) and (3).
/// Friction   limited by |F + k_c delta|, the force above the adhesive line, as in the paper.
/// Tangential k_t = tangential_ratio k_1, the same for the dashpots.
/// Tests      tests/laws/elasto_plastic_test.cpp.
struct Luding {
  static constexpr const char* name = "luding";
  static constexpr bool adhesive = true, remembers = true;
  static constexpr bool states_energy = false;  // what is stored depends on the way that is yet to come
  struct Pair {
    Hooke::Pair first;     ///< k_1
    double plastic_ratio;  ///< k_p/k_1 - 1, -
    double adhesion;       ///< k_c/k_1, -
    double depth;          ///< delta_l/R*, -
    double shift;          ///< k_c/k_1 where the limit is "without", else 0
  };
  static constexpr std::array parameters{
      Parameter{"normal_stiffness", &MaterialPair::normal_stiffness, 0.0, 1e15, "N/m", PullOff::apart()},
      Parameter{"characteristic_speed", &MaterialPair::characteristic_speed, 0.0, 1e4, "m/s",
                PullOff::apart()},
      Parameter{"tangential_ratio", &MaterialPair::tangential_ratio, 0.0, 1.0, "-", PullOff::apart()},
      Parameter{"plastic_ratio", &MaterialPair::plastic_ratio, 1.001, 1e4, "-", PullOff::apart()},
      Parameter{"adhesion_ratio", &MaterialPair::adhesion_ratio, 0.0, 1e4, "-", PullOff::otherwise()},
      Parameter{"plasticity_depth", &MaterialPair::plasticity_depth, 1e-6, 1.0, "-", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    const double ratio = pair.plastic_ratio;
    const bool without = choices.cohesion_limit != CohesionLimit::with;
    return {Hooke::mix(pair, choices), ratio - 1.0, pair.adhesion_ratio,
            ratio / (ratio - 1.0) * pair.plasticity_depth * 2.0, without ? pair.adhesion_ratio : 0.0};
  }
  static Stiffness stiffness(const MaterialPair& pair, const Choices& choices) {
    return Hooke::stiffness(pair, choices);
  }

  PULVIS_INLINE static double separation_gap(double /*radius*/, const Pair&) { return 0.0; }

  /// `plastic` is delta_m, m, before and after. Forces are over k_1 until the end.
  PULVIS_INLINE static Normal normal(const Touch& touch, const Pair& pair, double& plastic,
                                     double& /*adhesion*/) {
    const double delta = greatest(touch.overlap, 0.0);
    const double first = select(touch.overlap > 0.0, Hooke::spring(touch, pair.first), 0.0);
    const double deepest = pair.depth * touch.radius;
    const double slope = pair.plastic_ratio / deepest;  // of k_2/k_1 over delta_m
    const double largest = least(greatest(plastic, delta), deepest);
    const double unloading = (1.0 + slope * largest) * (delta - largest) + largest;
    const double adhesive = -pair.adhesion * delta;
    const bool sticks = unloading < adhesive;
    const double moved = 0.5 * (delta + root(delta * delta + 4.0 * (1.0 + pair.adhesion) * delta / slope));
    plastic = select(sticks, moved, largest);
    return {first * select(sticks, adhesive, unloading), first, first, first * pair.shift * delta};
  }
};

}  // namespace pulvis::laws::normal
