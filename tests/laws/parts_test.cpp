// SPDX-License-Identifier: Apache-2.0
// Sliding, rolling and twisting laws in plain situations, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/plain_touch.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

laws::MaterialPair rubber() {
  laws::MaterialPair m;
  m.effective_modulus = 1e7;
  m.effective_shear_modulus = 3e6;
  m.friction = 0.4;
  m.rolling_friction = 0.1;
  m.rolling_viscosity = 0.3;
  m.twisting_friction = 0.2;
  m.restitution = 0.5;
  return m;
}

laws::Response answer(const laws::Law& law, const laws::Touch& t, const laws::Past& h = {},
                      const laws::Choices& choices = {}) {
  return law.evaluate(t, h, law.mix(rubber(), choices));
}
laws::Law sliding(const char* name, const char* damping = "none") {
  return laws::find_law("hertz", damping, name, "none");
}
laws::Law rolling(const char* name, const char* twisting = "none") {
  return laws::find_law("hertz", "none", "none", name, "none", twisting);
}
constexpr double radius = 0.5e-3;
double grip(double overlap) { return std::sqrt(radius * overlap); }
double pressed(double overlap) { return 4.0 / 3.0 * 1e7 * std::sqrt(radius) * std::pow(overlap, 1.5); }

TEST(SlidingSprings, DifferWhereAContactOpensOrCloses) {
  // Loaded in shear at one overlap, then the overlap changes without slip.
  for (const double overlap : {4e-5, 2.5e-6}) {
    const double before = 8.0 * 3e6 * grip(1e-5) * 1e-8, now = 8.0 * 3e6 * grip(overlap) * 1e-8;
    for (const auto& [name, expected] : {std::pair{"total_spring", now},
                                         {"incremental_spring", before},
                                         {"rescaled_spring", std::fmin(now, before)}}) {
      const laws::Law law = sliding(name);
      laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
      t.velocity = {1e-8 / t.dt, 0, 0};
      laws::Response r = answer(law, t);
      EXPECT_NEAR(-r.force.x, before, 1e-9 * before) << name;
      t.velocity = {};
      t.overlap = overlap;
      r = answer(law, t, r.history);
      EXPECT_NEAR(-r.force.x, expected, 1e-9 * expected) << name << overlap;
    }
  }
}

TEST(RescaledSpring, GivesNoMoreBackThanWasPutIn) {
  // Sheared at a deep overlap, then unsheared at a shallow one: the incremental spring gains energy.
  const auto gain = [](const char* name) {
    const laws::Law law = sliding(name);
    laws::Touch t = touch_of(1e-3, 1e-3, 4e-5);
    laws::Past h;
    double work = 0.0;
    const auto move = [&](double step) {
      t.velocity = {step / t.dt, 0, 0};
      const laws::Response r = answer(law, t, h);
      work += r.force.x * step;
      h = r.history;
    };
    for (int k = 0; k < 100; ++k) move(1e-10);
    t.overlap = 1e-5;
    for (int k = 0; k < 100; ++k) move(-1e-10);
    return work;
  };
  EXPECT_GT(gain("incremental_spring"), 0.0);
  EXPECT_LE(gain("rescaled_spring"), 0.0);
}

TEST(SlidingSprings, TurnWithASpinThatBothBodiesShare) {
  for (const char* name : {"total_spring", "incremental_spring", "rescaled_spring"}) {
    const laws::Law law = sliding(name);
    laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
    t.velocity = {1e-8 / t.dt, 0, 0};
    laws::Response r = answer(law, t);
    const double force = r.force.x;
    t.velocity = {};
    t.shared_spin = 1.5707963267948966 / (1000 * t.dt);  // a quarter turn in 1000 steps
    for (int k = 0; k < 1000; ++k) r = answer(law, t, r.history);
    EXPECT_NEAR(r.force.y, force, 1e-6 * std::fabs(force)) << name;
    EXPECT_NEAR(r.force.x, 0.0, 1e-6 * std::fabs(force)) << name;
  }
}

