// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"
#include "engine/math/functions.hpp"
#include "engine/math/loop_functions.hpp"

namespace pulvis::laws::normal {

/// Linear spring.
///
///   F_n = k_n delta                                                                  [N]    (1)
///   k_n given, or from a characteristic speed V:
///   k_n = (16/15) sqrt(R*) E* (15 m* V^2/(16 sqrt(R*) E*))^(1/5)                      [N/m]  (2)
///       = (16/15)^(4/5) (E*^4 V^2)^(1/5) (R*^2 m*)^(1/5)                                     (3)
///
/// (2) makes k_n delta_max^2 = m* V^2, so that the largest overlap of an impact at V is that of Hertz.
///
/// Source     P. A. Cundall, O. D. L. Strack, Geotechnique 29 (1979) 47-65, doi:10.1680/geot.1979.29.1.47;
///            (2) as in the LIGGGHTS family and Lethe; it follows from the largest overlap of an elastic impact,
///            K. L. Johnson, Contact Mechanics (1985), doi:10.1017/CBO9781139171731, section 11.4.
/// Symbols    R* reduced radius, m* reduced mass, E* effective modulus, delta overlap.
/// Valid      impacts near the speed V; a given k_n is the same for all sizes. Stiffness at rest has no physical
///            meaning of its own: keep overlaps small.
/// Touch      at delta = 0 with zero force. Separation at delta = 0.
/// Energy     k_n delta^2/2, stored and returned.
/// Tangential k_t = tangential_ratio k_n, the same for the dashpots.
/// Tests      tests/laws/normal_test.cpp, validation/restitution.cpp.
struct Hooke {
  static constexpr const char* name = "hooke";
  static constexpr bool adhesive = false, remembers = false;
  struct Pair {
    double given;  ///< k_n, N/m; 0: from (3)
    double scale;  ///< (16/15)^(4/5) (E*^4 V^2)^(1/5)
  };
  static constexpr std::array parameters{
      Parameter{"normal_stiffness", &MaterialPair::normal_stiffness, 0.0, 1e15, "N/m", PullOff::apart()},
      Parameter{"characteristic_speed", &MaterialPair::characteristic_speed, 0.0, 1e4, "m/s",
                PullOff::apart()},
      Parameter{"tangential_ratio", &MaterialPair::tangential_ratio, 0.0, 1.0, "-", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices&) {
    const double speed = pair.characteristic_speed;
    const double fourth = square(square(pair.effective_modulus));
    return {pair.normal_stiffness,
            speed > 0.0 ? power(16.0 / 15.0, 0.8) * power(fourth * square(speed), 0.2) : 0.0};
  }
  static Stiffness stiffness(const MaterialPair& pair, const Choices&) {
    return {1.0, pair.tangential_ratio, 1.0, 1.0};
  }

  PULVIS_INLINE static double separation_gap(double /*radius*/, const Pair&) { return 0.0; }

  /// k_n, N/m.
  PULVIS_INLINE static double spring(const Touch& touch, const Pair& pair) {
    const double from_speed = pair.scale * fifth_root(square(touch.radius) * touch.mass);
    return select(pair.given > 0.0, pair.given, from_speed);
  }

  PULVIS_INLINE static Normal normal(const Touch& touch, const Pair& pair, double& /*plastic*/,
                                     double& /*adhesion*/) {
    const double delta = greatest(touch.overlap, 0.0);
    const double stiffness = select(touch.overlap > 0.0, spring(touch, pair), 0.0);
    return {stiffness * delta, stiffness, stiffness, 0.0};
  }

  static constexpr bool states_energy = true;
  PULVIS_INLINE static Stored stored(const Touch& touch, const Pair&, const Normal& normal) {
    return {0.5 * normal.elastic * greatest(touch.overlap, 0.0), 0.0};
  }
  PULVIS_INLINE static double stored_at_touch(double /*radius*/, const Pair&) { return 0.0; }
  PULVIS_INLINE static double stored_at_separation(double /*radius*/, const Pair&) { return 0.0; }
};

}  // namespace pulvis::laws::normal
