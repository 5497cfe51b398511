// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string_view>

#include "engine/laws/catalogue.hpp"
#include "validation/quad.hpp"

// The normal laws a second time, in 113 bits, written from the original equations and sharing nothing with the
// engine. Next to every result stands the sum of the magnitudes of the terms it is made of: cancellation
// between terms is a property of the physics, so errors are measured against that sum.
namespace pulvis::validation {

/// JKR's contact radius for an overlap: the larger root of  delta = a^2/R - sqrt(2 pi W a/E), by bisection
/// (Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; in this form from Johnson, Contact Mechanics
/// (1985), section 5.5). Below the stretch at rupture it stays at the radius of rupture.
inline Quad jkr_radius(Quad overlap, Quad radius, Quad modulus, Quad work) {
  const Quad pi = quad_pi();
  const auto overlap_of = [&](Quad a) { return a * a / radius - quad_root(2 * pi * work * a / modulus); };
  Quad low = quad_cube_root(pi * work * radius * radius / (8 * modulus));  // where d(delta)/da = 0
  Quad high = low;
  while (overlap_of(high) < overlap) high *= 2;
  for (int halving = 0; halving < 130; ++halving) {
    const Quad middle = (low + high) / 2;
    (overlap_of(middle) < overlap ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Stretch at rupture, m, from a_c in delta(a).
inline Quad jkr_stretch_at_rupture(Quad radius, Quad modulus, Quad work) {
  const Quad pi = quad_pi();
  const Quad a = quad_cube_root(pi * work * radius * radius / (8 * modulus));
  return quad_root(2 * pi * work * a / modulus) - a * a / radius;
}

struct ReferenceNormal {
  Quad force = 0, terms = 0;  ///< N
  Quad contact_size = 0, damping_size = 0;
  Quad limit_shift = 0, shift_terms = 0;
  Quad plastic = 0, plastic_terms = 0, adhesion = 0;  ///< history
  /// Stiffnesses over the contact size, and f of the dashpots.
  Quad normal = 0, tangential = 0, secant = 0, damping_shape = 1;
  bool on_the_edge = false;  ///< so near a change of branch that rounding decides
};

inline Quad hertz_force(Quad overlap, Quad radius, const laws::MaterialPair& m) {
  return overlap > 0 ? Quad{4} / 3 * static_cast<Quad>(m.effective_modulus) * quad_root(radius) * overlap *
                           quad_root(overlap)
                     : Quad{0};
}

/// x^(2/5) and the like, through long double: 64 bits are enough for what is tested to 1e-12.
inline Quad quad_power(Quad x, long double y) { return std::pow(static_cast<long double>(x), y); }

inline void reference_hertz_like(ReferenceNormal& n, const laws::MaterialPair& m) {
  n.normal = 2 * static_cast<Quad>(m.effective_modulus);
  n.tangential = 8 * static_cast<Quad>(m.effective_shear_modulus);
  n.secant = Quad{4} / 3 * static_cast<Quad>(m.effective_modulus);
  n.damping_shape = quad_root(Quad{5} / 6);
}

/// Hooke: k_n delta_max^2 = m* V^2 with Hertz's largest overlap at V; or k_n as given.
inline Quad reference_spring(const laws::Touch& t, const laws::MaterialPair& m) {
  if (m.normal_stiffness > 0.0) return m.normal_stiffness;
  const Quad speed = m.characteristic_speed, mass = t.mass, radius = t.radius;
  const Quad deepest = quad_power(
      15 * mass * speed * speed / (16 * static_cast<Quad>(m.effective_modulus) * quad_root(radius)), 0.4L);
  return mass * speed * speed / (deepest * deepest);
}

inline void reference_linear(ReferenceNormal& n, Quad spring, const laws::MaterialPair& m) {
  n.contact_size = n.damping_size = spring;
  n.normal = n.secant = 1;
  n.tangential = m.tangential_ratio;
}

/// Luding (2008), eq. 6 to 8.
inline void reference_luding(ReferenceNormal& n, const laws::Touch& t, const laws::Past& old,
                             const laws::MaterialPair& m, const laws::Choices& choices) {
  const Quad k1 = reference_spring(t, m), kp = k1 * static_cast<Quad>(m.plastic_ratio),
             kc = k1 * static_cast<Quad>(m.adhesion_ratio), delta = t.overlap;
  reference_linear(n, k1, m);
  const Quad limit = kp / (kp - k1) * static_cast<Quad>(m.plasticity_depth) * 2 * static_cast<Quad>(t.radius);
  Quad largest = static_cast<Quad>(old.plastic) > delta ? static_cast<Quad>(old.plastic) : delta;
  if (largest > limit) largest = limit;
  const Quad k2 = k1 + (kp - k1) * largest / limit;
  n.force = k2 * (delta - largest) + k1 * largest;
  n.terms = k2 * (delta + largest) + k1 * largest;
  n.on_the_edge = quad_magnitude(n.force + kc * delta) < 1e-9 * n.terms;
  n.plastic = n.plastic_terms = largest;
  if (n.force < -kc * delta) {
    n.force = -kc * delta;
    // k2(x) (delta - x) + k1 x = -kc delta, by bisection between delta and the largest overlap.
    Quad low = delta, high = largest;
    for (int halving = 0; halving < 130; ++halving) {
      const Quad x = (low + high) / 2, k = k1 + (kp - k1) * x / limit;
      (k * (delta - x) + k1 * x > -kc * delta ? low : high) = x;
    }
    n.plastic = low;
  }
  n.limit_shift = choices.cohesion_limit == laws::CohesionLimit::with ? Quad{0} : kc * delta;
}

/// Thakur et al. (2014), eq. 5: branches in delta^n; the pull from W as in LIGGGHTS-PUBLIC's edinburgh.
inline void reference_edinburgh(ReferenceNormal& n, const laws::Touch& t, const laws::Past& old,
                                const laws::MaterialPair& m, const laws::Choices& choices) {
  const Quad delta = t.overlap, radius = t.radius, modulus = m.effective_modulus;
  const bool linear = choices.linear_loading;
  const auto power = [&](Quad x) { return linear ? x : x * quad_root(x); };
  const auto inverse = [&](Quad x) { return linear ? x : quad_cube_root(x) * quad_cube_root(x); };
  const auto chi = [&](Quad x) {
    return choices.adhesion_exponent == 1.0 ? x : choices.adhesion_exponent == 2.0 ? x * x : x * quad_root(x);
  };
  reference_hertz_like(n, m);
  n.contact_size = n.damping_size = linear ? radius : quad_root(radius * delta);
  if (linear) n.secant = 2 * modulus, n.damping_shape = 1;
  const Quad k1 = linear ? 2 * modulus * radius : Quad{4} / 3 * modulus * quad_root(radius);
  const Quad kappa = m.unloading_ratio, k2 = kappa * k1, f0 = m.constant_pull;
  const Quad yielded = (1 - 1 / kappa) * power(delta);
  n.on_the_edge = quad_magnitude(yielded - static_cast<Quad>(old.plastic)) < 1e-9 * yielded;
  Quad pulls = old.adhesion, adhesive = 0;
  n.plastic = old.plastic;
  const bool loads = n.plastic <= yielded;
  if (loads) {
    n.plastic = yielded;
    Quad pull = Quad{3} / 2 * quad_pi() * static_cast<Quad>(m.work_of_adhesion) *
                quad_root(2 * radius * inverse(yielded));
    if (pull > k2 * yielded / 2) pull = k2 * yielded / 2;
    pulls = pull / chi(inverse(yielded - pull / k2));
  }
  adhesive = pulls * chi(delta);
  const Quad unloading = k2 * (power(delta) - n.plastic);
  n.terms = quad_magnitude(f0) + k2 * (power(delta) + n.plastic) + adhesive;
  n.plastic_terms = n.plastic + power(delta) + adhesive / k2;
  if (!loads) n.on_the_edge |= quad_magnitude(unloading + adhesive) < 1e-9 * n.terms;
  if (!loads && unloading < -adhesive) {
    n.force = f0 - adhesive;
    n.plastic = power(delta) + adhesive / k2;
  } else {
    n.force = f0 + (loads ? k1 * power(delta) : unloading);
  }
  n.adhesion = pulls;
  if (choices.cohesion_limit != laws::CohesionLimit::with) n.limit_shift = adhesive - f0;
  n.shift_terms = n.terms;
}

/// JKR: F = 4 E a^3/(3 R) - sqrt(8 pi W E a^3).
inline void reference_jkr(ReferenceNormal& n, Quad overlap, Quad radius, const laws::MaterialPair& m,
                          const laws::Choices& choices) {
  const Quad modulus = m.effective_modulus, work = m.work_of_adhesion;
  const Quad a = jkr_radius(overlap, radius, modulus, work);
  const Quad pressed = 4 * modulus * a * a * a / (3 * radius);
  const Quad pulled = quad_root(8 * quad_pi() * work * modulus * a * a * a);
  n.contact_size = a;
  n.force = pressed - pulled;
  n.terms = pressed + pulled;
  if (choices.cohesion_limit == laws::CohesionLimit::without) {
    n.limit_shift = hertz_force(overlap, radius, m) - n.force;
    n.shift_terms = n.terms + hertz_force(overlap, radius, m);
  } else if (choices.cohesion_limit != laws::CohesionLimit::with) {
    n.limit_shift = n.shift_terms = 3 * quad_pi() * work * radius;  // 2 F_po with F_po = 3/2 pi W R
  }
}

/// The force of JKR alone, N, at an overlap in 113 bits.
inline Quad jkr_force(Quad overlap, Quad radius, const laws::MaterialPair& m) {
  ReferenceNormal n;
  reference_jkr(n, overlap, radius, m, {});
  return n.force;
}

inline ReferenceNormal reference_normal(std::string_view law, const laws::Touch& t, const laws::Past& old,
                                        const laws::MaterialPair& m, const laws::Choices& choices) {
  ReferenceNormal n;
  const Quad overlap = t.overlap, radius = t.radius, pressed = overlap > 0 ? overlap : Quad{0};
  reference_hertz_like(n, m);
  n.damping_size = n.contact_size = quad_root(radius * pressed);
  if (law == "hertz") {
    n.force = n.terms = hertz_force(overlap, radius, m);
  } else if (law == "jkr") {
    reference_jkr(n, overlap, radius, m, choices);
  } else if (!(overlap > 0)) {
    return {};
  } else if (law == "hooke") {
    n.damping_shape = 1;
    reference_linear(n, reference_spring(t, m), m);
    n.force = n.terms = n.contact_size * overlap;
  } else if (law == "luding") {
    n.damping_shape = 1;
    reference_luding(n, t, old, m, choices);
  } else if (law == "edinburgh") {
    reference_edinburgh(n, t, old, m, choices);
  }
  if (n.shift_terms == 0) n.shift_terms = quad_magnitude(n.limit_shift);
  return n;
}

}  // namespace pulvis::validation
