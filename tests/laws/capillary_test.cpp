// SPDX-License-Identifier: Apache-2.0
// Capillary bridges: published values, and how bridges form and break.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/law.hpp"
#include "validation/references/plain_touch.hpp"

using namespace pulvis;
using namespace pulvis::validation;
namespace cohesion = pulvis::laws::cohesion;

namespace {

constexpr double ten_degrees = 10.0 * 3.14159265358979323846 / 180.0;

/// Checks of a public code (YADE, checkCapillaryModels) for spheres of 19 um and another radius, 10 degrees.
struct Published {
  double other, volume, tension, gap, force, rupture;
  double radius() const { return 2.0 * 19e-6 * other / (19e-6 + other); }
};

template <class Part>
void expect_published(const Published& p) {
  laws::MaterialPair m;
  m.surface_tension = p.tension;
  m.contact_angle = ten_degrees;
  const auto pair = Part::mix(m, {});
  EXPECT_NEAR(Part::force(p.gap, p.volume, p.radius(), pair), p.force, 1e-8 * p.force);
  EXPECT_NEAR(cohesion::bridge_rupture(p.volume, p.radius(), pair.bridge), p.rupture, 1e-6 * p.rupture);
}

TEST(CapillaryBridge, ReachesThePublishedValuesOfWillettsFit) {
  expect_published<cohesion::CapillaryWillett>(
      {35e-6, 2e-19, 0.027, 2.4846e-7, 2.07328148666e-7, 6.373470e-7});
}
TEST(CapillaryBridge, ReachesThePublishedValuesOfWillettsClosedForm) {
  expect_published<cohesion::CapillaryWillettClosed>(
      {32.5e-6, 12e-19, 0.024, 2.48485e-7, 6.78192074e-7, 1.160513e-6});
}
TEST(CapillaryBridge, ReachesThePublishedValuesOfRabinovich) {
  expect_published<cohesion::CapillaryRabinovich>(
      {27.5e-6, 36e-19, 0.028, 2.48535e-7, 1.58617796928e-6, 1.677729e-6});
}
TEST(CapillaryBridge, ReachesTheValuesOfWillettsFitAtThreeGaps) {
  // R = 50 um, V = 0.01 R^3, sigma = 0.072 N/m, theta = 0: four digits.
  laws::MaterialPair m;
  m.surface_tension = 0.072;
  const auto pair = cohesion::CapillaryWillett::mix(m, {});
  const double radius = 50e-6, volume = 0.01 * radius * radius * radius;
  for (const auto& [gap, force] : {std::pair{0.1e-6, 1.961e-5}, {1e-6, 1.608e-5}, {5e-6, 5.726e-6}})
    EXPECT_NEAR(cohesion::CapillaryWillett::force(gap, volume, radius, pair), force, 3e-4 * force);
}

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
