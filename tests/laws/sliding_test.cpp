// SPDX-License-Identifier: Apache-2.0
// What the tangential spring does on its own in plain situations.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

laws::Law entry_of(const char* normal, const char* damping, const char* rolling) {
  return laws::find_law(normal, damping, "total_spring", rolling);
}

struct Sheared {
  RandomState state = random_state("hertz", 1);
  Sheared() {
    state.touch = {1e-5, 1e-3, 1e-6, 1.0, {0, 0, 1}, {0, 0, 1}, {}, {}, 1e-6};
    state.material.effective_modulus = 1e7;
    state.material.effective_shear_modulus = 3e6;
    state.material.friction = 0.4;
    state.material.restitution = 0.5;
    state.history = {};
  }
  laws::Response answer(const laws::Choices& choices = {}) const {
    const laws::Law law = entry_of("hertz", "restitution", "none");
    return law.evaluate(state.touch, state.history, law.mix(state.material, choices));
  }
  double stiffness() const { return 8.0 * 3e6 * std::sqrt(1e-3 * 1e-5); }
  double hertz_force() const { return 4.0 / 3.0 * 1e7 * std::sqrt(1e-3) * std::pow(1e-5, 1.5); }
};

TEST(TotalSpring, IsSilentWithoutSlip) {
  const Sheared s;
  EXPECT_EQ(s.answer().tangential, Vec3{});
  EXPECT_EQ(s.answer().history.slide, Vec3{});
}

TEST(TotalSpring, PullsBackInProportionToTheWholeDisplacement) {
  Sheared s;
  s.state.history.slide = {2e-8, 0, 0};
  EXPECT_NEAR(s.answer().tangential.x, -s.stiffness() * 2e-8, 1e-12 * s.stiffness() * 2e-8);
  // An opening contact loses stiffness and with it force: the spring follows the displacement, not the force.
  s.state.touch.overlap = 2.5e-6;
  EXPECT_NEAR(s.answer().tangential.x, -0.5 * s.stiffness() * 2e-8, 1e-12 * s.stiffness() * 2e-8);
}

TEST(TotalSpring, IsResetToTheCoulombLimitOnSlipAndNotDamped) {
  Sheared s;
  s.state.history.slide = {1e-4, 0, 0};
  s.state.touch.velocity = {1.0, 0, 0};
  const laws::Response r = s.answer();
  const double limit = 0.4 * s.hertz_force();
  EXPECT_NEAR(r.tangential.x, -limit, 1e-12 * limit);
  EXPECT_NEAR(r.history.slide.x, limit / s.stiffness(), 1e-12 * limit / s.stiffness());
}

TEST(TotalSpring, LimitLeavesOutTheDashpotUnlessAskedFor) {
  Sheared s;
  s.state.history.slide = {1e-4, 0, 0};
  s.state.touch.velocity = {0, 0, 0.05};  // closing
  const laws::Response elastic = s.answer();
  EXPECT_NEAR(norm(elastic.tangential), 0.4 * s.hertz_force(), 1e-12 * s.hertz_force());
  laws::Choices total;
  total.limit_includes_dashpot = true;
  const laws::Response with_dashpot = s.answer(total);
  EXPECT_LT(with_dashpot.force.z, -s.hertz_force());
  EXPECT_NEAR(norm(with_dashpot.tangential), -0.4 * with_dashpot.force.z, 1e-12 * s.hertz_force());
}

TEST(TotalSpring, StaysInThePlaneOfATurningContact) {
  Sheared s;
  s.state.history.slide = {2e-8, 0, 0};
  Vec3 previous{0, 0, 1};
  for (int step = 1; step <= 1000; ++step) {
    const double angle = 1e-3 * step, half = angle - 0.5e-3;
    s.state.touch.half_normal = {std::sin(half), 0, std::cos(half)};
    s.state.touch.normal = {std::sin(angle), 0, std::cos(angle)};
    s.state.history = s.answer().history;
    EXPECT_NEAR(dot(s.state.history.slide, s.state.touch.normal), 0.0, 1e-22);
    previous = s.state.touch.normal;
  }
  // Two projections a step shorten it by cos^2(half a step) only: 1000 steps of 1 mrad by 2.5e-4.
  EXPECT_NEAR(norm(s.state.history.slide), 2e-8, 3e-4 * 2e-8);
}

TEST(TotalSpring, ForgetsWhenTheContactEnds) {
  Sheared s;
  s.state.history.slide = {2e-8, 0, 0};
  s.state.touch.overlap = -1e-9;
  const laws::Response r = s.answer();
  EXPECT_EQ(r.touching, 0.0);
  EXPECT_EQ(r.force, Vec3{});
  EXPECT_EQ(r.history.slide, Vec3{});
}

}  // namespace
