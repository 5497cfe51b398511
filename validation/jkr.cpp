// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/laws/estimates.hpp"
#include "validation/chapters.hpp"
#include "validation/collisions.hpp"
#include "validation/jkr_table.hpp"

namespace pulvis::validation {
namespace {

using scenes::Collision;
using scenes::Outcome;

constexpr const char* johnson = "Johnson, Kendall, Roberts (1971), doi:10.1098/rspa.1971.0141";
constexpr const char* thornton = "Thornton, Ning (1998), doi:10.1016/S0032-5910(98)00099-0";

void sixteen_overlaps(Findings& f) {
  for (const JkrPoint& point : jkr_table()) {
    double radius_ours = 0, force_ours = 0, radius_error = 0, force_error = 0;
    for (const JkrContact& c : jkr_contacts) {
      const JkrAnswer answer = jkr_law_at(c, point.overlap);
      const double of_radius = std::fabs(answer.radius / point.radius - 1.0);
      const double of_force = std::fabs(answer.force - point.force) / point.force_terms;
      if (of_radius >= radius_error) radius_error = of_radius, radius_ours = answer.radius;
      if (of_force >= force_error) force_error = of_force, force_ours = answer.force;
    }
    Row& radius =
        f.compare(fmt::format("contact radius a/a0 at overlap {:g} delta_c", point.overlap), johnson,
                  point.radius, radius_ours, Compare::relative, point.overlap == -1 ? 1e-7 : 1e-9);
    radius.deviation = radius_error;
    Row& force = f.compare(fmt::format("force F/F_po at overlap {:g} delta_c", point.overlap), johnson,
                           point.force, force_ours, Compare::absolute, 1e-9);
    force.deviation = force_error;
  }
}

void pull_off_and_work(Findings& f) {
  for (const JkrContact& c : jkr_contacts) {
    f.compare(fmt::format("stretch at rupture delta_c, m, {}", c.name), johnson,
              0.75 * std::cbrt(square(std::numbers::pi * c.work / c.modulus) * c.radius), jkr_rupture_of(c),
              Compare::relative, 1e-9);
    double pull_off = 0.0;
    for (int k = 0; k <= 100000; ++k)
      pull_off = std::min(pull_off, jkr_law_at(c, -1.0 + 2e-5 * k).force_newton);
    f.compare(fmt::format("pull-off force, N, {}", c.name), johnson,
              1.5 * std::numbers::pi * c.work * c.radius, -pull_off, Compare::relative, 1e-4);
    const double unit = std::cbrt(std::pow(c.work, 5) * std::pow(c.radius, 4) / (c.modulus * c.modulus));
    f.compare(fmt::format("work of separation W_s (lost by touch and separation), J, {}", c.name), thornton,
              7.0922 * unit, jkr_separation_work_of(c), Compare::relative, 1e-3);
  }
}

/// Two molybdenum grains, softened to 10 MPa, that meet at `speed` without damping; v dt = delta_c/100.
Collision molybdenum(double speed, double stretch_share) {
  Collision c;
  c.material = scenes::on_rigid_plane(1e7, 0.3, 0.5, 0.0);
  c.material.effective_modulus *= 0.5;
  c.material.effective_shear_modulus *= 0.5;
  c.material.work_of_adhesion = 2e-4;
  c.parts = {"jkr", "none", "none", "none", {}};
  c.radius = 2.3e-6;
  c.density = 10200;
  c.speed = speed;
  c.dt = stretch_share *
         laws::jkr_stretch(c.reduced_radius(), c.material.effective_modulus, c.material.work_of_adhesion) /
         speed;
  return c;
}

/// Between which speeds a collision ceases to stick, m/s.
double sticking_speed_shown(double near, double stretch_share) {
  double low = 0.8 * near, high = 1.2 * near;
  for (int halving = 0; halving < 12; ++halving) {
    const double middle = 0.5 * (low + high);
    (collide(molybdenum(middle, stretch_share), 20000).separated ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

void sticking(Findings& f) {
  const Collision any = molybdenum(1.0, 0.01);
  // W_s from its closed form: v_s = sqrt(2 W_s/m*).
  const double unit = std::cbrt(std::pow(2e-4, 5) * std::pow(any.reduced_radius(), 4) /
                                square(any.material.effective_modulus));
  const double expected = std::sqrt(2.0 * 7.0922 * unit / any.reduced_mass());
  Row& speed = f.compare("sticking speed, m/s", thornton, expected, sticking_speed_shown(expected, 0.01),
                         Compare::relative, 5e-3);
  // A case takes half of delta_c/(10 v_s).
  speed.automatic = sticking_speed_shown(expected, 0.05);
  Curve theory{"sqrt(1 - (v_s/v)^2)", {}, {}, false}, ours{"pulvis", {}, {}, true};
  for (int k = 1; k <= 100; ++k) {
    theory.x.push_back(1.0 + 0.03 * k);
    theory.y.push_back(std::sqrt(1.0 - 1.0 / square(theory.x.back())));
  }
  for (const double ratio : {1.05, 1.2, 1.5, 2.0, 4.0}) {
    const double shown = collide(molybdenum(ratio * expected, 0.01)).speed / (ratio * expected);
    Row& row = f.compare(fmt::format("restitution at {:g} sticking speeds, no damping", ratio), thornton,
                         std::sqrt(1.0 - 1.0 / (ratio * ratio)), shown, Compare::absolute, 5e-3);
    row.automatic = collide(molybdenum(ratio * expected, 0.05 * ratio)).speed / (ratio * expected);
    ours.x.push_back(ratio);
    ours.y.push_back(shown);
  }
  f.figure({"jkr-restitution",
            "Restitution of an elastic adhesive collision",
            "speed / sticking speed",
            "restitution",
            {theory, ours}});
}

void curve(Findings& f) {
  Curve law{"pulvis", {}, {}, false}, points{"recomputed to 30 digits", {}, {}, true};
  for (int k = 0; k <= 600; ++k) {
    law.x.push_back(-1.0 + 0.01 * k);
    law.y.push_back(jkr_law_at(jkr_contacts[0], law.x.back()).force);
  }
  for (const JkrPoint& p : jkr_table()) {
    if (p.overlap > 5) continue;
    points.x.push_back(p.overlap);
    points.y.push_back(p.force);
  }
  f.figure({"jkr-curve",
            "Force against overlap, unloading",
            "overlap / delta_c",
            "force / pull-off force",
            {law, points}});
}

}  // namespace

void jkr(Findings& f, Effort) {
  sixteen_overlaps(f);
  pull_off_and_work(f);
  sticking(f);
  curve(f);
}

}  // namespace pulvis::validation
