// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

TEST(FreeFall, IsAParabolaToRounding) {
  // Velocity Verlet is exact under a constant force; only rounding remains: 10^5 steps of at most 2e-15 each.
  Model m = one_material({}, {}, {-100, -100, -100}, {100, 100, 100}, 1e-5, 1e-3, 1e-3);
  m.body_force.gravity = {3.0, -4.0, -9.81};
  const Vec3 start{1, 2, 3}, velocity{-0.5, 0.25, 2.0}, spin{10, 20, -30};
  Simulation s(m, state_of(m, {parcel(0, start, 1e-3, 2500.0, velocity, spin)}), 1);
  for (int k = 0; k < 100000; ++k) s.step();
  const double t = s.time();
  const Parcel& p = s.state().parcels.body[0];
  const Vec3 expected = start + t * velocity + (0.5 * t * t) * m.body_force.gravity;
  EXPECT_LT(norm(p.position - expected), 1e-10);
  EXPECT_LT(norm(p.velocity - (velocity + t * m.body_force.gravity)), 1e-10);
  EXPECT_EQ(p.spin, spin);
  RecordProperty("position_error_m_e15", std::to_string(1e15 * norm(p.position - expected)));
}

TEST(FreeFlight, AcrossPeriodicBoundariesIsStraight) {
  Model m = one_material({}, {}, {0, 0, 0}, {0.01, 0.02, 0.03}, 1e-5, 1e-4, 1e-4);
  m.body_force.gravity = {};
  for (bool& axis : m.domain.periodic) axis = true;
  const Vec3 start{0.001, 0.002, 0.003}, velocity{1.0, -2.0, 0.5};
  Simulation s(m, state_of(m, {parcel(0, start, 1e-4, 2500.0, velocity)}), 1);
  for (int k = 0; k < 10000; ++k) s.step();
  const Vec3 expected = start + s.time() * velocity, extent = m.domain.extent();
  for (int axis = 0; axis < 3; ++axis) {
    const double turns = (expected[axis] - s.state().parcels.body[0].position[axis]) / extent[axis];
    EXPECT_NEAR(turns, std::round(turns), 1e-9);
    EXPECT_GT(std::fabs(turns), 0.9);
  }
}

}  // namespace
