// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

namespace pulvis::laws::normal {

/// Elasto-plastic adhesive contact of the Edinburgh group ("EEPA").
///
///   loading     F = f_0 + k_1 delta^n                                    [N]          (1)
///   unloading   F = f_0 + k_2 (delta^n - delta_p^n),  k_2 = kappa k_1    [N]          (2)
///   adhesion    F = f_0 - k_a delta^chi, where (2) would be lower        [N]          (3)
///   k_1 = (4/3) E* sqrt(R*) for n = 3/2,  2 E* R* for n = 1              [N/m^n]      (4)
///   on (1):  delta_p^n = (1 - 1/kappa) delta^n                                        (5)
///            f_a = least of (3/2) pi W sqrt(2 R* delta_p) and k_2 delta_p^n/2  [N]    (6)
///            k_a = f_a/delta_a^chi,  delta_a^n = delta_p^n - f_a/k_2      [N/m^chi]   (7)
///   on (3):  delta_p^n = delta^n + (k_a/k_2) delta^chi                                (8)
///
/// The contact remembers delta_p^n and k_a, which (7) sets while it yields; (8) puts (2) through the present point,
/// so that a contact loaded again follows (2) from there. n and chi are choices (loading_exponent,
/// adhesion_exponent).
///
/// Source     S. C. Thakur, J. P. Morrissey, J. Sun, J. F. Chen, J. Y. Ooi, Granul. Matter 16 (2014) 383-400,
///            doi:10.1007/s10035-014-0506-4: (1) to (3) with chi = n are eq. 5, (5) eq. 16, the friction limit
///            eq. 13; there k_1 and k_a are given and n = 1. The model comes from J. P. Morrissey's thesis
///            (University of Edinburgh 2013, hdl:1842/8270). (4) and (6) to (8) as in LIGGGHTS-PUBLIC's
///            "edinburgh", with these differences: the radius in (6) is that of the circle in which two spheres
///            with overlap delta_p cut each other, for delta_p << R*; (7) holds at the limit of (6) as well, so
///            that (3) meets (2) also for n = 3/2 (LIGGGHTS: delta_a = delta_p/2); the friction limit has
///            delta^chi (LIGGGHTS: delta).
/// Symbols    kappa unloading_ratio, W work of adhesion ("surface energy" of the model), f_0 constant pull
///            (negative) while in contact.
/// Valid      a model of cohesive grains that yield; kappa and W are calibrated.
/// Touch      at delta = 0 with force f_0. Separation at delta = 0: the memory is lost.
/// Energy     each loading loses the area between (1), (2) and (3).
/// Friction   limited by |F - f_0 + k_a delta^chi|, the force above the adhesive branch.
/// Damping    as Hertz at the same overlap (n = 3/2), or a linear spring k_1 (n = 1, eq. 7 of the paper; with
///            n = 3/2 that formula would not be in kg/s).
/// Tests      tests/laws/elasto_plastic_test.cpp.
struct Edinburgh {
  static constexpr const char* name = "edinburgh";
  static constexpr bool adhesive = true, remembers = true;
  static constexpr bool states_energy = false;  // what is stored depends on the way that is yet to come
  struct Pair {
    double modulus;    ///< E*, Pa
    double ratio;      ///< kappa, -
    double yields;     ///< 1 - 1/kappa, -
    double pull;       ///< (3/2) pi W, N/m
    double constant;   ///< f_0, N
    double is_linear;  ///< 1: n = 1, 0: n = 3/2
    double is_curved;  ///< the other way round
    double exponent;   ///< chi: 1, 1.5 or 2
    double without;    ///< 1 where the limit is "without", else 0
  };
  static constexpr std::array parameters{
      needs::effective_modulus, needs::work_of_adhesion,
      Parameter{"unloading_ratio", &MaterialPair::unloading_ratio, 1.001, 1e4, "-", PullOff::apart()},
      Parameter{"constant_pull", &MaterialPair::constant_pull, -1e3, 0.0, "N", PullOff::grows_with(1, 0)}};

  static Pair mix(const MaterialPair& pair, const Choices& choices) {
    return {pair.effective_modulus,
            pair.unloading_ratio,
            1.0 - 1.0 / pair.unloading_ratio,
            1.5 * pi * pair.work_of_adhesion,
            pair.constant_pull,
            choices.linear_loading ? 1.0 : 0.0,
            choices.linear_loading ? 0.0 : 1.0,
            choices.adhesion_exponent,
            choices.cohesion_limit != CohesionLimit::with ? 1.0 : 0.0};
  }
  static Stiffness stiffness(const MaterialPair& pair, const Choices& choices) {
    return {2.0 * pair.effective_modulus, 8.0 * pair.effective_shear_modulus,
            choices.linear_loading ? 2.0 * pair.effective_modulus : (4.0 / 3.0) * pair.effective_modulus,
            choices.linear_loading ? 1.0 : root(5.0 / 6.0)};
  }

  PULVIS_INLINE static double separation_gap(double /*radius*/, const Pair&) { return 0.0; }

  /// One of two finite numbers for n = 1 and n = 3/2. Not a choice of lanes, which AVX-512 loops could not take.
  PULVIS_INLINE static double by_exponent(const Pair& pair, double linear, double curved) {
    return pair.is_linear * linear + pair.is_curved * curved;
  }
  /// x^chi.
  PULVIS_INLINE static double adhesive_power(double x, const Pair& pair) {
    const double above = select(pair.exponent > 1.75, x, root(x));
    return x * select(pair.exponent < 1.25, 1.0, above);
  }
  /// k_a of (6) and (7) for a plastic overlap delta_p^n = `plastic`.
  PULVIS_INLINE static double adhesive_stiffness(double plastic, double second, double radius,
                                                 const Pair& pair) {
    const double overlap = by_exponent(pair, plastic, square(cube_root(plastic)));
    const double pull = least(pair.pull * root(2.0 * radius * overlap), 0.5 * second * plastic);
    const double meets = plastic - pull / greatest(second, 1e-300);
    const double at = by_exponent(pair, meets, square(cube_root(meets)));
    return pull / greatest(adhesive_power(at, pair), 1e-300);
  }

  /// `plastic` is delta_p^n, `adhesion` k_a, before and after.
  PULVIS_INLINE static Normal normal(const Touch& touch, const Pair& pair, double& plastic,
                                     double& adhesion) {
    const double delta = greatest(touch.overlap, 0.0), radius = touch.radius;
    const double a = by_exponent(pair, select(touch.overlap > 0.0, radius, 0.0), root(radius * delta));
    const double first = pair.modulus * by_exponent(pair, 2.0 * radius, (4.0 / 3.0) * root(radius));  // k_1
    const double second = pair.ratio * first;
    const double powered = delta * by_exponent(pair, 1.0, root(delta));  // delta^n
    const double yielded = pair.yields * powered;

    const bool loads = plastic <= yielded;
    const double at_yield = adhesive_stiffness(yielded, second, radius, pair);
    const double pulls = select(loads, at_yield, adhesion), at = select(loads, yielded, plastic);
    const double adhesive = pulls * adhesive_power(delta, pair);  // how far (3) is below f_0
    const double unloading = second * (powered - at);
    const bool sticks = select(loads, 0.0, unloading) < -adhesive;

    plastic = select(sticks, powered + adhesive / second, at);
    adhesion = pulls;
    const double force = select(loads, first * powered, select(sticks, -adhesive, unloading));
    return {pair.constant + force, a, a, pair.without * (adhesive - pair.constant)};
  }
};

}  // namespace pulvis::laws::normal
