// SPDX-License-Identifier: Apache-2.0
// Adhesion after Johnson, Kendall and Roberts: its curve, its special points, its memory, its energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/laws/estimates.hpp"
#include "engine/laws/normal/jkr.hpp"
#include "validation/jkr_table.hpp"
#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

using Contact = JkrContact;
constexpr auto& contacts = jkr_contacts;

laws::MaterialPair material(const Contact& c) {
  laws::MaterialPair m;
  m.effective_modulus = c.modulus;
  m.effective_shear_modulus = 0.3 * c.modulus;
  m.work_of_adhesion = c.work;
  m.restitution = 0.5;
  m.friction = 0.5;
  return m;
}

laws::Law plain_jkr() { return laws::find_law("jkr", "none", "none", "none"); }

/// The scalar law at an overlap: whether it touches and the normal force, positive apart.
struct Answer {
  bool touching;
  double force;
};
Answer ask(const Contact& c, double overlap, bool was_touching) {
  const Vec3 x{1, 0, 0};
  const laws::Touch touch{overlap, c.radius, 1e-9, was_touching ? 1.0 : 0.0, x, x, {}, {}, 1e-6};
  const laws::Response r = plain_jkr().evaluate(touch, {}, plain_jkr().mix(material(c), {}));
  return {r.touching > 0.5, -r.force.x};
}

// Six places of the curve computed by an independent reader.
struct PrintedPoint {
  double overlap, radius, force;
};
const PrintedPoint printed[] = {
    {-1, 0.302853, -0.555556},    {-0.99, 0.346160, -0.648741},  {-0.9, 0.442553, -0.830926},
    {-0.75, 0.526774, -0.944614}, {-0.5, 0.623598, -0.999772},   {-0.25, 0.698984, -0.971515},
    {0, 0.763143, -0.888889},     {0.25, 0.820065, -0.764523},   {0.5, 0.871810, -0.605578},
    {1, 0.964265, -0.201195},     {1.2114, 0.999998, -0.000014}, {2, 1.120755, 0.885107},
    {3, 1.253780, 2.268041},      {5, 1.478673, 5.740016},       {10, 1.916932, 17.559825},
    {100, 5.391102, 576.677563}};

TEST(JkrTable, PrintedValuesAgreeWithTheRecomputedOnes) {
  const auto table = jkr_table();
  ASSERT_EQ(table.size(), std::size(printed));
  for (std::size_t k = 0; k < table.size(); ++k) {
    EXPECT_EQ(table[k].overlap, printed[k].overlap);
    EXPECT_NEAR(table[k].radius, printed[k].radius, 1e-6);
    EXPECT_NEAR(table[k].force, printed[k].force, 1e-6 * std::fabs(printed[k].force) + 1e-6);
  }
}

TEST(JkrTable, ContactRadiusAtARoundedRuptureStretchIsRightToSevenDigits) {
  for (const Contact& c : contacts) {
    const auto constants = plain_jkr().mix(material(c), {});
    const double overlap = -static_cast<double>(jkr_stretch_at_rupture(c.radius, c.modulus, c.work));
    const Quad rupture =
        quad_cube_root(quad_pi() * c.work * c.radius * c.radius / (8 * static_cast<Quad>(c.modulus)));
    const double ours = plain_jkr().normal_force(overlap, c.radius, constants).contact_size;
    EXPECT_NEAR(ours / static_cast<double>(rupture), 1.0, 1e-7) << c.name;
  }
}

TEST(JkrMemory, NothingActsAcrossAGapBeforeTheFirstTouch) {
  for (const Contact& c : contacts) {
    const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
    for (const double gap : {0.0, 1e-12, 0.1, 0.5, 0.999, 1.0, 2.0}) {
      EXPECT_FALSE(ask(c, -gap * stretch, false).touching);
      EXPECT_EQ(ask(c, -gap * stretch, false).force, 0.0);
    }
  }
}

TEST(JkrMemory, ForceJumpsToEightNinthsOfThePullOffForceAtFirstTouch) {
  for (const Contact& c : contacts) {
    const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
    const Answer a = ask(c, 1e-13 * stretch, false);
    EXPECT_TRUE(a.touching);
    EXPECT_NEAR(a.force / laws::jkr_pull_off(c.radius, c.work), -8.0 / 9.0, 1e-10) << c.name;
  }
}

