// SPDX-License-Identifier: Apache-2.0
// Normal forces and dashpots against the equations in 113 bits: within 1e-12 of the sum of their terms,
// within 1e-10 where a root is solved.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/laws/estimates.hpp"
#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

constexpr std::uint64_t states = 1000;

void record(const char* name, double value) {
  ::testing::Test::RecordProperty(name, std::to_string(value * 1e15) + "e-15");
}

struct Worst {
  double force = 0.0, contact_size = 0.0, damping_size = 0.0, limit_shift = 0.0;
};

Worst worst_errors(const char* law) {
  const laws::Law entry = laws::find_law(law, "none", "none", "none");
  const auto apart = [](Quad a, Quad b) { return static_cast<double>(quad_magnitude(a - b)); };
  Worst worst;
  for (std::uint64_t k = 0; k < states; ++k) {
    const RandomState s = random_state(law, k);
    const double overlap = s.touch.overlap, radius = s.touch.radius;
    const auto constants = entry.mix(s.material, {});
    if (overlap <= -entry.separation_gap(radius, constants)) continue;
    const ReferenceNormal truth = reference_normal(law, s.touch, s.history, s.material, {});
    const laws::Normal ours = entry.normal_force(overlap, radius, constants);
    worst.force = std::max(worst.force, relative(apart(ours.elastic, truth.force), truth.terms));
    worst.contact_size = std::max(worst.contact_size,
                                  relative(apart(ours.contact_size, truth.contact_size), truth.contact_size));
    worst.damping_size = std::max(worst.damping_size,
                                  relative(apart(ours.damping_size, truth.damping_size), truth.damping_size));
    worst.limit_shift =
        std::max(worst.limit_shift, relative(apart(ours.limit_shift, truth.limit_shift), truth.limit_shift));
  }
  record("force", worst.force);
  record("contact_size", worst.contact_size);
  return worst;
}

TEST(HertzNormalForce, AgreesWithTheEquationsIn1000RandomStates) {
  const Worst worst = worst_errors("hertz");
  EXPECT_LT(worst.force, 1e-12);
  EXPECT_LT(worst.contact_size, 1e-12);
  EXPECT_LT(worst.damping_size, 1e-12);
  EXPECT_EQ(worst.limit_shift, 0.0);
}

TEST(JkrNormalForce, AgreesWithTheEquationsIn1000RandomStates) {
  const Worst worst = worst_errors("jkr");
  EXPECT_LT(worst.force, 1e-10);
  EXPECT_LT(worst.contact_size, 1e-10);
  EXPECT_LT(worst.damping_size, 1e-12);
  EXPECT_LT(worst.limit_shift, 1e-12);
}

TEST(HertzNormalForce, IsZeroWithoutOverlapAndAtAGap) {
  const laws::Law entry = laws::find_law("hertz", "none", "none", "none");
  laws::MaterialPair m;
  m.effective_modulus = 1e7;
  const auto constants = entry.mix(m, {});
  EXPECT_EQ(entry.normal_force(0.0, 1e-3, constants).elastic, 0.0);
  EXPECT_EQ(entry.normal_force(-1e-5, 1e-3, constants).elastic, 0.0);
  EXPECT_EQ(entry.normal_force(-1e-5, 1e-3, constants).contact_size, 0.0);
  EXPECT_EQ(entry.separation_gap(1e-3, constants), 0.0);
}

