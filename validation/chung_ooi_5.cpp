// SPDX-License-Identifier: Apache-2.0
// Test 5: 5 m/s along the normal of a rigid plane and some speed along it, elastic, without spin.
#include <fmt/format.h>

#include <algorithm>

#include "validation/chung_ooi.hpp"

namespace pulvis::validation::chung_ooi_tests {
namespace {

using scenes::Outcome;

constexpr double normal_speed = 5.0, friction = 0.3, unit = friction * normal_speed, radius = 1e-5;
const Named materials[] = {{"steel", {2.08e11, 0.30, 7850, radius}},
                           {"polyethylene", {1e9, 0.40, 1400, radius}}};
const std::string with_half_stiffness = fmt::format("{}; made with half of Mindlin's stiffness", digitised);
constexpr double none = -100.0;

/// psi = slip/(mu v_n) before; after: digitised, and printed by others for the law as it is here.
struct Sliding {
  double before, read[2], law[2];
};
constexpr Sliding cases[] = {
    {0.33, {-0.28, -0.29}, {0.315, 0.260}},   {0.67, {-0.49, none}, {0.628, 0.475}},
    {1.0, {-0.75, -0.88}, {0.667, 0.477}},    {1.34, {-1.0, none}, {0.360, 0.168}},
    {1.66, {-1.27, none}, {0.041, -0.150}},   {2.0, {-1.53, -1.76}, {-0.276, -0.465}},
    {2.35, {-1.81, none}, {-0.567, -0.750}},  {3.0, {-2.44, -2.68}, {-1.001, -1.170}},
    {3.34, {-2.69, -2.95}, {-1.173, -1.332}}, {4.0, {-2.79, -2.93}, {-1.398, -1.532}},
    {5.0, {-2.0, -2.0}, {-1.436, -1.519}},    {6.0, {-1.01, none}, {-0.981, -0.994}},
    {7.0, {none, none}, {none, none}},        {8.0, {none, none}, {none, none}},
    {10.0, {3.01, 3.0}, {3.0, 3.0}},          {13.0, {6.01, none}, {6.0, none}}};
/// Points of the paper's finite element computation, as digitised there.
constexpr double finite_elements[][2] = {
    {0.27, -0.03}, {0.59, -0.03}, {0.88, -0.08}, {1.19, -0.21}, {1.55, -0.37}, {1.92, -0.63}, {2.31, -0.95},
    {2.79, -1.25}, {3.32, -1.52}, {3.97, -1.72}, {4.76, -1.71}, {5.76, -1.20}, {7.12, 0.13},  {9.12, 2.15}};

Meeting meeting(const Ball& ball, double psi) {
  Meeting m{ball, {}, 1.0, friction};
  m.normal_speed = normal_speed;
  m.tangential_speed = psi * unit;
  return m;
}

/// The published closed form has the friction act at R from the centre. It acts at R - delta, and while the sphere
/// slides its impulse has the mean lever R - w delta_max, with the weight of delta by Hertz's force
/// w = B(7/5, 1/2)/B(1, 1/2) = 0.8175 over an elastic impact.
double lever_share(const Meeting& m) {
  const double weight = 0.5 * std::tgamma(1.4) * std::tgamma(0.5) / std::tgamma(1.9);
  return 1.0 - weight * m.largest_overlap() / m.first.radius;
}

Shown at_speed(Findings& f, const Named& who, double before) {
  const Meeting m = meeting(who.ball, before);
  const Shown s = shown(m);
  const auto name = [&](const char* what) {
    return fmt::format("test 5, {}, psi_1 = {:g}: {}", who.name, before, what);
  };
  const auto after = [](const Outcome& o) { return o.slip / unit; };
  const auto change = [&](const Outcome& o) { return before - o.slip / unit; };
  const auto spin = [](const Outcome& o) { return o.spin.y * radius / unit; };
  if (!slides_throughout(m)) {
    compare_shown(f, name("psi_2, absolute (of mu v_n)"), integration, integrate(m).slip / unit, s,
                  Compare::absolute, of_integration, after);
    return s;
  }
  const auto sliding = [&](const char* what, double reference, auto value) {
    compare_shown(f, name(what), gross_sliding, reference, s, Compare::relative, of_closed_form, value);
  };
  sliding("psi_1 - psi_2, sliding", 7.0, change);
  sliding("psi_1 - psi_2, sliding, lever R - delta", 2.0 + 5.0 * lever_share(m), change);
  sliding("R omega/(mu v_n), sliding", 5.0, spin);
  sliding("R omega/(mu v_n), sliding, lever R - delta", 5.0 * lever_share(m), spin);
  return s;
}

void against_references(Findings& f) {
  for (int k = 0; k < 2; ++k) {
    const Named& who = materials[k];
    Figure figure{fmt::format("chung-ooi-5-{}", who.name),
                  fmt::format("Test 5: slip, {}", who.name),
                  "psi_1, before",
                  "psi_2, after",
                  {}};
    Curve ours{"pulvis", {}, {}, true}, read{"digitised DEM", {}, {}, true},
        line{"integrated", {}, {}, false}, elements{"digitised FEM", {}, {}, true};
    for (const Sliding& c : cases) {
      const Shown s = at_speed(f, who, c.before);
      const auto after = [](const Outcome& o) { return o.slip / unit; };
      ours.x.push_back(c.before), ours.y.push_back(after(s.fine[5]));
      if (c.read[k] == none) continue;
      read.x.push_back(c.before), read.y.push_back(c.read[k]);
      compare_shown(f, fmt::format("test 5, {}, psi_1 = {:g}: psi_2, digitised", who.name, c.before),
                    with_half_stiffness, c.read[k], s, Compare::absolute, {}, after);
    }
    for (int i = 1; i <= 130; ++i) {
      line.x.push_back(0.1 * i);
      line.y.push_back(integrate(meeting(who.ball, 0.1 * i), 20000).slip / unit);
    }
    for (const auto& point : finite_elements) elements.x.push_back(point[0]), elements.y.push_back(point[1]);
    figure.curves = {line, ours, read, elements};
    f.figure(figure);
  }
}

void against_printed(Findings& f) {
  double worst = 0.0;
  for (const Sliding& c : cases)
    for (int k = 0; k < 2; ++k) {
      if (c.law[k] == none) continue;
      const Parted p = integrate(meeting(materials[k].ball, c.before), 200000, Lever::radius);
      worst = std::max(worst, std::fabs(p.slip / unit - c.law[k]));
    }
  f.compare("the integration, test 5, psi_2, worst of 27", printed, 0.0, worst, Compare::bound, 6e-4);
}

}  // namespace

void oblique_5(Findings& f) {
  against_references(f);
  against_printed(f);
}

}  // namespace pulvis::validation::chung_ooi_tests
