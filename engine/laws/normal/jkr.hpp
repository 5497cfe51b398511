// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/normal/hertz.hpp"
#include "engine/laws/parts.hpp"

namespace pulvis::laws::normal {

/// Adhesive elastic contact after Johnson, Kendall and Roberts, exact, with memory of touch.
///
///   F     = 4 E* a^3/(3 R*) - sqrt(8 pi W E* a^3)       [N]  (1)
///   delta = a^2/R* - sqrt(2 pi W a/E*)                   [m]  (2)
///   F_po  = (3/2) pi W R*                    pull-off    [N]  (3)
///   delta_c = (3/4) (pi^2 W^2 R*/E*^2)^(1/3) rupture     [m]  (4)
///   a_c   = (pi W R*^2/(8 E*))^(1/3)   radius at rupture [m]  (5)
///
/// With y = sqrt(a/a_c), equations (1) and (2) become polynomials (our rearrangement):
///
///   delta/delta_c = (y^4 - 4 y)/3                             (6)
///   F/F_po        = y^3 (y^3 - 6)/9                           (7)
///
/// and with t = y - 1, s = sqrt(3 (1 + delta/delta_c)):  t^2 (t^2 + 4 t + 6) = s^2. In t the double root at
/// rupture (t = 0) is harmless: t is a smooth function of s there. Newton's method from the start
/// t = s/sqrt(6 + 1.05 s) needs four steps: relative error of t below 1e-14 for any overlap.
///
/// Source     K. L. Johnson, K. Kendall, A. D. Roberts, Proc. R. Soc. Lond. A 324 (1971) 301-313,
///            doi:10.1098/rspa.1971.0141; (1) and (2) follow from K. L. Johnson, Contact Mechanics (1985),
///            doi:10.1017/CBO9781139171731, section 5.5; (3), (4) and W_s are eq. 50, 49 and 52 of C. Thornton,
///            Z. Ning, Powder Technol. 99 (1998) 154-162, doi:10.1016/S0032-5910(98)00099-0. W is the work of
///            adhesion of the pair; codes that take gamma of one surface (LAMMPS) write F_po = 3 pi gamma R*.
/// Valid      Tabor number (R* W^2/(E*^2 z0^3))^(1/3) above about 1 (soft, large or sticky); a << R*.
/// Touch      at delta = 0, where the force jumps from 0 to -(8/9) F_po: nothing acts on approach before.
/// Separation at delta = -delta_c, where the force jumps from -(5/9) F_po to 0. On the way it passes -F_po.
/// Energy     each touch and separation loses W_s = 7.0922 (W^5 R*^4/E*^2)^(1/3) J; conservative between them. Integrals
///            of (7) over (6), with -pi a^2 W as the cohesive share:
///              elastic     F_po delta_c (4/27) y^4 (y^6/10 - y^3 + 3)        [J]  (8)
///              cohesive   -F_po delta_c (2/9) y^4                            [J]  (9)
///              their sum   -(8/15) 4^(1/3) F_po delta_c at touch (y^3 = 4): lost there;
///                          (4/45) F_po delta_c at separation (y = 1): lost there   [J]  (10)
/// Friction   "shifted" by default: |F_t| <= mu |F + 2 F_po| (C. Thornton, J. Phys. D: Appl. Phys. 24 (1991) 1942,
///            doi:10.1088/0022-3727/24/11/007); "without" is Hertz's force at the same overlap.
/// Tests      tests/laws/jkr_test.cpp, tests/verification/jkr_collision_test.cpp.
struct Jkr {
  static constexpr const char* name = "jkr";
  static constexpr bool adhesive = true, remembers = false;
  struct Pair {
    double pull_off;         ///< F_po/R*, N/m
    double stretch;          ///< delta_c/R*^(1/3), m^(2/3)
    double inverse_stretch;  ///< 3 R*^(1/3)/delta_c, m^(-2/3)
    double rupture;          ///< a_c/R*^(2/3), m^(1/3)
    double shifted;          ///< in the friction limit: how many F_po are added to F
    double without;          ///< 1: the friction limit is Hertz's force at the same overlap, else 0
    double hertz;            ///< (4/3) E*, Pa
  };
  static constexpr std::array parameters{needs::effective_modulus, needs::work_of_adhesion};

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    // Without adhesion the law is Hertz's. W/E* of 1e-60 m leaves no trace of adhesion in any digit and keeps
    // the formulas finite.
    const double work = greatest(pair.work_of_adhesion, 1e-60 * pair.effective_modulus);
    const double ratio = pi * work / pair.effective_modulus;
    const CohesionLimit limit = choices.cohesion_limit;
    const bool shifted = limit == CohesionLimit::standard || limit == CohesionLimit::shifted;
    const double stretch = 0.75 * cube_root(ratio * ratio);
    return {1.5 * pi * work,
            stretch,
            3.0 / stretch,
            0.5 * cube_root(ratio),
            shifted ? 2.0 : 0.0,
            limit == CohesionLimit::without ? 1.0 : 0.0,
            (4.0 / 3.0) * pair.effective_modulus};
  }

