// SPDX-License-Identifier: Apache-2.0
#include "validation/jkr_table.hpp"

#include "engine/laws/estimates.hpp"
#include "validation/references/law.hpp"

namespace pulvis::validation {
namespace {

Quad radius_at(double overlap) {
  const auto overlap_of = [](Quad x) { return quad_cube_root(6) * (2 * x * x - Quad{4} / 3 * quad_root(x)); };
  Quad low = 1 / quad_cube_root(36), high = 10;
  for (int halving = 0; halving < 130; ++halving) {
    const Quad middle = (low + high) / 2;
    (overlap_of(middle) < overlap ? low : high) = middle;
  }
  return (low + high) / 2;
}

laws::Law plain_jkr() { return laws::find_law("jkr", "none", "none", "none"); }

laws::PairConstants constants_of(const JkrContact& c) {
  laws::MaterialPair m;
  m.effective_modulus = c.modulus;
  m.effective_shear_modulus = 0.3 * c.modulus;
  m.work_of_adhesion = c.work;
  return plain_jkr().mix(m, {});
}

}  // namespace

std::vector<JkrPoint> jkr_table() {
  std::vector<JkrPoint> table;
  for (const double overlap :
       {-1.0, -0.99, -0.9, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 1.0, 1.2114, 2.0, 3.0, 5.0, 10.0, 100.0}) {
    const Quad x = radius_at(overlap), pressed = 4 * x * x * x, pulled = 4 * x * quad_root(x);
    table.push_back({overlap, static_cast<double>(x), static_cast<double>(pressed - pulled),
                     static_cast<double>(pressed + pulled)});
  }
  return table;
}

JkrAnswer jkr_law_at(const JkrContact& c, double overlap) {
  const Quad radius = c.radius, modulus = c.modulus, work = c.work, pi = quad_pi();
  const Quad stretch = jkr_stretch_at_rupture(radius, modulus, work);
  const Quad zero_force_radius = quad_cube_root(9 * pi * work * radius * radius / (2 * modulus));
  const Quad pull_off = Quad{3} / 2 * pi * work * radius;
  const auto constants = constants_of(c);
  const double metres = overlap == -1 ? -plain_jkr().separation_gap(c.radius, constants)
                                      : static_cast<double>(overlap * stretch);
  const laws::Normal ours = plain_jkr().normal_force(metres, c.radius, constants);
  return {static_cast<double>(ours.contact_size / zero_force_radius),
          static_cast<double>(ours.elastic / pull_off), ours.elastic};
}

double jkr_rupture_of(const JkrContact& c) { return plain_jkr().separation_gap(c.radius, constants_of(c)); }

double jkr_separation_work_of(const JkrContact& c) {
  // delta = -delta_c (1 - u^2): the square root at rupture becomes smooth in u.
  const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
  const auto constants = constants_of(c);
  constexpr int panels = 2000;
  double sum = 0.0;
  for (int k = 0; k <= panels; ++k) {
    const double u = static_cast<double>(k) / panels;
    const double pull = -plain_jkr().normal_force(-stretch * (1.0 - u * u), c.radius, constants).elastic;
    sum += pull * 2.0 * u * stretch * (k == 0 || k == panels ? 1.0 : k % 2 ? 4.0 : 2.0);
  }
  return sum / (3.0 * panels);
}

}  // namespace pulvis::validation
