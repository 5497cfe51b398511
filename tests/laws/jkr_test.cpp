// SPDX-License-Identifier: Apache-2.0
// Adhesion after Johnson, Kendall and Roberts: its curve, its special points, its memory, its energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/laws/estimates.hpp"
#include "tests/laws/reference.hpp"

using namespace pulvis;
using namespace pulvis::testing;

namespace {

struct Contact {
  const char* name;
  double modulus, radius, work;  ///< E*, R*, W
};

// A stiff micron-sized pair, a soft one, and a millimetre-sized one. The 4.6 um molybdenum of the table has
// E = 320 GPa, or 10 MPa where it is softened, and W = 2e-4 J/m^2.
const Contact contacts[] = {{"molybdenum", 1.758e11, 1.15e-6, 2e-4},
                            {"softened molybdenum", 5.49e6, 1.15e-6, 2e-4},
                            {"sticky sand", 2.7e6, 5e-4, 0.1}};

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

// The loading branch in units of its special points:
//   delta/delta_c = 6^(1/3) (2 x^2 - 4/3 sqrt(x)),  F/F_po = 4 x^3 - 4 x^(3/2),  x = a/a0.
// Printed values: computed from these equations to six places by an independent reader.
struct Row {
  double overlap, radius, force;
};
const Row table[] = {
    {-1, 0.302853, -0.555556},    {-0.99, 0.346160, -0.648741},  {-0.9, 0.442553, -0.830926},
    {-0.75, 0.526774, -0.944614}, {-0.5, 0.623598, -0.999772},   {-0.25, 0.698984, -0.971515},
    {0, 0.763143, -0.888889},     {0.25, 0.820065, -0.764523},   {0.5, 0.871810, -0.605578},
    {1, 0.964265, -0.201195},     {1.2114, 0.999998, -0.000014}, {2, 1.120755, 0.885107},
    {3, 1.253780, 2.268041},      {5, 1.478673, 5.740016},       {10, 1.916932, 17.559825},
    {100, 5.391102, 576.677563}};

Quad table_radius(double overlap) {
  const auto overlap_of = [](Quad x) { return quad_cube_root(6) * (2 * x * x - Quad{4} / 3 * quad_root(x)); };
  Quad low = 1 / quad_cube_root(36), high = 10;
  for (int halving = 0; halving < 130; ++halving) {
    const Quad middle = (low + high) / 2;
    (overlap_of(middle) < overlap ? low : high) = middle;
  }
  return (low + high) / 2;
}

TEST(JkrTable, PrintedValuesAgreeWithTheRecomputedOnes) {
  for (const Row& row : table) {
    const Quad x = table_radius(row.overlap);
    EXPECT_NEAR(static_cast<double>(x), row.radius, 1e-6);
    EXPECT_NEAR(static_cast<double>(4 * x * x * x - 4 * x * quad_root(x)), row.force,
                1e-6 * std::fabs(row.force) + 1e-6);
  }
}

TEST(JkrTable, LawAgreesAtSixteenOverlaps) {
  double worst_radius = 0.0, worst_force = 0.0;
  for (const Contact& c : contacts) {
    const Quad radius = c.radius, modulus = c.modulus, work = c.work, pi = quad_pi();
    const Quad stretch = jkr_stretch_at_rupture(radius, modulus, work);
    const Quad zero_force_radius = quad_cube_root(9 * pi * work * radius * radius / (2 * modulus));
    const Quad pull_off = Quad{3} / 2 * pi * work * radius;
    const auto constants = plain_jkr().mix(material(c), {});
    for (const Row& row : table) {
      const Quad x = table_radius(row.overlap);
      // The curve is vertical at rupture: there the stretch the law itself uses is the only fair question.
      const double overlap = row.overlap == -1 ? -plain_jkr().separation_gap(c.radius, constants)
                                               : static_cast<double>(row.overlap * stretch);
      const laws::Normal ours = plain_jkr().normal_force(overlap, c.radius, constants);
      const double radius_error =
          static_cast<double>(quad_magnitude(ours.contact_size / (x * zero_force_radius) - 1));
      const Quad pressed = 4 * x * x * x, pulled = 4 * x * quad_root(x);
      const double force_error = static_cast<double>(
          quad_magnitude(ours.elastic / pull_off - (pressed - pulled)) / (pressed + pulled));
      EXPECT_LT(radius_error, row.overlap == -1 ? 1e-7 : 1e-9) << c.name << " at " << row.overlap;
      EXPECT_LT(force_error, 1e-9) << c.name << " at " << row.overlap;
      worst_radius = std::max(worst_radius, radius_error);
      worst_force = std::max(worst_force, force_error);
    }
  }
  RecordProperty("worst_radius_e15", std::to_string(worst_radius * 1e15));
  RecordProperty("worst_force_e15", std::to_string(worst_force * 1e15));
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

TEST(JkrPullOff, LargestPullOnTheBranchIsThreeHalvesPiWTimesR) {
  for (const Contact& c : contacts) {
    const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
    const auto constants = plain_jkr().mix(material(c), {});
    constexpr int steps = 100000;
    double lowest = 0.0, where = 0.0;
    for (int k = 0; k <= steps; ++k) {
      const double overlap = stretch * (-1.0 + 2.0 * k / steps);
      const double force = plain_jkr().normal_force(overlap, c.radius, constants).elastic;
      if (force < lowest) lowest = force, where = overlap / stretch;
    }
    const double pull_off = 1.5 * 3.14159265358979323846 * c.work * c.radius;
    EXPECT_NEAR(-lowest / pull_off, 1.0, 1e-4) << c.name;
    // delta/delta_c = 6^(1/3) (2 x^2 - 4/3 sqrt(x)) at x = 2^(-2/3).
    EXPECT_NEAR(where, -0.48074986, 1e-4) << c.name;
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

TEST(JkrEnergy, WorkOfSeparationIsTheAreaUnderTheStretchedBranch) {
  // W_s = 7.0922 (W^5 R*^4/E*^2)^(1/3); 7.09 in Thornton and Ning, Powder Technol. 99 (1998) 154.
  for (const Contact& c : contacts) {
    const double stretch = laws::jkr_stretch(c.radius, c.modulus, c.work);
    const auto constants = plain_jkr().mix(material(c), {});
    // delta = -delta_c (1 - u^2): the square root at rupture becomes smooth in u.
    constexpr int panels = 2000;
    double sum = 0.0;
    for (int k = 0; k <= panels; ++k) {
      const double u = static_cast<double>(k) / panels;
      const double value = -plain_jkr().normal_force(-stretch * (1.0 - u * u), c.radius, constants).elastic *
                           2.0 * u * stretch;
      sum += value * (k == 0 || k == panels ? 1.0 : k % 2 ? 4.0 : 2.0);
    }
    const double work = sum / (3.0 * panels);
    EXPECT_NEAR(work / laws::jkr_separation_work(c.radius, c.modulus, c.work), 1.0, 1e-3) << c.name;
    EXPECT_NEAR(work / laws::jkr_separation_work(c.radius, c.modulus, c.work), 1.0, 1e-5) << c.name;
    EXPECT_NEAR(work / (laws::jkr_pull_off(c.radius, c.work) * stretch), 0.935503, 1e-5) << c.name;
  }
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