  static Stiffness stiffness(const MaterialPair& pair, const Choices& choices) {
    return Hertz::stiffness(pair, choices);
  }

  /// R*^(-1/3), m^(-1/3): what the lengths below are made of.
  PULVIS_INLINE static double size_factor(double radius) { return inverse_cube_root(radius); }
  PULVIS_INLINE static double separation_gap(double radius, double factor, const Pair& pair) {
    return pair.stretch * (radius * square(factor));
  }
  PULVIS_INLINE static double separation_gap(double radius, const Pair& pair) {
    return separation_gap(radius, size_factor(radius), pair);
  }

  // (6) is f(t) = t^4 + 4 t^3 + 6 t^2 - s2 = 0 for t = y - 1 >= 0, with s2 = 3 (1 + delta/delta_c) from 0 to 1e120 (W as small as it gets: 1e42).
  PULVIS_INLINE static double equation(double overlap, double radius, double factor, const Pair& pair) {
    return greatest(overlap + separation_gap(radius, factor, pair), 0.0) * (pair.inverse_stretch * factor);
  }
  /// Off by at most 10 %.
  PULVIS_INLINE static double first_guess(double s2) {
    const double s = root(s2);
    return s / root(6.0 + 1.05 * s);
  }
  /// Householder's step of fourth order: of 10 % it leaves 3e-5, and of that no more than rounding.
  PULVIS_INLINE static double improved(double t, double s2) {
    const double u = t + 1.0;
    const double value = t * t * (t * (t + 4.0) + 6.0) - s2;  // f
    const double slope = t * (t * (t + 3.0) + 3.0);           // a quarter of the first derivative
    const double steep = 4.0 * (slope * slope),
                 bent = value * (u * u);  // the second is 12 u^2, the third 24 u
    const double divisor = 4.0 * slope * (steep - 3.0 * bent) + value * value * u;
    return t - value * (steep - 1.5 * bent) / (divisor + 1e-300);  // at t = 0 both are zero
  }
  static constexpr int improvements = 2;

  PULVIS_INLINE static Normal normal(const Touch& touch, double factor, double t, const Pair& pair) {
    const double overlap = touch.overlap, radius = touch.radius;
    const double pull_off = pair.pull_off * radius;
    const double y = 1.0 + t;
    const double cube = y * y * y;
    const double hertz = root(radius * greatest(overlap, 0.0));
    const double force = pull_off * (cube * (cube - 6.0) * (1.0 / 9.0));
    const double pressed = pair.hertz * hertz * greatest(overlap, 0.0);
    return {force, pair.rupture * (radius * factor) * (y * y), hertz,
            pair.shifted * pull_off + pair.without * (pressed - force)};
  }
  PULVIS_INLINE static Normal normal(const Touch& touch, const Pair& pair, double& /*plastic*/,
                                     double& /*adhesion*/) {
    const double factor = size_factor(touch.radius);
    const double s2 = equation(touch.overlap, touch.radius, factor, pair);
    double t = first_guess(s2);
    for (int k = 0; k < improvements; ++k) t = improved(t, s2);
    return normal(touch, factor, t, pair);
  }

  static constexpr bool states_energy = true;
  PULVIS_INLINE static double scale_of_energy(double radius, const Pair& pair) {
    return pair.pull_off * radius * pair.stretch * cube_root(radius);
  }
  /// (8) and (9).
  PULVIS_INLINE static Stored stored(const Touch& touch, const Pair& pair, const Normal& normal) {
    const double third = cube_root(touch.radius);
    const double y2 = normal.contact_size / (pair.rupture * third * third);
    const double cube = y2 * root(y2), fourth = scale_of_energy(touch.radius, pair) * y2 * y2;
    return {(4.0 / 27.0) * fourth * (cube * (0.1 * cube - 1.0) + 3.0), -(2.0 / 9.0) * fourth};
  }
  /// (10).
  PULVIS_INLINE static double stored_at_touch(double radius, const Pair& pair) {
    return -(8.0 / 15.0) * 1.5874010519681994 * scale_of_energy(radius, pair);
  }
  PULVIS_INLINE static double stored_at_separation(double radius, const Pair& pair) {
    return (4.0 / 45.0) * scale_of_energy(radius, pair);
  }
};

}  // namespace pulvis::laws::normal
