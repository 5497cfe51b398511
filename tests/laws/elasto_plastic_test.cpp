// SPDX-License-Identifier: Apache-2.0
// The elasto-plastic laws along whole loading paths, and linear springs.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/laws/estimates.hpp"
#include "validation/references/plain_touch.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

/// A contact whose overlap is led by hand.
struct Path {
  laws::Law law;
  laws::MaterialPair material;
  laws::Choices choices{};
  laws::Past history{};
  laws::Response last{};

  double to(double overlap) {
    last = law.evaluate(touch_of(1e-3, 1e-3, overlap), history, law.mix(material, choices));
    history = last.history;
    return -last.force.z;
  }
  /// Leads the overlap in small steps; returns the work done against the contact, J.
  double lead(double from, double end, int steps = 20000) {
    double work = 0.0, before = to(from);
    for (int k = 1; k <= steps; ++k) {
      const double force = to(from + (end - from) * k / steps);
      work += 0.5 * (before + force) * (end - from) / steps;
      before = force;
    }
    return work;
  }
};

laws::MaterialPair luding_pair() {
  laws::MaterialPair m;
  m.effective_modulus = 1e7;
  m.normal_stiffness = 1e3;
  m.plastic_ratio = 5.0;
  m.adhesion_ratio = 0.5;
  m.plasticity_depth = 0.05;
  return m;
}

Path luding() { return {laws::find_law("luding", "none", "none", "none"), luding_pair()}; }

TEST(Luding, UnloadsThroughTheZeroForceOverlapToTheStrongestPull) {
  Path path = luding();
  const double most = 2e-5, limit = 5.0 / 4.0 * 0.05 * 2.0 * 0.5e-3, k2 = 1e3 + 4e3 * most / limit;
  EXPECT_NEAR(path.to(most), 1e3 * most, 1e-12);
  EXPECT_NEAR(path.to((1.0 - 1e3 / k2) * most), 0.0, 1e-12);
  const double deepest = (k2 - 1e3) / (k2 + 500.0) * most;
  EXPECT_NEAR(path.to(1.000001 * deepest), -500.0 * deepest, 1e-5 * deepest * 1e3);
  EXPECT_NEAR(path.to(0.5 * deepest), -250.0 * deepest, 1e-12);
}

TEST(Luding, LoadedAgainFromTheAdhesiveLineStartsWhereItStands) {
  Path path = luding();
  path.to(2e-5);
  const double force = path.to(1e-6), largest = path.history.plastic;
  EXPECT_LT(largest, 2e-5);
  EXPECT_NEAR(path.to(1e-6), force, 1e-12);
  const double limit = 5.0 / 4.0 * 0.05 * 2.0 * 0.5e-3, k2 = 1e3 + 4e3 * largest / limit;
  EXPECT_NEAR(path.to(1.5e-6), k2 * (1.5e-6 - largest) + 1e3 * largest, 1e-12);
}

TEST(Luding, IsElasticBeyondItsPlasticDepth) {
  Path path = luding();
  const double limit = 5.0 / 4.0 * 0.05 * 2.0 * 0.5e-3;
  const double loading = path.to(1.2 * limit);
  EXPECT_NEAR(loading, 5e3 * 0.2 * limit + 1e3 * limit, 1e-12);
  path.to(1.5 * limit);
  EXPECT_NEAR(path.to(1.2 * limit), loading, 1e-12);
}

TEST(Luding, LosesTheEnergyBetweenItsBranches) {
  Path path = luding();
  const double most = 2e-5, limit = 5.0 / 4.0 * 0.05 * 2.0 * 0.5e-3, k2 = 1e3 + 4e3 * most / limit;
  const double lost = path.lead(1e-12, most) + path.lead(most, 1e-12);
  const double zero = (1.0 - 1e3 / k2) * most, deepest = (k2 - 1e3) / (k2 + 500.0) * most;
  const double expected = 0.5 * 1e3 * most * zero + 0.5 * 500.0 * deepest * zero;
  EXPECT_NEAR(lost, expected, 1e-6 * expected);
}

Path edinburgh(bool linear, double exponent) {
  laws::MaterialPair m;
  m.effective_modulus = 1e7;
  m.effective_shear_modulus = 4e6;
  m.unloading_ratio = 5.0;
  m.work_of_adhesion = 0.5;
  m.constant_pull = -1e-6;
  laws::Choices choices;
  choices.linear_loading = linear;
  choices.adhesion_exponent = exponent;
  return {laws::find_law("edinburgh", "none", "none", "none"), m, choices};
}

