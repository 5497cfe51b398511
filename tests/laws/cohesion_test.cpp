// SPDX-License-Identifier: Apache-2.0
// DMT, simplified JKR and Hamaker in situations with known answers, and which force limits friction.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/plain_touch.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

constexpr double circle = 3.14159265358979323846;

laws::MaterialPair sticky() {
  laws::MaterialPair m;
  m.effective_modulus = 5e6;
  m.effective_shear_modulus = 2e6;
  m.friction = 0.5;
  m.work_of_adhesion = 0.1;
  m.cohesion_energy_density = 2e4;
  m.hamaker_constant = 1e-19;
  m.shortest_gap = 4e-10;
  m.longest_gap = 4e-8;
  return m;
}

laws::Law hertz_with(const char* cohesion, const char* sliding = "none") {
  return laws::find_law("hertz", "none", sliding, "none", cohesion);
}

double attraction(const char* cohesion, const laws::Touch& t) {
  return normal_force(hertz_with("none"), t, sticky()) - normal_force(hertz_with(cohesion), t, sticky());
}

TEST(Sjkr, IsTheAreaOfTheCircleInWhichTheSpheresCut) {
  // 3-4-5: radii 5 and 5 at distance 8 cut in a circle of radius 3; a wall 4 from the centre too.
  EXPECT_NEAR(attraction("sjkr", touch_of(5e-3, 5e-3, 2e-3)), 2e4 * circle * 9e-6, 1e-9);
  EXPECT_NEAR(attraction("sjkr", touch_of_wall(5e-3, 1e-3)), 2e4 * circle * 9e-6, 1e-9);
}

TEST(Sjkr2, DiffersByTwoBetweenParcelsAndNotAtWalls) {
  const laws::Touch pair = touch_of(1e-3, 3e-3, 1e-6), wall = touch_of_wall(1e-3, 1e-6);
  const double single = attraction("sjkr2_reduced_radius", pair);
  EXPECT_NEAR(single, 2e4 * 2.0 * circle * 1e-6 * 0.75e-3, 1e-9 * single);
  EXPECT_NEAR(attraction("sjkr2_twice_reduced_radius", pair), 2.0 * single, 1e-9 * single);
  EXPECT_NEAR(attraction("sjkr2_twice_reduced_radius", wall), attraction("sjkr2_reduced_radius", wall),
              1e-18);
  // And the circle of SJKR is the single area at small overlap.
  EXPECT_NEAR(attraction("sjkr", touch_of(1e-3, 3e-3, 1e-9)) /
                  attraction("sjkr2_reduced_radius", touch_of(1e-3, 3e-3, 1e-9)),
              1.0, 1e-5);
}

TEST(Sjkr2, HasTheZeroForceOverlapAndStrongestPullOfTheClosedForms) {
  const laws::Law law = hertz_with("sjkr2_reduced_radius");
  const double k = 2e4, modulus = 5e6, radius = 0.5e-3;
  const double zero = std::pow(1.5 * circle * k / modulus, 2) * radius;
  const double strongest =
      -2.0 / 3.0 * std::pow(circle, 3) * k * k * k * radius * radius / (modulus * modulus);
  EXPECT_NEAR(normal_force(law, touch_of(1e-3, 1e-3, zero), sticky()), 0.0, -1e-9 * strongest);
  EXPECT_NEAR(normal_force(law, touch_of(1e-3, 1e-3, 4.0 / 9.0 * zero), sticky()), strongest,
              -1e-9 * strongest);
}

TEST(Dmt, PullsWithTwoPiWRInContactAndNotOutside) {
  const laws::Law law = hertz_with("dmt");
  EXPECT_NEAR(attraction("dmt", touch_of(1e-3, 1e-3, 1e-6)), 2.0 * circle * 0.1 * 0.5e-3, 1e-12);
  EXPECT_EQ(normal_force(law, touch_of(1e-3, 1e-3, -1e-12), sticky()), 0.0);
  EXPECT_NEAR(normal_force(law, touch_of(1e-3, 1e-3, 1e-15), sticky()), -2.0 * circle * 0.1 * 0.5e-3, 1e-10);
}

