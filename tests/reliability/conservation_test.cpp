// SPDX-License-Identifier: Apache-2.0
// A closed system without weight keeps its momentum to rounding and its mass to the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "engine/simulation/simulation.hpp"
#include "validation/draw.hpp"
#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

/// A gas of rough, sticky spheres in a periodic box, as many along each side as given.
Simulation gas(int side, const char* normal) {
  Stuff stuff;
  stuff.young_modulus = 2e6;
  stuff.work_of_adhesion = 0.02;
  LawParts parts;
  parts.normal = normal;
  const double cell = 1.5e-3, box = cell * side;
  Model m = one_material(stuff, parts, {0, 0, 0}, {box, box, box}, 1e-5, 0.3e-3, 0.6e-3);
  m.body_force.gravity = {};
  m.domain.periodic[0] = m.domain.periodic[1] = m.domain.periodic[2] = true;
  std::vector<Parcel> parcels;
  for (int k = 0; k < side * side * side; ++k) {
    pulvis::validation::Draw draw(static_cast<std::uint64_t>(k), 47);
    const Vec3 at{cell * (k % side + 0.5), cell * (k / side % side + 0.5), cell * (k / (side * side) + 0.5)};
    parcels.push_back(parcel(static_cast<std::uint32_t>(k), at, draw.between(0.3e-3, 0.6e-3), 2500.0,
                             draw.vector(1.0), draw.vector(500.0)));
  }
  return Simulation(m, state_of(m, parcels), 2);
}

/// Masses in order of the ids: the order of the store is no one's business.
std::vector<double> masses(const Simulation& s) {
  std::vector<std::pair<std::uint32_t, double>> by_id;
  for (const Parcel& p : s.state().parcels.body) by_id.emplace_back(p.id, p.mass);
  std::sort(by_id.begin(), by_id.end());
  std::vector<double> list;
  for (const auto& [id, mass] : by_id) list.push_back(mass);
  return list;
}

/// 3,000 steps; tools/reliability asks for more by PULVIS_ROUNDS.
TEST(ClosedSystem, KeepsItsMomentumToRoundingAndItsMassToTheLastBit) {
  const char* asked = std::getenv("PULVIS_ROUNDS");
  const long steps = asked ? std::atol(asked) : 3000;
  ASSERT_GT(steps, 0);
  for (const char* normal : {"hertz", "jkr"}) {
    Simulation s = gas(asked ? 10 : 7, normal);
    const std::vector<double> before = masses(s);
    const Vec3 start = momentum(s.state().parcels);
    double scale = 0.0, worst = 0.0;
    for (const Parcel& p : s.state().parcels.body) scale += p.mass * norm(p.velocity);
    std::uint64_t contacts = 0;
    for (long k = 0; k < steps; ++k) {
      s.step();
      if (k % 100 != 0 && k + 1 != steps) continue;
      worst = std::max(worst, norm(momentum(s.state().parcels) - start) / scale);
      for (const std::uint8_t touches : s.pairs().touching) contacts += touches;
    }
    EXPECT_GT(contacts, 200u) << "they must collide for this to mean anything";
    EXPECT_LE(worst, 1e-12) << normal;
    EXPECT_EQ(masses(s), before) << normal;
    std::cout << normal << ": momentum kept to " << worst << " of the sum of all over " << steps
              << " steps of " << before.size() << " parcels, masses the same\n";
  }
}

}  // namespace
