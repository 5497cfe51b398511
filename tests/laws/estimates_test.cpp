// SPDX-License-Identifier: Apache-2.0
// Closed forms about single contacts against published numbers and against the laws they summarise.
#include "engine/laws/estimates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/references/law.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

constexpr double sphere_factor = 4.1887902047863909846;  // 4 pi/3

struct Molybdenum {
  double modulus, diameter = 4.6e-6, density = 10200.0, poisson = 0.3, work = 2e-4;
  double effective() const { return laws::effective_modulus(modulus, poisson, modulus, poisson); }
  double radius() const { return 0.25 * diameter; }  // R* of two equal spheres
  double mass() const { return 0.5 * density * sphere_factor * std::pow(0.5 * diameter, 3); }
};

TEST(Estimates, EffectiveModuliOfEqualMaterials) {
  const double e = 7e10, nu = 0.33, shear = e / (2.0 * (1.0 + nu));
  EXPECT_NEAR(laws::effective_modulus(e, nu, e, nu), e / (2.0 * (1.0 - nu * nu)), 1e-14 * e);
  // 1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j.
  EXPECT_NEAR(laws::effective_shear_modulus(e, nu, e, nu), shear / (2.0 * (2.0 - nu)), 1e-14 * e);
  EXPECT_EQ(laws::effective_modulus(1e7, 0.2, 3e9, 0.4), laws::effective_modulus(3e9, 0.4, 1e7, 0.2));
}

TEST(Estimates, RayleighTimeOfSoftenedMolybdenumParcels) {
  // 4.0e-7 s for E = 10 MPa, d = 4.6 um, rho = 10200; in proportion to the size.
  EXPECT_NEAR(laws::rayleigh_time(2.3e-6, 10200, 1e7, 0.3), 4.0e-7, 0.05e-7);
  EXPECT_NEAR(laws::rayleigh_time(2.3e-4, 10200, 1e7, 0.3), 4.0e-5, 0.05e-5);
}

TEST(Estimates, RayleighDenominatorFitsTheRootOfRayleighsEquation) {
  // kappa^3 - 8 kappa^2 + (24 - 16 eta) kappa - 16 (1 - eta) = 0, kappa = (c/c_s)^2, eta = (1-2 nu)/(2-2 nu).
  for (double nu = 0.0; nu <= 0.5; nu += 0.05) {
    const double eta = (1.0 - 2.0 * nu) / (2.0 - 2.0 * nu);
    double low = 0.5, high = 1.0;
    for (int k = 0; k < 60; ++k) {
      const double x = 0.5 * (low + high);
      (((x - 8.0) * x + 24.0 - 16.0 * eta) * x - 16.0 * (1.0 - eta) < 0.0 ? low : high) = x;
    }
    const double e = 1e7, shear = e / (2.0 * (1.0 + nu));
    const double exact = 3.14159265358979 * 1e-3 * std::sqrt(2500.0 / shear) / std::sqrt(low);
    EXPECT_NEAR(laws::rayleigh_time(1e-3, 2500.0, e, nu) / exact, 1.0, 3e-3) << nu;
  }
}

TEST(Estimates, HertzImpactsOfChungAndOoi) {
  // Largest overlap and duration, Granul. Matter 13 (2011) 643, tests 1 to 3, elastic.
  struct Impact {
    double modulus, poisson, density, radius, speed;
    bool rigid_wall;
    double overlap, duration;
  };
  for (const Impact& i : {Impact{4.8e10, 0.20, 2800, 0.01, 20.0, false, 274.1e-6, 40.34e-6},
                          Impact{2.0e10, 0.25, 2500, 0.01, 20.0, false, 368.3e-6, 54.20e-6},
                          Impact{7.0e10, 0.30, 2699, 0.1, 0.2, true, 49.72e-6, 731.7e-6},
                          Impact{4.0e10, 0.35, 1800, 0.1, 0.2, true, 52.12e-6, 767.1e-6},
                          Impact{3.8e11, 0.23, 4000, 0.0025, 3.9, true, 8.089e-6, 6.105e-6},
                          Impact{1.0e11, 0.25, 7000, 0.0025, 3.9, true, 17.19e-6, 12.97e-6}}) {
    const double own = i.modulus / (1.0 - i.poisson * i.poisson),
                 sphere = i.density * sphere_factor * std::pow(i.radius, 3);
    const double modulus = i.rigid_wall ? own : 0.5 * own, radius = i.rigid_wall ? i.radius : 0.5 * i.radius,
                 mass = i.rigid_wall ? sphere : 0.5 * sphere;
    EXPECT_NEAR(laws::hertz_largest_overlap(mass, radius, modulus, i.speed) / i.overlap, 1.0, 2e-4);
    EXPECT_NEAR(laws::hertz_contact_time(mass, radius, modulus, i.speed) / i.duration, 1.0, 2e-4);
  }
  EXPECT_EQ(laws::hertz_largest_overlap(1.0, 1.0, 1.0, 0.0), 0.0);
}

