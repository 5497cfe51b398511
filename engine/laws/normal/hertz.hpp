// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::normal {

/// Elastic contact of two spheres, or of a sphere and a flat.
///
///   a   = sqrt(R* delta)                 [m]   (1)
///   F_n = (4/3) E* sqrt(R*) delta^(3/2)  [N]   (2)
///
/// Source     H. Hertz, J. reine angew. Math. 92 (1882) 156-171, doi:10.1515/crll.1882.92.156; in the form
///            of K. L. Johnson, Contact Mechanics (1985), doi:10.1017/CBO9781139171731, eq. 4.22 and 4.23.
/// Symbols    R* reduced radius, E* effective modulus, delta overlap.
/// Valid      a << R*, elastic, smooth; in practice delta below a few per cent of R*.
/// Touch      at delta = 0 with zero force. Separation at delta = 0.
/// Energy     (8/15) E* sqrt(R*) delta^(5/2), stored and returned.
/// Tests      tests/laws/normal_test.cpp, validation/chung_ooi.cpp.
struct Hertz {
  static constexpr const char* name = "hertz";
  static constexpr bool adhesive = false, remembers = false;
  struct Pair {
    double effective_modulus;  ///< E*, Pa
  };

  static constexpr std::array parameters{needs::effective_modulus};

  static Pair mix(const MaterialPair& pair, const Choices&) { return {pair.effective_modulus}; }
  static Stiffness stiffness(const MaterialPair& pair, const Choices&) {
    return {2.0 * pair.effective_modulus, 8.0 * pair.effective_shear_modulus,
            (4.0 / 3.0) * pair.effective_modulus, root(5.0 / 6.0)};
  }

  /// Gap up to which an existing contact lasts, m.
  PULVIS_INLINE static double separation_gap(double /*radius*/, const Pair&) { return 0.0; }

  PULVIS_INLINE static Normal normal(const Touch& touch, const Pair& pair, double& /*plastic*/,
                                     double& /*adhesion*/) {
    const double delta = greatest(touch.overlap, 0.0);
    const double a = root(touch.radius * delta);
    return {(4.0 / 3.0) * pair.effective_modulus * a * delta, a, a, 0.0};
  }

  static constexpr bool states_energy = true;
  PULVIS_INLINE static Stored stored(const Touch& touch, const Pair&, const Normal& normal) {
    return {0.4 * normal.elastic * greatest(touch.overlap, 0.0), 0.0};
  }
  PULVIS_INLINE static double stored_at_touch(double /*radius*/, const Pair&) { return 0.0; }
  PULVIS_INLINE static double stored_at_separation(double /*radius*/, const Pair&) { return 0.0; }
};

}  // namespace pulvis::laws::normal
