// SPDX-License-Identifier: Apache-2.0
// What rolling resistance does on its own in plain situations.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

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
