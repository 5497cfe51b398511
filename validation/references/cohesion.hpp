// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string_view>

#include "engine/laws/catalogue.hpp"
#include "validation/quad.hpp"

// The laws of cohesion a second time, from their published equations, in 64 to 113 bits.
namespace pulvis::validation {

struct ReferenceCohesion {
  Quad pull = 0, terms = 0;                         ///< N
  Quad pull_off = 0;                                ///< N
  Quad viscous_normal = 0, viscous_tangential = 0;  ///< kg/s
  Quad separation_gap = 0, formation_gap = 0;       ///< m
};

inline Quad quad_exp(Quad x) { return std::exp(static_cast<long double>(x)); }
inline Quad quad_log(Quad x) { return std::log(static_cast<long double>(x)); }

/// Radius by Derjaguin: 2 r1 r2/(r1 + r2); at a wall twice the parcel's.
inline Quad derjaguin_radius(const laws::Touch& t) {
  const Quad r1 = t.radius_first, r2 = t.radius_second;
  return t.radius_second > 0.0 ? 2 * r1 * r2 / (r1 + r2) : 2 * r1;
}

inline Quad reference_bridge_volume(const laws::Touch& t, const laws::MaterialPair& m) {
  const Quad r1 = t.radius_first, r2 = t.radius_second, r = derjaguin_radius(t);
  const Quad volume = static_cast<Quad>(m.liquid_content) * 4 / 3 * quad_pi() * (r1 * r1 * r1 + r2 * r2 * r2);
  return volume < r * r * r / 10 ? volume : r * r * r / 10;
}

/// Willett et al. (2000), the full fit.
inline Quad willett_fit(Quad gap, Quad volume, Quad r, Quad sigma, Quad t) {
  const Quad l = quad_log(volume / (r * r * r)), t2 = t * t;
  const Quad f1 = (-0.44507L + 0.050832L * t - 1.1466L * t2) + (-0.1119L - 0.000411L * t - 0.1490L * t2) * l +
                  (-0.012101L - 0.0036456L * t - 0.01255L * t2) * l * l +
                  (-0.0005L - 0.0003505L * t - 0.00029076L * t2) * l * l * l;
  const Quad f2 = (1.9222L - 0.57473L * t - 1.2918L * t2) + (-0.0668L - 0.1201L * t - 0.22574L * t2) * l +
                  (-0.0013375L - 0.0068988L * t - 0.01137L * t2) * l * l;
  const Quad f3 = (1.268L - 0.01396L * t - 0.23566L * t2) + (0.198L + 0.092L * t - 0.06418L * t2) * l +
                  (0.02232L + 0.02238L * t - 0.009853L * t2) * l * l +
                  (0.0008585L + 0.001318L * t - 0.00053L * t2) * l * l * l;
  const Quad f4 = (-0.010703L + 0.073776L * t - 0.34742L * t2) +
                  (0.03345L + 0.04543L * t - 0.09056L * t2) * l +
                  (0.0018574L + 0.004456L * t - 0.006257L * t2) * l * l;
  const Quad force = 2 * quad_pi() * r * sigma;
  if (!(gap > 0)) return force * quad_exp(f1);
  const Quad s = quad_log(gap / 2 / quad_root(volume / r));
  return force * quad_exp(f1 - f2 * quad_exp(f3 * s + f4 * s * s));
}

/// Willett et al. (2000), the closed form.
inline Quad willett_closed(Quad gap, Quad volume, Quad r, Quad sigma, Quad t) {
  const Quad s = gap / 2 / quad_root(volume / r);
  return 2 * quad_pi() * r * sigma * static_cast<Quad>(std::cos(static_cast<long double>(t))) /
         (1 + Quad{21} / 10 * s + 10 * s * s);
}

/// Rabinovich et al. (2005).
inline Quad rabinovich(Quad gap, Quad volume, Quad r, Quad sigma, Quad t) {
  const Quad h = gap > 0 ? gap : r * static_cast<Quad>(1e-15L);
  const Quad ring = -1 + quad_root(1 + 2 * volume / (quad_pi() * r * h * h));
  const Quad d = h / 2 * ring, alpha = quad_root(h / r * ring);
  const auto sine = [](Quad x) { return static_cast<Quad>(std::sin(static_cast<long double>(x))); };
  const Quad cosine = std::cos(static_cast<long double>(t));
  return 2 * quad_pi() * r * sigma * (cosine / (1 + h / (2 * d)) + sine(alpha) * sine(alpha + t));
}

/// Soulie et al. (2006).
inline Quad soulie(Quad gap, Quad volume, Quad r1, Quad r2, Quad sigma, Quad t) {
  const Quad larger = r1 > r2 ? r1 : r2, l = quad_log(volume / (larger * larger * larger));
  const Quad a = -1.1L * quad_exp(-0.53L * l);
  const Quad b = (-0.148L * l - 0.96L) * t * t - 0.0082L * l + 0.48L, c = 0.0018L * l + 0.078L;
  return quad_pi() * sigma * quad_root(r1 * r2) * (c + quad_exp(a * gap / larger + b));
}

inline Quad bridge_force(std::string_view law, Quad gap, const laws::Touch& t, const laws::MaterialPair& m) {
  const Quad r = derjaguin_radius(t), volume = reference_bridge_volume(t, m);
  const Quad sigma = m.surface_tension, angle = m.contact_angle;
  if (law == "capillary_willett") return willett_fit(gap, volume, r, sigma, angle);
  if (law == "capillary_willett_closed") return willett_closed(gap, volume, r, sigma, angle);
  if (law == "capillary_rabinovich") return rabinovich(gap, volume, r, sigma, angle);
  const bool wall = t.radius_second == 0.0;
  return soulie(gap, volume, wall ? r : Quad{t.radius_first}, wall ? r : Quad{t.radius_second}, sigma, angle);
}

inline ReferenceCohesion reference_bridge(std::string_view law, const laws::Touch& t,
                                          const laws::MaterialPair& m, const laws::Choices& choices) {
  ReferenceCohesion c;
  const Quad gap = t.overlap < 0.0 ? -static_cast<Quad>(t.overlap) : Quad{0};
  const Quad r = derjaguin_radius(t), reduced = r / 2, volume = reference_bridge_volume(t, m);
  c.pull = bridge_force(law, gap, t, m);
  c.pull_off = bridge_force(law, 0, t, m);
  const Quad third = quad_cube_root(volume / (r * r * r));
  c.separation_gap = r * (1 + static_cast<Quad>(m.contact_angle) / 2) * (third + third * third / 10);
  c.formation_gap = choices.bridges_form_on_approach ? c.separation_gap : Quad{0};
  Quad q = gap / reduced;
  if (q < static_cast<Quad>(m.shortest_bridge_gap)) q = m.shortest_bridge_gap;
  const Quad drag = 6 * quad_pi() * static_cast<Quad>(m.liquid_viscosity) * reduced;
  c.viscous_normal = drag / q;
  const Quad shear = Quad{8} / 15 * quad_log(1 / q) + static_cast<Quad>(0.9588L);
  c.viscous_tangential = shear > 0 ? drag * shear : Quad{0};
  return c;
}

inline ReferenceCohesion reference_cohesion(std::string_view law, const laws::Touch& t,
                                            const laws::MaterialPair& m, const laws::Choices& choices) {
  ReferenceCohesion c;
  const Quad radius = t.radius, delta = t.overlap > 0.0 ? t.overlap : 0.0, pi = quad_pi();
  const Quad density = m.cohesion_energy_density;
  if (law.starts_with("capillary")) {
    c = reference_bridge(law, t, m, choices);
  } else if (law == "dmt") {
    c.pull = c.pull_off = 2 * pi * static_cast<Quad>(m.work_of_adhesion) * radius;
  } else if (law == "sjkr" && t.radius_second > 0.0) {
    // The circle in which two spheres cut each other.
    const Quad r1 = t.radius_first, r2 = t.radius_second, r = r1 + r2 - delta;
    c.pull = density * pi / 4 * delta * (r + r1 - r2) * (r - r1 + r2) * (r + r1 + r2) / (r * r);
  } else if (law == "sjkr") {
    const Quad r1 = t.radius_first, r = r1 - delta;
    c.pull = density * pi * (r1 * r1 - r * r);
  } else if (law.starts_with("sjkr2")) {
    const bool twice = law == "sjkr2_twice_reduced_radius" && t.radius_second > 0.0;
    c.pull = density * 2 * pi * delta * radius * (twice ? 2 : 1);
  } else if (law == "hamaker") {
    const Quad shortest = m.shortest_gap, gap = -static_cast<Quad>(t.overlap);
    const Quad a = m.hamaker_constant, h = gap > shortest ? gap : shortest;
    c.pull = a * radius / (6 * h * h);
    c.pull_off = a * radius / (6 * shortest * shortest);
    c.separation_gap = c.formation_gap = m.longest_gap;
  }
  c.terms = c.pull;
  return c;
}

}  // namespace pulvis::validation
