// SPDX-License-Identifier: Apache-2.0
// What contacts between parcels cannot change: momentum and angular momentum.
#include <gtest/gtest.h>

#include "validation/draw.hpp"
#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

LawParts with_normal(const char* normal) {
  LawParts parts;
  parts.normal = normal;
  return parts;
}

Stuff rough_and_sticky() {
  Stuff stuff;
  stuff.young_modulus = 2e6;
  stuff.work_of_adhesion = 0.02;
  return stuff;
}

double momentum_scale(const Parcels& parcels) {
  double sum = 0.0;
  for (const Parcel& p : parcels.body) sum += p.mass * norm(p.velocity);
  return sum;
}

double angular_scale(const Parcels& parcels) {
  double sum = 0.0;
  for (const Parcel& p : parcels.body)
    sum += p.mass * norm(p.position) * norm(p.velocity) + inertia(p) * norm(p.spin);
  return sum;
}

TEST(Momentum, OfParcelsInAPeriodicBoxIsConserved) {
  for (const char* normal : {"hertz", "jkr"}) {
    Model m = one_material(rough_and_sticky(), with_normal(normal), {0, 0, 0}, {0.009, 0.009, 0.009}, 1e-5,
                           0.3e-3, 0.6e-3);
    m.body_force.gravity = {};
    m.domain.periodic[0] = m.domain.periodic[1] = m.domain.periodic[2] = true;
    std::vector<Parcel> parcels;
    for (std::uint32_t k = 0; k < 200; ++k) {
      pulvis::validation::Draw draw(k, 41);
      const Vec3 at{(0.75 + 1.5 * (k % 6)) * 1e-3, (0.75 + 1.5 * (k / 6 % 6)) * 1e-3,
                    (0.75 + 1.5 * (k / 36)) * 1e-3};
      parcels.push_back(
          parcel(k, at, draw.between(0.3e-3, 0.6e-3), 2500.0, draw.vector(1.0), draw.vector(500.0)));
    }
    Simulation s(m, state_of(m, parcels), 1);
    const Vec3 start = momentum(s.state().parcels);
    const double scale = momentum_scale(s.state().parcels), energy = kinetic_energy(s.state().parcels);
    std::size_t contacts = 0;
    for (int k = 0; k < 4000; ++k) {
      s.step();
      contacts += touching(s.pairs());
    }
    EXPECT_GT(contacts, 20000u);
    EXPECT_LT(kinetic_energy(s.state().parcels), 0.7 * energy);
    EXPECT_LT(norm(momentum(s.state().parcels) - start), 1e-12 * scale) << normal;
    RecordProperty(std::string(normal) + "_e18",
                   std::to_string(norm(momentum(s.state().parcels) - start) / scale * 1e18));
  }
}

TEST(AngularMomentum, OfParcelsInOpenSpaceIsConserved) {
  for (const char* normal : {"hertz", "jkr"}) {
    Model m = one_material(rough_and_sticky(), with_normal(normal), {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 1e-5,
                           0.3e-3, 0.6e-3);
    m.body_force.gravity = {};
    std::vector<Parcel> parcels;
    for (std::uint32_t k = 0; k < 200; ++k) {
      pulvis::validation::Draw draw(k, 42);
      const Vec3 at{(1.4 * (k % 6) - 3.5) * 1e-3, (1.4 * (k / 6 % 6) - 3.5) * 1e-3,
                    (1.4 * (k / 36) - 3.5) * 1e-3};
      // Towards the middle, with a swirl.
      const Vec3 velocity = -100.0 * at + cross({0, 0, 60.0}, at) + draw.vector(0.2);
      parcels.push_back(parcel(k, at, draw.between(0.3e-3, 0.6e-3), 2500.0, velocity, draw.vector(500.0)));
    }
    Simulation s(m, state_of(m, parcels), 1);
    const Vec3 start = angular_momentum(s.state().parcels), pushed = momentum(s.state().parcels);
    const double scale = angular_scale(s.state().parcels), push_scale = momentum_scale(s.state().parcels);
    std::size_t contacts = 0;
    for (int k = 0; k < 4000; ++k) {
      s.step();
      contacts += touching(s.pairs());
    }
    EXPECT_GT(contacts, 20000u);
    EXPECT_EQ(s.state().ledger.escaped, 0u);
    EXPECT_LT(norm(angular_momentum(s.state().parcels) - start), 1e-10 * scale) << normal;
    EXPECT_LT(norm(momentum(s.state().parcels) - pushed), 1e-12 * push_scale) << normal;
    RecordProperty(std::string(normal) + "_e15",
                   std::to_string(norm(angular_momentum(s.state().parcels) - start) / scale * 1e15));
  }
}

}  // namespace
