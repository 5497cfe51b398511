// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"
#include "engine/math/functions.hpp"

namespace pulvis::laws::damping {

/// Dashpot that gives a stated coefficient of restitution e.
///
///   beta = ln e / sqrt(ln^2 e + pi^2)             [-]      (1)
///   c(S) = -2 f beta sqrt(S m*)                   [kg/s]   (2)
///   linear laws: f = 1, normal S_n = k_n, tangential S_t = k_t                 [N/m]
///   Hertz: f = sqrt(5/6), normal S_n = 2 E* a_d, tangential S_t = 8 G* a_d    [N/m]
///
/// a_d is sqrt(R* delta) (choice "hertz", default: also under JKR, so that a stretched contact is not
/// damped) or the contact radius of the normal law (choice "jkr_radius"). The tangential dashpot can be left out
/// (choice tangential_damping).
///
/// Source     Y. Tsuji, T. Tanaka, T. Ishida, Powder Technol. 71 (1992) 239-250,
///            doi:10.1016/0032-5910(92)88030-L (the form of the dashpot); (1) and (2) in closed form:
///            D. Antypov, J. A. Elliott, EPL 94 (2011) 50004, doi:10.1209/0295-5075/94/50004, eq. 10 and 17
///            (there alpha = -sqrt(5) beta on the secant stiffness); the tangential one as in the LIGGGHTS family.
/// Valid      0 < e <= 1. With Hertz and with Hooke e is returned exactly if nothing clips the force; in steps of
///            a thousandth of the contact time within 0.3 % of e from e = 0.1 up (`pulvis validate`). With
///            adhesion the collision loses more (see the law's energy).
/// Touch      Hertz: the dashpot grows from zero with delta^(1/4); linear laws: it sets in at once, the force
///            jumps by c v_n. Separation: shortly before it the dashpot outweighs the spring: the contact pulls.
/// Energy     dissipative.
/// Tests      validation/restitution.cpp.
struct Restitution {
  static constexpr const char* name = "restitution";
  struct Pair {
    double coefficient;           ///< -2 f beta, -
    double normal_stiffness;      ///< S_n/a_d, Pa
    double tangential_stiffness;  ///< S_t/a_d, Pa
    double on_contact_size;       ///< 1: a_d is the contact radius, 0: the Hertz radius
  };

  static constexpr std::array parameters{
      Parameter{"restitution", &MaterialPair::restitution, 1e-3, 1.0, "-", PullOff::apart()}};

  static Pair mix(const MaterialPair& pair, const Choices& choices, const Stiffness& stiffness) {
    const double log_e = logarithm(pair.restitution);
    const double beta = log_e / root(log_e * log_e + square(pi));
    return {-2.0 * stiffness.damping_shape * beta, stiffness.normal,
            choices.tangential_damping ? stiffness.tangential : 0.0,
            choices.damping_on_jkr_radius ? 1.0 : 0.0};
  }

  PULVIS_INLINE static Dashpots coefficients(const Normal& normal, double mass, const Pair& pair) {
    const double size = select(pair.on_contact_size > 0.5, normal.contact_size, normal.damping_size);
    const double scale = mass * size;
    return {pair.coefficient * root(pair.normal_stiffness * scale),
            pair.coefficient * root(pair.tangential_stiffness * scale)};
  }
};

/// No dashpot: contacts lose energy only by friction, rolling resistance and adhesion.
struct None {
  static constexpr const char* name = "none";
  struct Pair {};
  static constexpr std::array<Parameter, 0> parameters{};
  static Pair mix(const MaterialPair&, const Choices&, const Stiffness&) { return {}; }
  PULVIS_INLINE static Dashpots coefficients(const Normal&, double, const Pair&) { return {0.0, 0.0}; }
};

}  // namespace pulvis::laws::damping