TEST(HertzNormalForce, ReachesThePublishedPeaksOfChungAndOoi) {
  // Largest force of elastic impacts, tests 1 and 2 of C.-Y. Chung, J. Y. Ooi, Granul. Matter 13 (2011) 643:
  // 10697 N (glass), 7108 N (limestone), 11370 N (aluminium alloy on a rigid plane), 7233 N (magnesium
  // alloy).
  struct Impact {
    double modulus, poisson, density, radius, speed;
    bool rigid_wall;
    double force;
  };
  const laws::Law entry = laws::find_law("hertz", "none", "none", "none");
  for (const Impact& i : {Impact{4.8e10, 0.20, 2800, 0.01, 20.0, false, 10696.9},
                          Impact{2.0e10, 0.25, 2500, 0.01, 20.0, false, 7108.24},
                          Impact{7.0e10, 0.30, 2699, 0.1, 0.2, true, 11369.9},
                          Impact{4.0e10, 0.35, 1800, 0.1, 0.2, true, 7232.7}}) {
    const double own = i.modulus / (1.0 - i.poisson * i.poisson),
                 sphere = i.density * 4.1887902047863909 * i.radius * i.radius * i.radius;
    laws::MaterialPair m;
    m.effective_modulus = i.rigid_wall ? own : 0.5 * own;
    const double radius = i.rigid_wall ? i.radius : 0.5 * i.radius,
                 mass = i.rigid_wall ? sphere : 0.5 * sphere;
    const double overlap = laws::hertz_largest_overlap(mass, radius, m.effective_modulus, i.speed);
    EXPECT_NEAR(entry.normal_force(overlap, radius, entry.mix(m, {})).elastic, i.force, 1e-5 * i.force);
  }
}

TEST(Dashpot, CoefficientsAgreeWithTheEquationsIn1000RandomStates) {
  double worst = 0.0;
  for (const bool on_contact_size : {false, true})
    for (std::uint64_t k = 0; k < states; ++k) {
      const RandomState s = random_state("jkr", k);
      laws::Choices choices;
      choices.damping_on_jkr_radius = on_contact_size;
      const laws::Normal normal{0.0, 0.7 * s.touch.radius, 0.3 * s.touch.radius, 0.0};
      const double radius = on_contact_size ? normal.contact_size : normal.damping_size;
      const auto c = laws::damping::Restitution::coefficients(
          normal, s.touch.mass,
          laws::damping::Restitution::mix(s.material, choices, laws::normal::Jkr::stiffness(s.material, {})));
      const Quad modulus = s.material.effective_modulus, shear = s.material.effective_shear_modulus;
      const Quad c_normal = reference_dashpot(2 * modulus * radius, s.touch.mass, s.material.restitution);
      const Quad c_tangential = reference_dashpot(8 * shear * radius, s.touch.mass, s.material.restitution);
      worst = std::max(worst, relative(static_cast<double>(quad_magnitude(c.normal - c_normal)), c_normal));
      worst = std::max(
          worst, relative(static_cast<double>(quad_magnitude(c.tangential - c_tangential)), c_tangential));
    }
  record("coefficient", worst);
  EXPECT_LT(worst, 1e-12);
}

TEST(Dashpot, VanishesWithRestitutionOneAndWithoutOverlap) {
  RandomState s = random_state("jkr", 3);
  s.material.restitution = 1.0;
  const laws::Normal pressed{1.0, 1e-3, 1e-3, 0.0}, stretched{-1.0, 1e-3, 0.0, 0.0};
  using Part = laws::damping::Restitution;
  EXPECT_EQ(Part::coefficients(pressed, 1.0,
                               Part::mix(s.material, {}, laws::normal::Jkr::stiffness(s.material, {})))
                .normal,
            0.0);
  s.material.restitution = 0.3;
  EXPECT_GT(Part::coefficients(pressed, 1.0,
                               Part::mix(s.material, {}, laws::normal::Jkr::stiffness(s.material, {})))
                .normal,
            0.0);
  EXPECT_EQ(Part::coefficients(stretched, 1.0,
                               Part::mix(s.material, {}, laws::normal::Jkr::stiffness(s.material, {})))
                .normal,
            0.0);
  EXPECT_EQ(Part::coefficients(stretched, 1.0,
                               Part::mix(s.material, {}, laws::normal::Jkr::stiffness(s.material, {})))
                .tangential,
            0.0);
}

}  // namespace
