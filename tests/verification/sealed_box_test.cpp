// SPDX-License-Identifier: Apache-2.0
// Cohesive parcels in a sealed box of triangles, shaken hard: none may get out.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

TEST(SealedBoxOfTriangles, LosesNoneOfTenThousandCohesiveParcelsInTwentyCyclesOfFiveG) {
  const double radius = 1.25e-3, half = 30e-3;
  Stuff stuff{2500.0, 5e6, 0.3, 0.5, 0.5, 0.1, 0.1};
  LawParts parts;
  parts.normal = "jkr";
  Model m = one_material(stuff, parts, {-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}, 2e-5, radius, radius);
  pulvis::validation::Draw draw(1, 98);
  add_mesh(m, random_box({-half, -half, -half}, {half, half, half}, 10, 0.24, draw));
  const double frequency = 50.0, angular = 2.0 * pi * frequency;
  // Aslant, so that every wall, edge and corner gets its share.
  motions::Sine shaking;
  shaking.wave = {5.0 * 9.81 / (angular * angular), frequency, -0.25};
  shaking.direction = {0.36, 0.48, 0.8};
  m.motions.push_back({shaking});
  m.walls.bodies[0].motions = {0};
  std::vector<Parcel> parcels;
  const double step = 2.1 * radius, start = -half + 1.1 * radius;
  for (int k = 0; k < 10000; ++k) {  // layer upon layer of 22 by 22
    const Vec3 place{start + k % 22 * step, start + k / 22 % 22 * step, start + k / 484 * step};
    parcels.push_back(parcel(static_cast<std::uint32_t>(k), place, radius, 2500, draw.vector(0.05)));
  }
  Simulation s(m, state_of(m, parcels), 1);
  s.start_motion(0);
  const auto steps = static_cast<int>(std::lround(20.0 / frequency / m.dt));
  for (int k = 0; k < steps; ++k) s.step();
  EXPECT_EQ(s.state().ledger.escaped, 0u);
  EXPECT_EQ(s.state().parcels.size(), 10000u);
  for (const Parcel& p : s.state().parcels.body) {
    const Vec3 at = s.pose(0).now.back(p.position);
    for (int axis = 0; axis < 3; ++axis) ASSERT_LT(std::abs(at[axis]), half) << "parcel " << p.id;
  }
}
