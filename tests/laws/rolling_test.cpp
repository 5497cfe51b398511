// SPDX-License-Identifier: Apache-2.0
// Rolling resistance on its own: against the equations in 113 bits, and what it does in plain situations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

double worst_error(const char* normal) {
  const laws::Law law = laws::find_law(normal, "restitution", "none", "elastic_plastic");
  double worst = 0.0;
  for (std::uint64_t k = 0; k < 1000; ++k) {
    const RandomState s = random_state(normal, k);
    const ReferenceResponse truth = reference_response(law, s.touch, s.history, s.material, {});
    if (!truth.touching) continue;
    const laws::Response ours = law.evaluate(s.touch, s.history, law.mix(s.material, {}));
    worst = std::max(worst, relative(distance(ours.roll_torque, truth.roll_torque), truth.torque_terms));
    worst = std::max(worst, relative(distance(ours.history.roll, truth.roll), truth.torque_terms));
  }
  ::testing::Test::RecordProperty("worst_e15", std::to_string(worst * 1e15));
  return worst;
}

TEST(ElasticPlasticRolling, AgreesWithTheEquationsIn1000RandomHertzStates) {
  EXPECT_LT(worst_error("hertz"), 1e-12);
}
TEST(ElasticPlasticRolling, AgreesWithTheEquationsIn1000RandomJkrStates) {
  EXPECT_LT(worst_error("jkr"), 1e-10);
}

struct Rolled {
  RandomState state = random_state("hertz", 1);
  Rolled() {
    state.touch = {1e-5, 1e-3, 1e-6, 1.0, {0, 0, 1}, {0, 0, 1}, {}, {}, 1e-6};
    state.material.effective_modulus = 1e7;
    state.material.effective_shear_modulus = 3e6;
    state.material.rolling_friction = 0.1;
    state.history = {};
  }
  laws::Response answer() const {
    const laws::Law law = laws::find_law("hertz", "none", "none", "elastic_plastic");
    return law.evaluate(state.touch, state.history, law.mix(state.material, {}));
  }
  double stiffness() const { return 8.0 * 3e6 * std::sqrt(1e-3 * 1e-5) * 1e-6; }
  double limit() const { return 0.1 * 1e-3 * 4.0 / 3.0 * 1e7 * std::sqrt(1e-3) * std::pow(1e-5, 1.5); }
};

TEST(ElasticPlasticRolling, IsSilentWithoutSpin) { EXPECT_EQ(Rolled{}.answer().roll_torque, Vec3{}); }

TEST(ElasticPlasticRolling, OpposesRollingWithTheTangentialStiffnessTimesRSquared) {
  Rolled r;
  r.state.touch.spin = {1e-3, 0, 0};
  const double expected = -r.stiffness() * 1e-3 * 1e-6;
  EXPECT_NEAR(r.answer().roll_torque.x, expected, 1e-12 * std::fabs(expected));
}

TEST(ElasticPlasticRolling, DoesNotResistTwisting) {
  Rolled r;
  r.state.touch.spin = {0, 0, 100.0};
  EXPECT_EQ(r.answer().roll_torque, Vec3{});
}

TEST(ElasticPlasticRolling, YieldsAtTheRollingFriction) {
  Rolled r;
  r.state.touch.spin = {3e4, 4e4, 0};
  EXPECT_NEAR(norm(r.answer().roll_torque), r.limit(), 1e-12 * r.limit());
  EXPECT_NEAR(r.answer().roll_torque.x / r.answer().roll_torque.y, 0.75, 1e-12);
}

TEST(ElasticPlasticRolling, ExertsATorqueAndNoForce) {
  Rolled r;
  r.state.touch.spin = {3e4, 4e4, 0};
  EXPECT_EQ(r.answer().tangential, Vec3{});
}

}  // namespace
