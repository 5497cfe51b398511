// SPDX-License-Identifier: Apache-2.0
// The ledger of energy in single collisions: each line against theory, and what is left when all are added up.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using Term = kernels::EnergyTerm;

namespace {

constexpr double radius = 1e-3, density = 2500.0, stiffness = 2e4;
const double half_mass = 0.5 * density * sphere_volume(radius);  // m* of two equal spheres

laws::MaterialPair material(double restitution, double friction, double work = 0.0) {
  Stuff stuff;
  stuff.restitution = restitution;
  stuff.friction = friction;
  stuff.work_of_adhesion = work;
  laws::MaterialPair pair = material_pair(stuff, stuff);
  pair.normal_stiffness = stiffness;
  pair.tangential_ratio = 2.0 / 7.0;
  return pair;
}

LawParts law(const std::string& normal, const std::string& sliding = "none",
             const std::string& rolling = "none") {
  LawParts parts;
  parts.normal = normal;
  parts.sliding = sliding;
  parts.rolling = rolling;
  return parts;
}

Model empty_space(const laws::MaterialPair& pair, const LawParts& parts, double dt) {
  Model m = one_pair(pair, parts, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, dt, radius, radius);
  m.body_force.gravity = {};
  m.energy_ledger = true;
  return m;
}

/// Two equal spheres that start `gap` radii apart and fly into each other, each with `speed`.
EnergyBalance collide(const Model& m, const Vec3& speed, const Vec3& spin, int steps, double gap = 0.01) {
  const Vec3 at{(1.0 + 0.5 * gap) * radius, 0, 0};
  Simulation s(
      m, state_of(m, {parcel(0, -at, radius, density, speed, spin), parcel(1, at, radius, density, -speed)}),
      1);
  for (int k = 0; k < steps; ++k) s.step();
  return s.energy().value();
}

double impact_energy(double relative_speed) { return 0.5 * half_mass * square(relative_speed); }

TEST(EnergyLedger, OfAnElasticCollisionLosesNothing) {
  for (const char* normal : {"hertz", "hooke"}) {
    constexpr double dt = 1e-6;
    const EnergyBalance b = collide(empty_space(material(1.0, 0.0), law(normal), dt), {0.5, 0, 0}, {}, 4000);
    EXPECT_NEAR(b.start, impact_energy(1.0), 1e-12 * b.start);
    EXPECT_LT(std::abs(b.lost()), 1e-12 * b.start) << normal;
    // A linear contact begins and ends with k (v dt)^2/8 at most; Hertz has no kink.
    const double kink = normal == std::string("hooke") ? stiffness * square(1.0 * dt) / 8.0 : 1e-6 * b.start;
    EXPECT_LT(std::abs(b.closing_error()), kink) << normal;
  }
}

TEST(EnergyLedger, HasInContactsWhatMotionLostToSecondOrderInTheStep) {
  double off[2];
  for (int k = 0; k < 2; ++k) {
    const double dt = k == 0 ? 2e-6 : 1e-6;
    const EnergyBalance b = collide(empty_space(material(1.0, 0.0), law("hertz"), dt), {0.5, 0, 0}, {},
                                    static_cast<int>(1.2e-4 / dt + 0.5));
    EXPECT_GT(b[Term::elastic], 0.2 * b.start);
    EXPECT_GT(b.kinetic(), 0.05 * b.start);
    off[k] = std::abs(b.closing_error()) / b.start;
    EXPECT_LT(off[k], 1e-4);
  }
  EXPECT_NEAR(off[0] / off[1], 4.0, 0.6);
}

TEST(EnergyLedger, OfADampedCollisionHasTheLossOfTheRestitutionAskedFor) {
  for (const double e : {0.9, 0.5, 0.2})
    for (const char* normal : {"hertz", "hooke"}) {
      const EnergyBalance b =
          collide(empty_space(material(e, 0.0), law(normal), 5e-7), {0.5, 0, 0}, {}, 8000);
      EXPECT_NEAR(b[Term::normal_dashpot], (1.0 - e * e) * b.start, 0.002 * b.start) << normal << ' ' << e;
      EXPECT_NEAR(b.lost(), b[Term::normal_dashpot], 1e-9 * b.start);
      EXPECT_LT(std::abs(b.closing_error()), 3e-4 * b.start) << normal << ' ' << e;
    }
}

TEST(EnergyLedger, OfAJkrCollisionHasTheWorkOfTouchAndSeparation) {
  constexpr double dt = 1e-7, speed = 1.0;
  const laws::MaterialPair pair = material(1.0, 0.0, 0.1);
  const double reduced = 0.5 * radius, pull_off = 1.5 * pi * pair.work_of_adhesion * reduced;
  const double w_s = 7.0922 * std::cbrt(std::pow(pair.work_of_adhesion, 5) * std::pow(reduced, 4) /
                                        square(pair.effective_modulus));
  double mean = 0.0;
  constexpr int collisions = 20;
  for (int k = 0; k < collisions; ++k) {
    const EnergyBalance b =
        collide(empty_space(pair, law("jkr"), dt), {0.5 * speed, 0, 0}, {}, 8000, 0.01 + 0.0001234 * k);
    EXPECT_EQ(b.stored(), 0.0);
    EXPECT_NEAR(b[Term::touch] + b[Term::separation], w_s, 1e-5 * w_s);
    EXPECT_NEAR(b.start - b.kinetic(), w_s, 0.06 * w_s);
    // Steps over the jumps of the force, 8/9 and 5/9 of the pull-off force.
    EXPECT_LT(std::abs(b.closing_error()), (8.0 / 9.0 + 5.0 / 9.0) / 2.0 * pull_off * speed * dt);
    mean += b.closing_error() / w_s / collisions;
  }
  EXPECT_LT(std::abs(mean), 0.01);
}

TEST(EnergyLedger, OfAConservativePullLosesNothing) {
  for (const char* cohesion : {"dmt", "sjkr2_reduced_radius", "sjkr2_twice_reduced_radius", "hamaker"}) {
    laws::MaterialPair pair = material(1.0, 0.0, 0.01);
    pair.cohesion_energy_density = 1e5;
    pair.hamaker_constant = 1e-12;  // much too large, to be seen
    pair.shortest_gap = 1e-6;
    pair.longest_gap = 2e-5;
    LawParts parts = law("hertz");
    parts.cohesion = cohesion;
    const EnergyBalance half = collide(empty_space(pair, parts, 1e-7), {0.5, 0, 0}, {}, 1200);
    EXPECT_LT(half[Term::cohesive], -1e-5 * half.start) << cohesion;
    EXPECT_LT(std::abs(half.closing_error()), 0.02 * std::abs(half[Term::cohesive])) << cohesion;
    const EnergyBalance b = collide(empty_space(pair, parts, 1e-7), {0.5, 0, 0}, {}, 8000);
    EXPECT_EQ(b.stored(), 0.0) << cohesion;
    EXPECT_LT(std::abs(b.lost()), 1e-12 * b.start) << cohesion;
    EXPECT_LT(std::abs(b.closing_error()), 2e-6 * b.start) << cohesion;
    EXPECT_TRUE(b.splits_contacts);
  }
}

TEST(EnergyLedger, SaysWhereALawStatesNoStoredEnergyAndClosesAllTheSame) {
  for (const auto& [normal, cohesion] :
       {std::pair{"luding", "none"}, std::pair{"edinburgh", "none"}, std::pair{"hertz", "sjkr"},
        std::pair{"hertz", "capillary_willett"}}) {
    laws::MaterialPair pair = material(0.8, 0.4, 0.01);
    pair.plastic_ratio = 3.0;
    pair.adhesion_ratio = 0.5;
    pair.plasticity_depth = 0.05;
    pair.unloading_ratio = 2.0;
    pair.cohesion_energy_density = 1e5;
    pair.surface_tension = 0.07;
    pair.liquid_content = 0.01;
    pair.liquid_viscosity = 1e-3;
    LawParts parts = law(normal, "total_spring");
    parts.cohesion = cohesion;
    const Model m = empty_space(pair, parts, 1e-7);
    const EnergyBalance half = collide(m, {0.5, 0.2, 0}, {}, 1200), b = collide(m, {0.5, 0.2, 0}, {}, 8000);
    EXPECT_FALSE(b.splits_contacts);
    EXPECT_GT(std::abs(half[Term::unsplit_normal] + half[Term::unsplit_cohesion]), 1e-3 * b.start)
        << normal << cohesion;
    EXPECT_LT(std::abs(b.closing_share()), 1e-5) << normal << cohesion;
  }
}

TEST(EnergyLedger, OfGrossSlidingHasTheWorkOfCoulombsFriction) {
  // Spheres that only brush each other fast slip all the time: the friction's impulse is mu m* v_n (1 + e) at a
  // slip speed that this impulse lowers by 7/2 of itself over m*.
  constexpr double mu = 0.05, e = 1.0, v_n = 1.0, v_t = 0.6;
  Stuff hard;
  hard.young_modulus = 5e11;  // so that the spheres hardly turn about each other
  hard.restitution = e;
  hard.friction = mu;
  const Model m = empty_space(material_pair(hard, hard), law("hertz", "incremental_spring"), 2e-9);
  const EnergyBalance b = collide(m, {0.5 * v_n, 0.5 * v_t, 0}, {}, 2500, 5e-4);
  const double impulse = mu * half_mass * v_n * (1.0 + e);
  const double theory = impulse * (v_t - 0.5 * 3.5 * impulse / half_mass);
  EXPECT_NEAR(b[Term::sliding] + b[Term::tangential_dashpot] - b[Term::sliding_stiffness], theory,
              0.005 * theory);
  EXPECT_GT(b[Term::sliding], 0.95 * theory);
  EXPECT_LT(std::abs(b.closing_error()), 1e-3 * theory);
}

TEST(EnergyLedger, OfObliqueCollisionsClosesForEveryLawOfTangentialForces) {
  for (const char* normal : {"hertz", "hooke", "jkr"})
    for (const char* sliding : {"total_spring", "incremental_spring", "rescaled_spring", "viscous"})
      for (const char* rolling : {"none", "elastic_plastic", "elastic_plastic_viscous", "constant_torque"})
        for (const char* twisting : {"none", "elastic_plastic"}) {
          laws::MaterialPair pair = material(0.7, 0.4, 0.05);
          pair.rolling_friction = 0.1;
          pair.rolling_viscosity = 0.3;
          pair.twisting_friction = 0.1;
          LawParts parts = law(normal, sliding, rolling);
          parts.twisting = twisting;
          const std::string which = std::string(normal) + ' ' + sliding + ' ' + rolling + ' ' + twisting;
          const EnergyBalance b =
              collide(empty_space(pair, parts, 2e-7), {0.5, 0.3, 0.1}, {300, 200, -400}, 8000);
          EXPECT_LT(std::abs(b.closing_share()), 1e-5) << which;
          EXPECT_GT(b[Term::sliding] + b[Term::tangential_dashpot] + b[Term::unsplit_friction],
                    1e-3 * b.start)
              << which;
          if (rolling != std::string("none")) {
            EXPECT_GT(b[Term::rolling] + b[Term::rolling_dashpot], 1e-2 * b.start) << which;
          }
          if (twisting != std::string("none")) {
            EXPECT_GT(b[Term::twisting] + b[Term::twisting_dashpot], 1e-2 * b.start) << which;
          }
        }
}

TEST(EnergyLedger, HasWhatASpringGainsWhenItsStiffnessChanges) {
  // While spheres are pressed into each other, a spring that keeps its length gains, one that keeps its force loses;
  // one that keeps the lower of both never gains.
  const auto gain = [](const char* sliding, int steps) {
    const EnergyBalance b =
        collide(empty_space(material(1.0, 0.4), law("hertz", sliding), 2e-7), {0.5, 0.05, 0}, {}, steps);
    EXPECT_LT(std::abs(b.closing_share()), 1e-5) << sliding;
    return b[Term::sliding_stiffness] / b.start;
  };
  constexpr int pressed = 500, apart = 4000;
  EXPECT_GT(gain("total_spring", pressed), 1e-6);
  EXPECT_LT(gain("incremental_spring", pressed), -1e-6);
  EXPECT_LT(gain("rescaled_spring", pressed), -1e-6);
  EXPECT_LT(gain("rescaled_spring", apart), gain("rescaled_spring", pressed));
}

}  // namespace
