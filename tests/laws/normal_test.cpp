// SPDX-License-Identifier: Apache-2.0
// Normal forces and dashpots in plain situations; against the equations in 1,000: `pulvis validate --only laws`.
#include <gtest/gtest.h>

#include "engine/laws/estimates.hpp"
#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

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