TEST(SlidingSprings, HaveADashpotUnlessAskedNotTo) {
  for (const char* name : {"total_spring", "incremental_spring", "rescaled_spring"}) {
    laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
    t.velocity = {1e-5, 0, 0};
    laws::Choices without;
    without.tangential_damping = false;
    const double damped = answer(sliding(name, "restitution"), t).force.x;
    EXPECT_LT(damped, answer(sliding(name), t).force.x) << name;
    EXPECT_EQ(answer(sliding(name, "restitution"), t, {}, without).force.x, answer(sliding(name), t).force.x);
  }
}

TEST(ViscousSliding, IsLimitedByCoulombAndRemembersNothing) {
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  t.velocity = {1.0, 0, 0};
  laws::Past h;
  h.slide = {1e-6, 0, 0};
  const laws::Response r = answer(sliding("viscous", "restitution"), t, h);
  EXPECT_NEAR(r.force.x, -0.4 * pressed(1e-5), 1e-9 * pressed(1e-5));
  EXPECT_EQ(r.history.slide, Vec3{});
  t.velocity = {};
  EXPECT_EQ(answer(sliding("viscous", "restitution"), t).tangential, Vec3{});
}

TEST(ConstantTorque, OpposesRollingWithItsWholeSize) {
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  EXPECT_EQ(answer(rolling("constant_torque"), t).roll_torque, Vec3{});
  t.spin = {3e-9, 4e-9, 100.0};
  const Vec3 torque = answer(rolling("constant_torque"), t).roll_torque;
  const double size = 0.1 * radius * pressed(1e-5);
  EXPECT_NEAR(torque.x, -0.6 * size, 1e-9 * size);
  EXPECT_NEAR(torque.y, -0.8 * size, 1e-9 * size);
  EXPECT_EQ(torque.z, 0.0);
}

TEST(ElasticPlasticViscousRolling, AddsADashpotBelowItsLimitOnly) {
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  const double stiffness = 2.25 * 4.0 / 3.0 * 1e7 * grip(1e-5) * 0.01 * radius * radius;
  const double inertia = 0.5 * 1.4 * 2e-6 * 1e-6, viscosity = 2.0 * 0.3 * std::sqrt(inertia * stiffness);
  t.spin = {1e-4, 0, 0};
  const laws::Response r = answer(rolling("elastic_plastic_viscous"), t);
  EXPECT_NEAR(r.history.roll.x, -stiffness * 1e-4 * t.dt, 1e-12 * stiffness);
  EXPECT_NEAR(r.roll_torque.x, -(stiffness * t.dt + viscosity) * 1e-4, 1e-12 * viscosity);
  t.spin = {1e6, 0, 0};
  const double limit = 0.1 * radius * pressed(1e-5);
  EXPECT_NEAR(answer(rolling("elastic_plastic_viscous"), t).roll_torque.x, -limit, 1e-9 * limit);
}

TEST(Twisting, ResistsSpinAboutTheNormalAndLeavesRollingAlone) {
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  t.spin = {1e-3, 0, 1e-3};
  const laws::Law both = rolling("elastic_plastic", "elastic_plastic"), rolls = rolling("elastic_plastic");
  laws::Response with = answer(both, t), without = answer(rolls, t);
  const double stiffness = 8.0 * 3e6 * grip(1e-5) * radius * radius;
  EXPECT_EQ(with.roll_torque.x, without.roll_torque.x);
  EXPECT_EQ(without.roll_torque.z, 0.0);
  EXPECT_NEAR(with.roll_torque.z, -stiffness * 1e-3 * t.dt, 1e-12 * stiffness * t.dt);
  with = answer(both, t, with.history);
  EXPECT_NEAR(with.roll_torque.z, -2.0 * stiffness * 1e-3 * t.dt, 1e-12 * stiffness * t.dt);
  t.spin = {0, 0, -1e9};
  const double limit = 0.2 * radius * pressed(1e-5);
  EXPECT_NEAR(answer(both, t).roll_torque.z, limit, 1e-9 * limit);
}

