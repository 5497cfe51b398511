// SPDX-License-Identifier: Apache-2.0
// What is found from the laws by asking them, against closed forms.
#include "single_contact/adhesion.hpp"

#include <gtest/gtest.h>

#include "tests/single_contact/sample_contacts.hpp"

using namespace pulvis;
using namespace pulvis::testing;
using single_contact::Adhesion;
using single_contact::adhesion;

namespace {

void expect_close(double value, double expected, double relative, const std::string& what) {
  EXPECT_NEAR(value, expected, relative * std::abs(expected)) << what;
}

TEST(Adhesion, OfHertzAndHookeIsNone) {
  for (const char* normal : {"hertz", "hooke"}) {
    const Adhesion a = adhesion(contact_of(normal), 1e-9);
    EXPECT_TRUE(a.holds);
    EXPECT_EQ(a.pull_off, 0.0);
    EXPECT_EQ(a.zero_force_overlap, 0.0);
    EXPECT_EQ(a.separation_work, 0.0);
    EXPECT_EQ(a.lost_work, 0.0);
  }
}

TEST(Adhesion, UnderAForceTheOverlapIsThatOfTheClosedForms) {
  const double force = 3e-9;
  expect_close(*contact_of("hertz").overlap_under(force),
               laws::hertz_overlap_under(force, reduced_radius, effective), 1e-12, "Hertz");
  expect_close(*contact_of("jkr").overlap_under(force),
               laws::jkr_overlap_under(force, reduced_radius, effective, work), 1e-12, "JKR");
  const double k = laws::linear_stiffness(reduced_mass, reduced_radius, effective, 0.05);
  expect_close(*contact_of("hooke").overlap_under(force), force / k, 1e-12, "Hooke");
  EXPECT_EQ(adhesion(contact_of("hertz"), force).pressed_overlap, *contact_of("hertz").overlap_under(force));
}

TEST(Adhesion, OfJkrIsThatOfTheClosedForms) {
  for (const auto& bodies : {grains, grain_at_wall}) {
    const auto contact = contact_of("jkr", "none", sample_material(), {}, bodies);
    const double r = contact.radius(), stretch = laws::jkr_stretch(r, effective, work),
                 pull = laws::jkr_pull_off(r, work);
    const Adhesion a = adhesion(contact);
    expect_close(a.pull_off, pull, 1e-12, "pull-off");
    expect_close(a.zero_force_overlap, laws::jkr_zero_force_overlap(r, effective, work), 1e-12, "zero force");
    // F d(delta) over y of normal/jkr.hpp, from rupture (1) to a place.
    const auto until = [&](double y) {
      const auto p = [](double x) { return std::pow(x, 10) / 10 - std::pow(x, 7) + 1.5 * std::pow(x, 4); };
      return -4.0 / 27.0 * (p(y) - p(1.0)) * pull * stretch;
    };
    expect_close(a.lost_work, until(std::cbrt(4.0)), 1e-8, "a touch and separation");
    expect_close(a.lost_work, laws::jkr_separation_work(r, effective, work), 1e-5, "7.0922");
    expect_close(a.separation_work, until(std::cbrt(6.0)), 1e-8, "from rest to separation");
  }
}

TEST(Adhesion, OfDmtIsItsConstantPull) {
  const Adhesion a = adhesion(contact_of("hertz", "dmt"));
  const double pull = 2.0 * M_PI * work * reduced_radius;
  const double rest = laws::hertz_overlap_under(pull, reduced_radius, effective);
  expect_close(a.pull_off, pull, 1e-12, "pull-off");
  expect_close(a.zero_force_overlap, rest, 1e-12, "zero force");
  expect_close(a.separation_work, 0.6 * pull * rest, 1e-8, "pull minus Hertz, over the overlap");
  EXPECT_EQ(a.lost_work, 0.0) << "conservative";
}

TEST(Adhesion, OfSjkr2OnHertzIsThatOfItsPage) {
  const double kc = sample_material().cohesion_energy_density;
  for (const auto& [name, f] :
       {std::pair{"sjkr2_reduced_radius", 1.0}, {"sjkr2_twice_reduced_radius", 2.0}}) {
    const Adhesion a = adhesion(contact_of("hertz", name));
    expect_close(a.zero_force_overlap, std::pow(1.5 * M_PI * f * kc / effective, 2) * reduced_radius, 1e-11,
                 name);
    expect_close(a.pull_off, 2.0 / 3.0 * std::pow(M_PI * f * kc, 3) * std::pow(reduced_radius / effective, 2),
                 1e-10, name);
    EXPECT_EQ(a.lost_work, 0.0);
  }
}

TEST(Adhesion, OfSjkr2OnHookeIsNoneOrACollapse) {
  laws::MaterialPair m = sample_material();
  m.normal_stiffness = 1.0;
  const double limit = m.normal_stiffness / (2.0 * M_PI * reduced_radius);
  m.cohesion_energy_density = 0.99 * limit;
  const Adhesion below = adhesion(contact_of("hooke", "sjkr2_reduced_radius", m));
  EXPECT_TRUE(below.holds);
  EXPECT_EQ(below.pull_off, 0.0);
  m.cohesion_energy_density = 1.01 * limit;
  const Adhesion above = adhesion(contact_of("hooke", "sjkr2_reduced_radius", m));
  EXPECT_FALSE(above.holds);
  EXPECT_EQ(above.pull_off, 0.0);
}

TEST(Adhesion, OfHamakerIsItsWell) {
  const laws::MaterialPair m = sample_material();
  const double scale = m.hamaker_constant * reduced_radius / 6.0, near = m.shortest_gap, far = m.longest_gap;
  const Adhesion a = adhesion(contact_of("hertz", "hamaker"));
  const double pull = scale / (near * near),
               rest = laws::hertz_overlap_under(pull, reduced_radius, effective);
  expect_close(a.pull_off, pull, 1e-12, "pull-off");
  expect_close(a.zero_force_overlap, rest, 1e-12, "zero force");
  expect_close(a.separation_work, 0.6 * pull * rest + scale * (2.0 / near - 1.0 / far), 1e-7, "work");
  EXPECT_EQ(a.lost_work, 0.0) << "the tail is there on approach too";
}

TEST(Adhesion, OfABridgeLosesItsWorkOnlyIfItFormsOnTouch) {
  laws::Choices approach;
  approach.bridges_form_on_approach = true;
  const auto touch_formed = contact_of("hertz", "capillary_willett_closed"),
             early = contact_of("hertz", "capillary_willett_closed", sample_material(), approach);
  const laws::MaterialPair m = sample_material();
  const double r = 2.0 * reduced_radius, volume = 8.0 / 3.0 * M_PI * m.liquid_content * std::pow(radius, 3);
  const double pull = 2.0 * M_PI * r * m.surface_tension * std::cos(m.contact_angle);
  // Integral of 1/(1 + 2.1 S + 10 S^2), S = h/(2 sqrt(V/R)).
  const double unit = std::sqrt(volume / r), end = 0.5 * touch_formed.separation_gap() / unit,
               root = std::sqrt(40.0 - 2.1 * 2.1);
  const auto primitive = [&](double s) { return 2.0 / root * std::atan((20.0 * s + 2.1) / root); };
  const double taken = pull * 2.0 * unit * (primitive(end) - primitive(0.0));
  expect_close(adhesion(touch_formed).pull_off, pull, 1e-9, "pull-off");
  expect_close(adhesion(touch_formed).lost_work, taken, 1e-7, "work");
  EXPECT_EQ(adhesion(early).lost_work, 0.0);
  EXPECT_EQ(adhesion(early).separation_work, adhesion(touch_formed).separation_work);
  EXPECT_EQ(early.formation_gap(), early.separation_gap());
}

TEST(Adhesion, OfLudingIsThatOfItsTriangles) {
  const laws::MaterialPair m = sample_material();
  const auto contact = contact_of("luding");
  const double k1 = laws::linear_stiffness(reduced_mass, reduced_radius, effective, 0.05),
               kc = m.adhesion_ratio * k1;
  const double deepest =
      m.plastic_ratio / (m.plastic_ratio - 1.0) * m.plasticity_depth * 2.0 * reduced_radius;
  const double load = 0.3 * k1 * deepest, largest = load / k1, k2 = k1 + (m.plastic_ratio - 1.0) * k1 * 0.3;
  const Adhesion a = adhesion(contact, load);
  expect_close(a.pressed_overlap, largest, 1e-12, "pressed");
  const double rest = (1.0 - k1 / k2) * largest, turn = (k2 - k1) / (k2 + kc) * largest;
  expect_close(a.zero_force_overlap, rest, 1e-9, "zero force");
  expect_close(a.pull_off, kc * turn, 1e-6, "strongest pull, at a kink");
  expect_close(a.separation_work, 0.5 * kc * turn * rest, 1e-8, "work");
  expect_close(a.lost_work, 0.5 * load * largest - 0.5 * load * (largest - rest) + 0.5 * kc * turn * rest,
               1e-8, "area between the branches");
  EXPECT_EQ(adhesion(contact).pull_off, 0.0) << "never pressed, never sticky";
}

TEST(Adhesion, OfEdinburghIsTheConstantPullWhereItWasNeverPressed) {
  const Adhesion untouched = adhesion(contact_of("edinburgh"));
  EXPECT_GT(untouched.pull_off, 1e-11) << "it yields a little under its own pull";
  const Adhesion pressed = adhesion(contact_of("edinburgh"), 5e-9);
  EXPECT_GT(pressed.pull_off, untouched.pull_off);
  EXPECT_LT(pressed.zero_force_overlap, pressed.pressed_overlap);
  EXPECT_GT(pressed.lost_work, pressed.separation_work);
}

TEST(Adhesion, IsTheSameWhetherAContactIsPulledAtOnceOrStepByStep) {
  // What the works and the pull-off force rest on.
  for (const auto& [name, contact] : all_contacts()) {
    const double deep = *contact.overlap_under(5e-9);
    const laws::Past at_once = contact.pressed_to(deep);
    laws::Past stepped = contact.pressed_to(deep);
    const double end = -0.99 * contact.separation_gap();
    for (int k = 1; k < 200; ++k) {
      const double x = deep + (end - deep) * k / 200.0;
      const auto response = contact.in_motion(x, 0, true, stepped, 0);
      const double force = contact.unloading(x, at_once);
      ASSERT_NEAR(single_contact::push(response), force, 1e-9 * (std::abs(force) + 5e-9))
          << name << " at " << x;
      stepped = response.history;
    }
  }
}

}  // namespace