TEST(Hamaker, IsThatOfEqualSpheresAndEndsAtTheLongestGap) {
  const laws::Law law = hertz_with("hamaker");
  const auto constants = law.mix(sticky(), {});
  const double radius = 1e-6, gap = 1e-9;
  laws::Touch t = touch_of(radius, radius, -gap, false);
  EXPECT_NEAR(normal_force(law, t, sticky()), -1e-19 * radius / (12.0 * gap * gap), 1e-20);
  t.overlap = -4.001e-8;
  EXPECT_EQ(law.evaluate(t, {}, constants).touching, 0.0);
  EXPECT_EQ(law.formation_gap(1.0, constants), 4e-8);
  EXPECT_EQ(law.separation_gap(1.0, constants), 4e-8);
  t.overlap = -1e-10;
  EXPECT_NEAR(normal_force(law, t, sticky()), -1e-19 * radius / (12.0 * 16e-20), 1e-16);
}

TEST(Hamaker, TakesTheWorkOfItsFileToBreak) {
  const laws::Law law = hertz_with("hamaker");
  // Simpson's rule in the logarithm of the gap, from contact to the longest gap.
  const double low = std::log(4e-10), high = std::log(4e-8 * (1.0 - 1e-12));
  const int n = 2000;
  double work = 0.0;
  for (int k = 0; k <= n; ++k) {
    const double gap = std::exp(low + (high - low) * k / n);
    const double weight = k == 0 || k == n ? 1.0 : k % 2 ? 4.0 : 2.0;
    work -= weight * gap * normal_force(law, touch_of(1e-6, 1e-6, -gap), sticky());
  }
  work *= (high - low) / n / 3.0;
  const double expected = 1e-19 * 0.5e-6 / 6.0 * (1.0 / 4e-10 - 1.0 / 4e-8);
  EXPECT_NEAR(work, expected, 1e-6 * expected);
}

/// Friction in gross sliding over mu.
double limit(const laws::Law& law, double overlap, laws::CohesionLimit choice) {
  laws::Choices choices;
  choices.cohesion_limit = choice;
  laws::Past history;
  history.slide = {1.0, 0, 0};
  const auto r = law.evaluate(touch_of(1e-3, 1e-3, overlap), history, law.mix(sticky(), choices));
  return norm(r.tangential) / 0.5;
}

TEST(FrictionLimit, TakesCohesionAsChosen) {
  using enum laws::CohesionLimit;
  const double overlap = 2e-6, pull_off = 2.0 * circle * 0.1 * 0.5e-3;
  const double elastic = normal_force(hertz_with("none"), touch_of(1e-3, 1e-3, overlap), sticky());
  const laws::Law dmt = hertz_with("dmt", "total_spring");
  EXPECT_NEAR(limit(dmt, overlap, without), elastic, 1e-12 * elastic);
  EXPECT_NEAR(limit(dmt, overlap, standard), elastic, 1e-12 * elastic);
  EXPECT_NEAR(limit(dmt, overlap, with), std::fabs(elastic - pull_off), 1e-12 * elastic);
  EXPECT_NEAR(limit(dmt, overlap, shifted), elastic + pull_off, 1e-12 * elastic);

  const laws::Law jkr = laws::find_law("jkr", "none", "total_spring", "none");
  const double force = normal_force(jkr, touch_of(1e-3, 1e-3, overlap), sticky()), po = 0.75 * pull_off;
  EXPECT_NEAR(limit(jkr, overlap, without), elastic, 1e-10 * elastic);
  EXPECT_NEAR(limit(jkr, overlap, with), std::fabs(force), 1e-10 * elastic);
  EXPECT_NEAR(limit(jkr, overlap, shifted), std::fabs(force + 2.0 * po), 1e-10 * elastic);
  EXPECT_EQ(limit(jkr, overlap, standard), limit(jkr, overlap, shifted));
}

}  // namespace