TEST(Twisting, IsDampedAsSlidingIsUntilItYields) {
  const laws::Law law =
      laws::find_law("hertz", "restitution", "total_spring", "none", "none", "elastic_plastic");
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  // The dashpot of sliding, from a contact that slides a little.
  t.velocity = {1e-9, 0, 0};
  const double stiffness = 8.0 * 3e6 * grip(1e-5);
  const double dashpot = -answer(law, t).force.x / 1e-9 - stiffness * t.dt;
  ASSERT_GT(dashpot, 0.0);
  t.velocity = {};
  t.spin = {0, 0, 1e-3};
  const laws::Response r = answer(law, t);
  const double spring = stiffness * radius * radius * 1e-3 * t.dt;
  EXPECT_NEAR(-r.roll_torque.z, spring + dashpot * radius * radius * 1e-3, 1e-9 * spring);
  EXPECT_NEAR(-r.history.roll.z, spring, 1e-9 * spring) << "the dashpot is not remembered";
  laws::Choices without;
  without.tangential_damping = false;
  EXPECT_NEAR(-answer(law, t, {}, without).roll_torque.z, spring, 1e-9 * spring);
  t.spin = {0, 0, 1e9};
  const double limit = 0.2 * radius * pressed(1e-5);
  EXPECT_NEAR(-answer(law, t).roll_torque.z, limit, 1e-9 * limit);
}

TEST(Twisting, SurvivesATurningContact) {
  const laws::Law law = rolling("elastic_plastic", "elastic_plastic");
  laws::Touch t = touch_of(1e-3, 1e-3, 1e-5);
  laws::Past h;
  h.roll = {2e-9, 1e-9, 5e-9};
  for (int step = 1; step <= 1000; ++step) {
    const double angle = 1e-3 * step, half = angle - 0.5e-3;
    t.half_normal = {std::sin(half), 0, std::cos(half)};
    t.normal = {std::sin(angle), 0, std::cos(angle)};
    h = answer(law, t, h).history;
  }
  EXPECT_NEAR(dot(h.roll, t.normal), 5e-9, 1e-18);
  EXPECT_NEAR(h.roll.y, 1e-9, 1e-12);
}

TEST(Problems, AreNoneForSoundChoices) {
  EXPECT_TRUE(sliding("total_spring", "restitution").problems(rubber(), {}).empty());
}

TEST(Problems, NameWhatIsMissingOrOutOfRange) {
  const auto first = [](const laws::Law& law, const laws::MaterialPair& m,
                        const laws::Choices& choices = {}) {
    const auto found = law.problems(m, choices);
    return found.empty() ? std::string("none") : found.front();
  };
  EXPECT_NE(first(laws::find_law("hooke", "none", "none", "none"), rubber()).find("characteristic_speed"),
            std::string::npos);
  EXPECT_NE(
      first(laws::find_law("jkr", "none", "none", "none", "sjkr"), rubber()).find("adhesion of its own"),
      std::string::npos);
  EXPECT_NE(first(laws::find_law("hertz", "none", "none", "none", "capillary_soulie"), rubber())
                .find("surface_tension = 0 N/m is outside"),
            std::string::npos);
  EXPECT_NE(first(sliding("viscous"), rubber()).find("viscous"), std::string::npos);
  laws::MaterialPair m = rubber();
  m.restitution = 1.2;
  EXPECT_NE(
      first(sliding("total_spring", "restitution"), m).find("restitution = 1.2 - is outside of 0.001 to 1"),
      std::string::npos);
  laws::Choices shifted;
  shifted.cohesion_limit = laws::CohesionLimit::shifted;
  EXPECT_NE(
      first(laws::find_law("hertz", "none", "none", "none", "sjkr"), rubber(), shifted).find("pull-off"),
      std::string::npos);
}

}  // namespace
