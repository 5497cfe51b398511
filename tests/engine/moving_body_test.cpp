// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "validation/scene.hpp"

using namespace pulvis;

namespace {

TEST(MovingBody, StaysWhereItWasStoppedAndGoesOnFromThere) {
  Model m = scenes::one_material({}, {}, {-1, -1, -1}, {1, 1, 1}, 1e-3, 1e-3, 1e-3);
  scenes::add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  m.motions = {{motions::Sine{{1e-2, 2.0, 0.0}, {0, 0, 1}}}};
  m.walls.bodies[0].motions = {0};
  Simulation s(m, Simulation::initial_state(m), 1);
  s.step();
  EXPECT_EQ(s.pose(0).now.shift, Vec3{});
  s.start_motion(0);
  for (int k = 0; k < 60; ++k) s.step();
  const Vec3 there = s.pose(0).now.shift;
  EXPECT_NEAR(there.z, 1e-2 * std::sin(6.283185307179586 * 2.0 * 0.06), 1e-15);
  s.stop_motion(0);
  for (int k = 0; k < 10; ++k) s.step();
  EXPECT_EQ(s.pose(0).now.shift, there);
  // Also after having been saved.
  Simulation again(m, load_state(save_state(s.snapshot())), 1);
  EXPECT_EQ(again.pose(0).now.shift, there);
  again.start_motion(0);
  again.step();
  EXPECT_NEAR(again.pose(0).now.shift.z, there.z + 1e-2 * std::sin(6.283185307179586 * 2.0 * 0.001), 1e-15);
}

}  // namespace