TEST(Edinburgh, PullsWithTheForceOfItsPlasticContact) {
  for (const bool linear : {true, false})
    for (const double exponent : {1.0, 1.5, 2.0}) {
      Path path = edinburgh(linear, exponent);
      const double most = 1e-5, radius = 0.5e-3;
      const double k1 = linear ? 2e7 * radius : 4.0 / 3.0 * 1e7 * std::sqrt(radius), n = linear ? 1.0 : 1.5;
      EXPECT_NEAR(path.to(most), k1 * std::pow(most, n) - 1e-6, 1e-12);
      const double plastic = std::pow(0.8 * std::pow(most, n), 1.0 / n);
      const double pull = 1.5 * 3.14159265358979 * 0.5 * std::sqrt(2.0 * radius * plastic);
      const double at = std::pow(std::pow(plastic, n) - pull / (5.0 * k1), 1.0 / n);
      EXPECT_NEAR(path.to(plastic), -1e-6, 1e-9) << linear << exponent;
      EXPECT_NEAR(path.to(1.00000001 * at), -pull - 1e-6, 1e-4 * pull) << linear << exponent;
      EXPECT_NEAR(path.to(0.5 * at), -pull * std::pow(0.5, exponent) - 1e-6, 1e-9 * pull)
          << linear << exponent;
    }
}

TEST(Edinburgh, LoadedAgainFromTheAdhesiveBranchStartsWhereItStandsAndYieldsAnew) {
  Path path = edinburgh(false, 1.5);
  path.to(1e-5);
  const double low = path.to(1e-6);
  EXPECT_NEAR(path.to(1e-6), low, 1e-12);
  EXPECT_GT(path.to(2e-6), low);
  const double k1 = 4.0 / 3.0 * 1e7 * std::sqrt(0.5e-3);
  EXPECT_NEAR(path.to(2e-5), k1 * std::pow(2e-5, 1.5) - 1e-6, 1e-10);
}

TEST(Edinburgh, LosesEnergyInEveryLoop) {
  for (const bool linear : {true, false})
    for (const double exponent : {1.0, 1.5, 2.0}) {
      Path path = edinburgh(linear, exponent);
      double lost = path.lead(1e-12, 1e-5);
      EXPECT_GT(lost, 0.0);
      lost += path.lead(1e-5, 2e-6);
      EXPECT_GT(lost, 0.0);
      const double loop = path.lead(2e-6, 4e-6) + path.lead(4e-6, 2e-6);
      EXPECT_GE(loop, -1e-6 * lost) << linear << exponent;
      EXPECT_GT(lost + path.lead(2e-6, 1e-12), 0.0) << linear << exponent;
    }
}

TEST(Hooke, HasTheLargestOverlapOfHertzAtItsCharacteristicSpeed) {
  laws::MaterialPair m;
  m.effective_modulus = 5e6;
  m.characteristic_speed = 0.3;
  const laws::Law law = laws::find_law("hooke", "none", "none", "none");
  const laws::Touch t = touch_of(1e-3, 1e-3, 1e-6);
  const double stiffness = normal_force(law, t, m) / 1e-6;
  const double deepest = laws::hertz_largest_overlap(t.mass, t.radius, 5e6, 0.3);
  EXPECT_NEAR(stiffness * deepest * deepest, t.mass * 0.09, 1e-12 * t.mass);
}

TEST(Damping, ShowsTheRestitutionAskedForOnHookeAndHertz) {
  for (const char* normal : {"hooke", "hertz"})
    for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9, 0.95})
      for (const double speed : {0.01, 0.1, 1.0}) {
        laws::MaterialPair m;
        m.effective_modulus = 5e6;
        m.effective_shear_modulus = 2e6;
        m.restitution = e;
        m.normal_stiffness = 1e3;
        const laws::Law law = laws::find_law(normal, "restitution", "none", "none");
        const laws::Touch t = touch_of(1e-3, 1e-3, 0.0);
        const double duration = normal[1] == 'o' ? 3.1416 * std::sqrt(t.mass / 1e3)
                                                 : laws::hertz_contact_time(t.mass, t.radius, 5e6, speed);
        EXPECT_NEAR(restitution_shown(law, m, t, speed, duration), e, 0.005 * e) << normal << e << speed;
      }
}

}  // namespace
