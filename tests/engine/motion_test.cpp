// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/draw.hpp"
#include "tests/support/scene.hpp"

using namespace pulvis;

namespace {

TEST(SineMotion, FollowsALongDoubleSine) {
  constexpr long double two_pi = 6.283185307179586476925286766559L;
  for (std::uint64_t k = 0; k < 20000; ++k) {
    pulvis::testing::Draw draw(k, 51);
    const SineMotion m{draw.decades(1e-6, 1.0), draw.decades(0.1, 1e3), draw.between(-1.0, 1.0),
                       draw.direction()};
    const double t = draw.between(0.0, 20.0);
    // The number of cycles is rounded once; the reference starts from the rounded number.
    const long double cycles = m.frequency * t + m.phase;
    const long double turn = std::sin(two_pi * (cycles - std::round(cycles)));
    const long double expected = m.amplitude * (turn - std::sin(two_pi * static_cast<long double>(m.phase)));
    const Vec3 x = m.displacement(t);
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(x[axis], static_cast<double>(expected * static_cast<long double>(m.direction[axis])),
                  6e-16 * m.amplitude);
  }
}

TEST(SineMotion, StartsWhereTheBodyIsAndFromRestAtAQuarterCycleBefore) {
  for (const double phase : {0.0, -0.25, 0.1, 0.7})
    EXPECT_EQ((SineMotion{1e-3, 10.0, phase, {0, 0, 1}}.displacement(0.0)), Vec3{});
  const SineMotion m{1e-3, 10.0, -0.25, {0, 0, 1}};
  EXPECT_NEAR(m.displacement(1e-6).z / 1e-6, 0.0, 1e-3 * m.peak_speed());
  EXPECT_NEAR(m.displacement(0.05).z, 2e-3, 1e-15);
}

TEST(SineMotion, ReachesItsPeakSpeed) {
  const SineMotion m{1e-3, 10.0, 0.0, {1, 0, 0}};
  EXPECT_NEAR((m.displacement(1e-6).x - m.displacement(-1e-6).x) / 2e-6, m.peak_speed(),
              1e-8 * m.peak_speed());
}

TEST(MovingBody, StaysWhereItWasStoppedAndGoesOnFromThere) {
  Model m = scenes::one_material({}, {}, {-1, -1, -1}, {1, 1, 1}, 1e-3, 1e-3, 1e-3);
  scenes::add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  m.motions = {{1e-2, 2.0, 0.0, {0, 0, 1}}};
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
  EXPECT_NEAR(again.pose(0).now.shift.z, there.z + 1e-2 * std::sin(6.283185307179586 * 2.0 * 0.001),
              1e-15);
}

}  // namespace
