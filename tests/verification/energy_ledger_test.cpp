// SPDX-License-Identifier: Apache-2.0
// The ledger of energy against theory: each line by itself, and what is left when all are added up.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/draw.hpp"
#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using Term = kernels::EnergyTerm;

namespace {

constexpr double radius = 1e-3, density = 2500.0;

Stuff stuff_with(double restitution, double friction, double work = 0.0) {
  Stuff stuff;
  stuff.restitution = restitution;
  stuff.friction = friction;
  stuff.work_of_adhesion = work;
  return stuff;
}

Model empty_space(const Stuff& stuff, const LawParts& parts, double dt) {
  Model m = one_material(stuff, parts, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, dt, radius, radius);
  m.body_force.gravity = {};
  m.energy_ledger = true;
  return m;
}

LawParts law(const char* normal, const char* sliding = "none", const char* rolling = "none") {
  LawParts parts;
  parts.normal = normal;
  parts.sliding = sliding;
  parts.rolling = rolling;
  return parts;
}

/// Two equal spheres that start a little apart and meet, until they are apart again or `steps` have gone.
EnergyBalance collide(Model m, const Vec3& velocity, const Vec3& spin, int steps, double gap = 0.01) {
  const Vec3 way = (1.0 + 0.5 * gap) * radius * Vec3{1, 0, 0};
  Simulation s(m, state_of(m, {parcel(0, -way, radius, density, velocity, spin),
                               parcel(1, way, radius, density, -velocity, {})}),
               1);
  for (int k = 0; k < steps; ++k) s.step();
  return s.energy().value();
}

/// m* v^2/2 with the relative speed.
double impact_energy(double speed) {
  return 0.5 * 0.5 * density * sphere_volume(radius) * 4.0 * speed * speed;
}

TEST(EnergyLedger, OfAnElasticCollisionKeepsItsEnergyAndLosesNothing) {
  for (const char* normal : {"hertz", "hooke"}) {
    Model m = empty_space(stuff_with(1.0, 0.0), law(normal), 1e-6);
    m.classes.set(0, 0, contact_class([&] {
                    auto pair = material_pair(stuff_with(1.0, 0.0), stuff_with(1.0, 0.0));
                    pair.normal_stiffness = 2e4;
                    return pair;
                  }(), law(normal)));
    const EnergyBalance b = collide(m, {0.5, 0, 0}, {}, 4000);
    EXPECT_NEAR(b.start, impact_energy(0.5), 1e-12 * b.start);
    EXPECT_LT(std::abs(b.lost()), 1e-12 * b.start) << normal;
    EXPECT_LT(std::abs(b.closing_error()), 1e-4 * b.start) << normal;
    std::printf("%s closing %.3g\n", normal, b.closing_share());
  }
}

TEST(EnergyLedger, OfTwoSpheresInContactSplitsMotionFromWhatIsStored) {
  // Half way: what motion lost is stored, to second order in the time step.
  double off[2];
  for (int k = 0; k < 2; ++k) {
    const double dt = k == 0 ? 2e-6 : 1e-6;
    Model m = empty_space(stuff_with(1.0, 0.0), law("hertz"), dt);
    const EnergyBalance b = collide(m, {0.5, 0, 0}, {}, static_cast<int>(1.2e-4 / dt));
    EXPECT_GT(b[Term::elastic], 0.2 * b.start);
    off[k] = std::abs(b.closing_error()) / b.start;
    std::printf("dt %g elastic %.4f closing %.3g\n", dt, b[Term::elastic] / b.start, off[k]);
  }
}

TEST(EnergyLedger, OfADampedCollisionHasTheDashpotsLossOfTheRestitutionAskedFor) {
  for (const double e : {0.9, 0.5, 0.2})
    for (const char* normal : {"hertz", "hooke"}) {
      auto pair = material_pair(stuff_with(e, 0.0), stuff_with(e, 0.0));
      pair.normal_stiffness = 2e4;
      Model m = empty_space(stuff_with(e, 0.0), law(normal), 5e-7);
      m.classes.set(0, 0, contact_class(pair, law(normal)));
      const EnergyBalance b = collide(m, {0.5, 0, 0}, {}, 8000);
      EXPECT_NEAR(b[Term::normal_dashpot], (1.0 - e * e) * b.start, 0.005 * b.start) << normal << ' ' << e;
      EXPECT_LT(std::abs(b.closing_error()), 1e-3 * b.start) << normal << ' ' << e;
      std::printf("%s e %g dashpot %.5f asked %.5f closing %.3g\n", normal, e, b[Term::normal_dashpot] / b.start,
                  1 - e * e, b.closing_share());
    }
}

TEST(EnergyLedger, OfAJkrCollisionLosesTheWorkOfTouchAndSeparation) {
  const Stuff stuff = stuff_with(1.0, 0.0, 0.1);
  const Model m = empty_space(stuff, law("jkr"), 1e-7);
  const auto pair = material_pair(stuff, stuff);
  const double reduced = 0.5 * radius;
  const double w_s = 7.0922 * std::cbrt(std::pow(pair.work_of_adhesion, 5) * std::pow(reduced, 4) /
                                        square(pair.effective_modulus));
  double closing = 0.0;
  int n = 0;
  for (int k = 0; k < 20; ++k) {
    const EnergyBalance b = collide(m, {0.5, 0, 0}, {}, 12000, 0.01 + 0.0001234 * k);
    EXPECT_EQ(b.stored(), 0.0);
    EXPECT_NEAR(b[Term::touch] + b[Term::separation], w_s, 1e-5 * w_s);
    EXPECT_LT(std::abs(b.closing_error()), 0.03 * w_s);
    closing += b.closing_error() / w_s;
    ++n;
    if (k < 4) std::printf("w_s/start %.4g touch %.6f sep %.6f closing/w_s %.3g\n", w_s / b.start, b[Term::touch] / w_s,
                b[Term::separation] / w_s, b.closing_error() / w_s);
  }
  std::printf("mean closing/w_s %.3g\n", closing / n);
}

TEST(EnergyLedger, OfObliqueCollisionsCloses) {
  for (const char* normal : {"hertz", "hooke", "jkr"})
    for (const char* sliding : {"total_spring", "incremental_spring", "rescaled_spring", "viscous"})
      for (const char* rolling : {"none", "elastic_plastic", "elastic_plastic_viscous", "constant_torque"})
        for (const char* twisting : {"none", "elastic_plastic"}) {
          Stuff stuff = stuff_with(0.7, 0.4, 0.05);
          auto pair = material_pair(stuff, stuff);
          pair.normal_stiffness = 2e4;
          pair.tangential_ratio = 2.0 / 7.0;
          pair.rolling_friction = 0.1;
          pair.rolling_viscosity = 0.3;
          pair.twisting_friction = 0.1;
          LawParts parts = law(normal, sliding, rolling);
          parts.twisting = twisting;
          Model m = empty_space(stuff, parts, 2e-7);
          m.classes.set(0, 0, contact_class(pair, parts));
          const EnergyBalance b = collide(m, {0.5, 0.3, 0.1}, {300, 200, -400}, 20000);
          EXPECT_LT(std::abs(b.closing_share()), 1e-3) << normal << sliding << rolling << twisting;
          std::printf("%-6s %-18s %-24s %-16s closing %9.2g  nd %.3g td %.3g sl %.3g ro %.3g rd %.3g tw %.3g twd %.3g tou %.3g sep %.3g fo %.3g st %.3g rst %.3g uf %.3g\n",
                      normal, sliding, rolling, twisting, b.closing_share(), b[Term::normal_dashpot] / b.start,
                      b[Term::tangential_dashpot] / b.start, b[Term::sliding] / b.start, b[Term::rolling] / b.start,
                      b[Term::rolling_dashpot] / b.start, b[Term::twisting] / b.start, b[Term::twisting_dashpot] / b.start,
                      b[Term::touch] / b.start, b[Term::separation] / b.start, b[Term::forgotten_springs] / b.start,
                      b[Term::sliding_stiffness] / b.start, b[Term::rolling_stiffness] / b.start, b[Term::unsplit_friction]/b.start);
        }
}

}  // namespace
