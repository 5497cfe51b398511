// SPDX-License-Identifier: Apache-2.0
// Test 4: 3.9 m/s on a rigid plane, under an angle from its normal, without spin.
#include <fmt/format.h>

#include <algorithm>

#include "validation/chung_ooi.hpp"

namespace pulvis::validation::chung_ooi_tests {
namespace {

using scenes::Outcome;

constexpr double speed = 3.9, friction = 0.092, restitution = 0.98, radius = 2.5e-3;
const Named materials[] = {{"aluminium oxide", {3.8e11, 0.23, 4000, radius}},
                           {"aluminium alloy", {7e10, 0.33, 2700, radius}}};

/// Digitised e_t = v_t after/v_t before; for the alloy none above 30 degrees, where the curves are one.
struct Angle {
  double angle, retained[2];
};
constexpr Angle angles[] = {{5, {0.948, 0.899}},  {10, {0.687, 0.671}}, {15, {0.624, 0.613}},
                            {20, {0.616, 0.609}}, {25, {0.634, 0.633}}, {30, {0.684, 0.683}},
                            {35, {0.737, 0.737}}, {40, {0.781, 0.781}}, {50, {0.845, 0.845}},
                            {60, {0.893, 0.893}}, {70, {0.932, 0.932}}, {80, {0.966, 0.966}},
                            {85, {0.983, 0.983}}};
/// Digitised spins after it, rad/s.
constexpr double spins[][2] = {{19.3, 35}, {213, 224}, {378, 390}, {511, 519}, {599, 599},
                               {617, 618}, {582, 582}, {545, 545}, {457, 457}, {357, 357},
                               {246, 246}, {126, 126}, {63, 63}};

Meeting meeting(const Ball& ball, double angle) {
  Meeting m{ball, {}, restitution, friction};
  m.normal_speed = speed * std::cos(angle * degree);
  m.tangential_speed = speed * std::sin(angle * degree);
  return m;
}

/// One angle against the closed form, or against the integration where slip stops; returns what was shown.
Shown at_angle(Findings& f, const Named& who, double angle) {
  const Meeting m = meeting(who.ball, angle);
  const double vt = m.tangential_speed, impulse = friction * (1.0 + restitution) * m.normal_speed;
  const Shown s = shown(m);
  const auto name = [&](const char* what) {
    return fmt::format("test 4, {}, {:g} degrees: {}", who.name, angle, what);
  };
  const auto retained = [&](const Outcome& o) { return o.velocity.x / vt; };
  const auto spin = [&](const Outcome& o) { return o.spin.y * radius / vt; };
  if (slides_throughout(m)) {
    compare_shown(f, name("e_t, sliding"), gross_sliding, 1.0 - impulse / vt, s, Compare::relative,
                  of_closed_form, retained);
    compare_shown(f, name("R omega/v_t, sliding"), gross_sliding, 2.5 * impulse / vt, s, Compare::relative,
                  of_closed_form, spin);
    compare_shown(f, name("tan(rebound), of tan(angle), sliding"), gross_sliding,
                  (1.0 - 3.5 * impulse / vt) / restitution, s, Compare::absolute, of_closed_form,
                  [&](const Outcome& o) { return o.slip / o.velocity.z * m.normal_speed / vt; });
  } else {
    const Parted reference = integrate(m);
    compare_shown(f, name("e_t, absolute"), integration, reference.velocity / vt, s, Compare::absolute,
                  of_integration, retained);
    compare_shown(f, name("R omega/v_t, absolute"), integration, reference.spin * radius / vt, s,
                  Compare::absolute, of_integration, spin);
  }
  return s;
}

void against_references(Findings& f) {
  Figure figure{"chung-ooi-4", "Test 4: tangential velocity kept", "angle of incidence (degrees)", "e_t", {}};
  Figure spin{
      "chung-ooi-4-spin", "Test 4: spin after impact", "angle of incidence (degrees)", "spin (rad/s)", {}};
  for (int k = 0; k < 2; ++k) {
    const Named& who = materials[k];
    Curve ours{fmt::format("{}, pulvis", who.name), {}, {}, true}, ours_spin = ours;
    Curve read{fmt::format("{}, digitised", who.name), {}, {}, true}, read_spin = read;
    Curve line{fmt::format("{}, integrated", who.name), {}, {}, false}, line_spin = line;
    for (std::size_t i = 0; i < std::size(angles); ++i) {
      const double angle = angles[i].angle, kept = angles[i].retained[k];
      const double vt = meeting(who.ball, angle).tangential_speed;
      const Shown s = at_angle(f, who, angle);
      const auto retained = [&](const Outcome& o) { return o.velocity.x / vt; };
      compare_shown(f, fmt::format("test 4, {}, {:g} degrees: e_t, digitised", who.name, angle), digitised,
                    kept, s, Compare::relative, 3e-2, retained);
      for (Curve* c : {&ours, &read, &ours_spin, &read_spin}) c->x.push_back(angle);
      ours.y.push_back(retained(s.fine[5]));
      ours_spin.y.push_back(s.fine[5].spin.y);
      read.y.push_back(kept);
      read_spin.y.push_back(spins[i][k]);
    }
    for (int angle = 2; angle <= 88; ++angle) {
      const Meeting m = meeting(who.ball, angle);
      const Parted p = integrate(m, 20000);
      line.x.push_back(angle), line.y.push_back(p.velocity / m.tangential_speed);
      line_spin.x.push_back(angle), line_spin.y.push_back(p.spin);
    }
    for (const Curve& c : {line, ours, read}) figure.curves.push_back(c);
    for (const Curve& c : {line_spin, ours_spin, read_spin}) spin.curves.push_back(c);
  }
  f.figure(figure);
  f.figure(spin);
}

/// The integration itself, with friction at a lever of R, against what others print of the same law.
void against_printed(Findings& f) {
  struct Line {
    double angle, retained[2], spin[2];
  };
  double worst = 0.0, worst_spin = 0.0;
  for (const Line& line : {Line{5, {0.951, 0.907}, {17, 32}}, Line{10, {0.702, 0.679}, {202, 218}},
                           Line{15, {0.633, 0.619}, {370, 384}}, Line{20, {0.623, 0.615}, {503, 514}},
                           Line{25, {0.640, 0.636}, {594, 600}}})
    for (int k = 0; k < 2; ++k) {
      const Meeting m = meeting(materials[k].ball, line.angle);
      const Parted p = integrate(m, 200000, Lever::radius);
      worst = std::max(worst, std::fabs(p.velocity / m.tangential_speed - line.retained[k]));
      worst_spin = std::max(worst_spin, std::fabs(p.spin - line.spin[k]));
    }
  f.compare("the integration, test 4, e_t, worst of 10", printed, 0.0, worst, Compare::bound, 2e-3);
  f.compare("the integration, test 4, spin, rad/s, worst of 10", printed, 0.0, worst_spin, Compare::bound,
            1.0);
}

}  // namespace

void oblique_4(Findings& f) {
  against_references(f);
  against_printed(f);
}

}  // namespace pulvis::validation::chung_ooi_tests
