// SPDX-License-Identifier: Apache-2.0
// How capillary bridges form and break; their forces are compared by `pulvis validate --only capillary`.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/law.hpp"
#include "validation/references/plain_touch.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

const char* const bridges[] = {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                               "capillary_soulie"};

laws::MaterialPair water() {
  laws::MaterialPair m;
  m.effective_modulus = 5e6;
  m.effective_shear_modulus = 2e6;
  m.friction = 0.5;
  m.surface_tension = 0.072;
  m.contact_angle = 0.2;
  m.liquid_content = 1e-3;
  m.shortest_bridge_gap = 0.01;
  return m;
}

laws::Law law_with(const char* bridge) {
  return laws::find_law("hertz", "none", "total_spring", "none", bridge);
}

TEST(CapillaryBridge, FormsOnTouchHoldsAcrossAGapAndBreaksAtTheRuptureDistance) {
  for (const char* bridge : bridges) {
    const laws::Law law = law_with(bridge);
    const laws::MaterialPair m = water();
    laws::Touch t = touch_of(1e-3, 2e-3, -1e-5);
    const double rupture = law.cohesion->separation_gap(t, law.mix(m, {}));
    EXPECT_GT(rupture, 5e-5) << bridge;
    EXPECT_LE(rupture, law.separation_gap(2e-3, law.mix(m, {}))) << bridge;
    EXPECT_LT(normal_force(law, t, m), 0.0) << bridge;
    t.was_touching = 0.0;
    EXPECT_EQ(normal_force(law, t, m), 0.0) << "approaching, " << bridge;
    t.was_touching = 1.0;
    t.overlap = -0.999 * rupture;
    EXPECT_LT(normal_force(law, t, m), 0.0) << bridge;
    t.overlap = -1.001 * rupture;
    EXPECT_EQ(law.evaluate(t, {}, law.mix(m, {})).touching, 0.0) << bridge;
  }
}

TEST(CapillaryBridge, FormsOnApproachIfAskedTo) {
  laws::Choices choices;
  choices.bridges_form_on_approach = true;
  for (const char* bridge : bridges) {
    const laws::Law law = law_with(bridge);
    const auto constants = law.mix(water(), choices);
    laws::Touch t = touch_of(1e-3, 2e-3, 0.0, false);
    const double rupture = law.cohesion->separation_gap(t, constants);
    t.overlap = -0.99 * rupture;
    EXPECT_EQ(law.evaluate(t, {}, constants).touching, 1.0) << bridge;
    EXPECT_GE(law.formation_gap(2e-3, constants), rupture) << bridge;
    EXPECT_EQ(law.formation_gap(2e-3, law.mix(water(), {})), 0.0) << bridge;
  }
}

TEST(CapillaryBridge, WeakensAsItIsDrawnOut) {
  for (const char* bridge : bridges) {
    const laws::Law law = law_with(bridge);
    double last = -1e9;
    for (int k = 0; k <= 20; ++k) {
      const double force = normal_force(law, touch_of(1e-3, 1e-3, -5e-6 * k), water());
      EXPECT_GT(force, last) << bridge << k;
      last = force;
    }
  }
}

TEST(CapillaryBridge, IsTwiceAsStrongAtAWallAsBetweenEqualSpheres) {
  // Derjaguin; the bridge of V/R^3 is kept by the content: (2 R)^3 against the wall's one sphere of two.
  for (const char* bridge : {"capillary_willett_closed"}) {
    const laws::Law law = law_with(bridge);
    const double pair = normal_force(law, touch_of(1e-3, 1e-3, 0.0), water());
    const double wall = normal_force(law, touch_of_wall(1e-3, 0.0), water());
    EXPECT_NEAR(wall / pair, 2.0, 1e-12) << bridge;
  }
}

TEST(CapillaryBridge, ForgetsTheTangentialSpringAtAGap) {
  const laws::Law law = law_with("capillary_willett");
  laws::Past history;
  history.slide = {1e-6, 0, 0};
  const laws::Response r = law.evaluate(touch_of(1e-3, 1e-3, -1e-6), history, law.mix(water(), {}));
  EXPECT_EQ(r.touching, 1.0);
  EXPECT_EQ(r.tangential, Vec3{});
  EXPECT_EQ(r.history.slide, Vec3{});
}

TEST(CapillaryBridge, DampsWithTheViscosityOfTheLiquid) {
  const laws::Law law = law_with("capillary_willett");
  laws::MaterialPair m = water();
  laws::Touch t = touch_of(1e-3, 1e-3, -2e-5);
  const double still = normal_force(law, t, m);
  m.liquid_viscosity = 0.001;
  t.velocity = {0.02, 0, 0.01};
  const laws::Response r = law.evaluate(t, {}, law.mix(m, {}));
  const double q = 2e-5 / 5e-4, drag = 6.0 * 3.14159265358979 * 0.001 * 5e-4;
  EXPECT_NEAR(-r.force.z - still, drag / q * 0.01, 1e-9 * drag);
  EXPECT_NEAR(r.force.x, -drag * (8.0 / 15.0 * std::log(1.0 / q) + 0.9588) * 0.02, 1e-9 * drag);
}

}  // namespace