TEST(JkrMemory, ContactHoldsToTheRuptureStretchAndBreaksWithFiveNinthsOfThePullOffForce) {
  for (const Contact& c : contacts) {
    const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
    const Answer before = ask(c, -(1.0 - 1e-14) * stretch, true);
    EXPECT_TRUE(before.touching) << c.name;
    EXPECT_NEAR(before.force / laws::jkr_pull_off(c.radius, c.work), -5.0 / 9.0, 1e-6) << c.name;
    const Answer after = ask(c, -(1.0 + 1e-14) * stretch, true);
    EXPECT_FALSE(after.touching) << c.name;
    EXPECT_EQ(after.force, 0.0) << c.name;
    EXPECT_FALSE(ask(c, -0.5 * stretch, after.touching).touching)
        << "a broken contact does not heal at a gap";
  }
}

TEST(JkrMemory, ForceIsContinuousBetweenTouchAndRupture) {
  const Contact c = contacts[1];
  const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
  double previous = ask(c, -0.99999 * stretch, true).force;
  for (double at = -0.9999; at < 3.0; at += 1e-4) {
    const double force = ask(c, at * stretch, true).force;
    // The steepest piece is just behind rupture, where F rises like the square root of the distance.
    EXPECT_LT(std::fabs(force - previous), 0.02 * laws::jkr_pull_off(c.radius, c.work)) << at;
    previous = force;
  }
}

TEST(JkrEquation, IsSolvedToRoundingFromRuptureToHardContacts) {
  using laws::normal::Jkr;
  for (double power = -60.0; power < 120.0; power += 0.01) {
    const double s2 = std::pow(10.0, power);
    double t = Jkr::first_guess(s2);
    for (int k = 0; k < Jkr::improvements; ++k) t = Jkr::improved(t, s2);
    long double exact = t;  // Newton's method in more digits, whose steps double them
    for (int k = 0; k < 3; ++k)
      exact -= (exact * exact * (exact * (exact + 4) + 6) - s2) / (4 * exact * (exact * (exact + 3) + 3));
    ASSERT_LE(std::fabs(static_cast<double>(t / exact - 1)), 4e-16) << s2;
  }
  EXPECT_EQ(Jkr::improved(Jkr::first_guess(0.0), 0.0), 0.0);
}

TEST(JkrWithoutAdhesion, IsHertz) {
  // A wall that powder does not stick to has the same law with W = 0.
  const laws::Law hertz = laws::find_law("hertz", "restitution", "total_spring", "elastic_plastic");
  const laws::Law jkr = laws::find_law("jkr", "restitution", "total_spring", "elastic_plastic");
  for (std::uint64_t k = 0; k < 200; ++k) {
    RandomState s = random_state("hertz", k);
    s.material.work_of_adhesion = 0.0;
    const auto a = hertz.evaluate(s.touch, s.history, hertz.mix(s.material, {}));
    const auto b = jkr.evaluate(s.touch, s.history, jkr.mix(s.material, {}));
    EXPECT_EQ(a.touching, b.touching);
    EXPECT_LE(norm(a.force - b.force), 1e-9 * norm(a.force));
    EXPECT_LE(norm(a.history.slide - b.history.slide), 1e-9 * norm(a.history.slide));
    EXPECT_LE(norm(a.roll_torque - b.roll_torque), 1e-9 * norm(a.roll_torque));
  }
}

TEST(JkrFrictionLimit, IsTheForceShiftedByTwiceThePullOffForce) {
  // C. Thornton, J. Phys. D 24 (1991) 1942: |F_t| <= mu |F + 2 F_po|.
  const laws::Law law = laws::find_law("jkr", "none", "total_spring", "none");
  const Contact c = contacts[2];
  const laws::MaterialPair m = material(c);
  const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
  const double pull_off = laws::jkr_pull_off(c.radius, c.work);
  const Vec3 z{0, 0, 1};
  for (const double at : {-0.9, -0.48, 0.0, 1.2114, 5.0}) {
    const laws::Touch touch{at * stretch, c.radius, 1e-9, 1.0, z, z, {0.1, 0, 0}, {}, 1e-6};
    const laws::Response r = law.evaluate(touch, {{c.radius, 0, 0}, {}}, law.mix(m, {}));
    EXPECT_NEAR(norm(r.tangential), m.friction * std::fabs(-r.force.z + 2.0 * pull_off), 1e-12 * pull_off);
  }
}

}  // namespace
