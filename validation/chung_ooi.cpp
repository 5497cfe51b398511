// SPDX-License-Identifier: Apache-2.0
// Tests 1 to 3: head-on impacts.
#include "validation/chung_ooi.hpp"

#include <fmt/format.h>

namespace pulvis::validation {
namespace chung_ooi_tests {
namespace {

using scenes::Outcome;

constexpr const char* johnson =
    "Johnson (1985), doi:10.1017/CBO9781139171731, section 11.4; test of Chung, Ooi (2011)";

const Ball glass{4.8e10, 0.20, 2800, 0.01}, limestone{2.0e10, 0.25, 2500, 0.01};
const Ball aluminium_alloy{7.0e10, 0.30, 2699, 0.1}, magnesium_alloy{4.0e10, 0.35, 1800, 0.1};
const Ball aluminium_oxide{3.8e11, 0.23, 4000, 0.0025}, cast_iron{1.0e11, 0.25, 7000, 0.0025};

/// Without loss of energy.
Meeting elastic(const Ball& ball, bool pair, double speed, double friction) {
  Meeting m{ball, {}, 1.0, friction};
  if (pair) m.second = ball;
  m.normal_speed = speed;
  return m;
}

/// Force against overlap, loading and unloading.
Curve course_of(std::string name, const Outcome& o) {
  Curve c{std::move(name), {}, {}, true};
  for (std::size_t k = 0; k < o.course.size(); k += 25) {
    c.x.push_back(1e6 * o.course[k].overlap);
    c.y.push_back(o.course[k].force);
  }
  return c;
}
Curve hertz_of(std::string name, const Meeting& m) {
  Curve c{std::move(name), {}, {}, false};
  for (int k = 0; k <= 100; ++k) {
    c.x.push_back(1e6 * m.largest_overlap() * 0.01 * k);
    c.y.push_back(m.largest_force() * std::pow(0.01 * k, 1.5));
  }
  return c;
}

void peaks(Findings& f) {
  struct Case {
    int test;
    const char* name;
    Meeting meeting;
  };
  Figure figures[] = {
      {"chung-ooi-1", "Test 1: two spheres at 20 m/s", "overlap (um)", "force (N)", {}},
      {"chung-ooi-2", "Test 2: a sphere on a rigid plane at 0.2 m/s", "overlap (um)", "force (N)", {}}};
  for (const Case& c : {Case{1, "glass", elastic(glass, true, 20.0, 0.35)},
                        Case{1, "limestone", elastic(limestone, true, 20.0, 0.35)},
                        Case{2, "aluminium alloy", elastic(aluminium_alloy, false, 0.2, 0.0)},
                        Case{2, "magnesium alloy", elastic(magnesium_alloy, false, 0.2, 0.0)},
                        Case{3, "aluminium oxide", elastic(aluminium_oxide, false, 3.9, 0.0)},
                        Case{3, "cast iron", elastic(cast_iron, false, 3.9, 0.0)}}) {
    const Meeting& m = c.meeting;
    const Shown s = shown(m);
    const auto row = [&](const char* what, double reference, auto value) {
      compare_shown(f, fmt::format("test {}, {}: {}", c.test, c.name, what), johnson, reference, s,
                    Compare::relative, 1e-3, value);
    };
    row("largest force, N", m.largest_force(), [](const Outcome& o) { return o.largest_force; });
    row("largest overlap, m", m.largest_overlap(), [](const Outcome& o) { return o.largest_overlap; });
    row("duration, s", m.duration(), [](const Outcome& o) { return o.duration; });
    if (c.test > 2) continue;
    figures[c.test - 1].curves.push_back(hertz_of(fmt::format("{}, Hertz", c.name), m));
    figures[c.test - 1].curves.push_back(course_of(fmt::format("{}, pulvis", c.name), s.fine[0]));
  }
  for (const Figure& figure : figures) f.figure(figure);
}

void restitution_of_test_3(Findings& f) {
  for (const Named& who : {Named{"aluminium oxide", aluminium_oxide}, Named{"cast iron", cast_iron}})
    for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      Meeting m = elastic(who.ball, false, 3.9, 0.0);
      m.restitution = e;
      compare_shown(f, fmt::format("test 3, {}: restitution {:g}", who.name, e), paper, e, shown(m),
                    Compare::relative, of_closed_form, [](const Outcome& o) { return o.speed / 3.9; });
    }
}

}  // namespace

void head_on(Findings& f) {
  peaks(f);
  restitution_of_test_3(f);
}

}  // namespace chung_ooi_tests

void chung_ooi(Findings& f, Effort /*takes seconds*/) {
  chung_ooi_tests::head_on(f);
  chung_ooi_tests::oblique_4(f);
  chung_ooi_tests::oblique_5(f);
  chung_ooi_tests::spinning(f);
}

}  // namespace pulvis::validation