TEST(Estimates, HertzOverlapUnderAForceIsTheInverseOfTheLaw) {
  const laws::Law law = laws::find_law("hertz", "none", "none", "none");
  for (std::uint64_t k = 0; k < 200; ++k) {
    const RandomState s = random_state("hertz", k);
    if (s.touch.overlap <= 0.0) continue;
    const double force = law.normal_force(s.touch.overlap, s.touch.radius, law.mix(s.material, {})).elastic;
    const double back = laws::hertz_overlap_under(force, s.touch.radius, s.material.effective_modulus);
    EXPECT_NEAR(back / s.touch.overlap, 1.0, 1e-14);
  }
}

TEST(Estimates, JkrPullOffAndStretch) {
  const Molybdenum soft{1e7};
  EXPECT_NEAR(laws::jkr_pull_off(soft.radius(), soft.work), 1.5 * 3.14159265358979 * 2e-4 * 1.15e-6, 1e-22);
  const Quad stretch = jkr_stretch_at_rupture(soft.radius(), soft.effective(), soft.work);
  EXPECT_NEAR(laws::jkr_stretch(soft.radius(), soft.effective(), soft.work) / static_cast<double>(stretch),
              1.0, 1e-14);
  // 1.8e-12 m for unsoftened molybdenum: below atomic size.
  const Molybdenum real{320e9};
  EXPECT_NEAR(laws::jkr_stretch(real.radius(), real.effective(), real.work), 1.8e-12, 0.1e-12);
}

TEST(Estimates, JkrOverlapsUnderForcesAreTheInverseOfTheLaw) {
  const laws::Law law = laws::find_law("jkr", "none", "none", "none");
  for (std::uint64_t k = 0; k < 200; ++k) {
    const RandomState s = random_state("jkr", k);
    const double e = s.material.effective_modulus, w = s.material.work_of_adhesion, r = s.touch.radius;
    const auto constants = law.mix(s.material, {});
    const double pull_off = laws::jkr_pull_off(r, w);
    const double free_overlap = laws::jkr_zero_force_overlap(r, e, w);
    // (2/3) 6^(1/3): the curve of the table in jkr_test.cpp at a = a0.
    EXPECT_NEAR(free_overlap / laws::jkr_stretch(r, e, w), 1.2114137285547597, 1e-14);
    EXPECT_NEAR(law.normal_force(free_overlap, r, constants).elastic, 0.0, 1e-12 * pull_off);
    EXPECT_NEAR(laws::jkr_overlap_under(0.0, r, e, w) / free_overlap, 1.0, 1e-14);
    for (const double force : {1e-3 * pull_off, pull_off, 1e3 * pull_off}) {
      const double overlap = laws::jkr_overlap_under(force, r, e, w);
      EXPECT_NEAR(law.normal_force(overlap, r, constants).elastic, force, 1e-12 * (force + pull_off));
    }
  }
}

TEST(Estimates, JkrStiffnessAtTouchIsTheSlopeOfTheLaw) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    const RandomState s = random_state("jkr", k);
    const Quad e = s.material.effective_modulus, w = s.material.work_of_adhesion, r = s.touch.radius;
    const Quad small = jkr_stretch_at_rupture(r, e, w) * 1e-8;
    const auto force = [&](Quad overlap) { return jkr_force(overlap, r, s.material); };
    const auto slope = static_cast<double>((force(small) - force(-small)) / (2 * small));
    const double ours = laws::jkr_stiffness_at_touch(s.touch.radius, s.material.effective_modulus,
                                                     s.material.work_of_adhesion);
    EXPECT_NEAR(ours / slope, 1.0, 1e-12);
  }
}

TEST(Estimates, StickingSpeedsOfMolybdenum) {
  // Two 4.6 um spheres with W = 2e-4 J/m^2: 3.80e-3 m/s softened to 10 MPa, 1.2e-4 m/s at 320 GPa; in closed
  // form v_s = 3.766 m*^(-1/2) (W^5 R*^4/E*^2)^(1/6).
  const Molybdenum soft{1e7}, real{320e9};
  const auto speed = [](const Molybdenum& m) {
    return laws::jkr_sticking_speed(m.mass(), m.radius(), m.effective(), m.work);
  };
  EXPECT_NEAR(speed(soft), 3.80e-3, 0.005e-3);
  EXPECT_NEAR(speed(real), 1.2e-4, 0.05e-4);
  const double closed =
      3.766 / std::sqrt(soft.mass()) *
      std::pow(std::pow(soft.work, 5) * std::pow(soft.radius(), 4) / std::pow(soft.effective(), 2),
               1.0 / 6.0);
  EXPECT_NEAR(speed(soft) / closed, 1.0, 1e-4);
}

}  // namespace
