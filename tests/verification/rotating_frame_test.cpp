// SPDX-License-Identifier: Apache-2.0
// Motion in a rotating frame against the same motion seen from a frame at rest, and gravity by a table.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/math/rigid.hpp"
#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

struct Flight {
  BodyForce force;
  Vec3 position, velocity, spin;  ///< at the start, seen from the rotating frame
};

/// The parcel after a time, seen from the rotating frame.
Parcel flown(const Flight& f, double seconds, double dt) {
  Model m = one_material({}, {}, {-9, -9, -9}, {9, 9, 9}, dt, 1.0, 1.0);
  m.body_force = f.force;
  Parcel p = parcel(0, f.position, 1.0, 2500, f.velocity, f.spin);
  State state = state_of(m, {p});
  state.parcels.load[0].force = p.mass * f.force.at(0.0).at(f.position);
  Simulation s(m, state, 1);
  const auto steps = static_cast<int>(std::lround(seconds / dt));
  for (int k = 0; k < steps; ++k) s.step();
  return s.state().parcels.body[0];
}

TEST(FreeSphereInARotatingFrame, GoesStraightSeenFromOutsideThroughOneTurn) {
  for (std::uint64_t number = 0; number < 5; ++number) {
    Draw draw(number, 95);
    Flight f;
    f.force.gravity = draw.vector(9.81);
    f.force.rotation = 2.0;  // a turn takes 0.5 s
    f.force.axis = draw.direction();
    f.force.point = draw.vector(0.5);
    f.position = draw.vector(0.5);
    f.velocity = draw.vector(1.0);
    f.spin = draw.vector(20.0);
    const Vec3 omega = 2.0 * pi * f.force.rotation * f.force.axis;
    // At time 0 both frames coincide; from outside it flies a parabola and keeps its spin.
    const Vec3 outside = f.velocity + cross(omega, f.position - f.force.point), spin = f.spin + omega;
    const double t = 0.5;
    const Vec3 end = f.position + t * outside + (0.5 * t * t) * f.force.gravity;
    const Vec3 end_velocity = outside + t * f.force.gravity;
    const Parcel p = flown(f, t, 1e-5);
    // After a whole turn the frames coincide again.
    EXPECT_LT(norm(p.position - end), 1e-6 * norm(end - f.position)) << number;
    const Vec3 seen = end_velocity - cross(omega, end - f.force.point);
    EXPECT_LT(norm(p.velocity - seen), 1e-6 * norm(seen)) << number;
    EXPECT_LT(norm(p.spin + omega - spin), 1e-6 * norm(spin)) << number;
  }
}

TEST(FreeSphereInARotatingFrame, ConvergesAsTheSquareOfTheTimeStepAlsoWhileTheFrameSpeedsUp) {
  Flight f;
  f.force.rotation = 3.0;
  f.force.ramp = 0.2;
  f.force.axis = {0, 0.6, 0.8};
  f.force.point = {0.1, 0, -0.2};
  f.position = {0.3, 0.1, 0.2};
  f.velocity = {0.5, -0.2, 0.1};
  f.spin = {3, 4, 5};
  // Turns after 0.3 s: 3 * 0.2 / 2 while it speeds up, then 3 * 0.1.
  const Rigid frame = Rigid::rotation(0.6, f.force.point, f.force.axis);
  const Vec3 straight = f.position + 0.3 * f.velocity + (0.5 * 0.09) * f.force.gravity;
  const Vec3 expected = frame.back(straight);
  const double coarse = norm(flown(f, 0.3, 1e-3).position - expected),
               fine = norm(flown(f, 0.3, 2.5e-4).position - expected);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2.0, 0.1) << coarse << " " << fine;
  const Vec3 omega = 2.0 * pi * f.force.rotation * f.force.axis;
  EXPECT_LT(norm(frame.turn(flown(f, 0.3, 2.5e-4).spin + omega) - f.spin), 1e-4 * norm(f.spin));
}

TEST(GravityTable, ActsAsItsIntegralSays) {
  Flight f;
  f.force.times = {0.1, 0.3};
  f.force.table = {{0, 0, -10}, {4, 0, -30}};
  const Parcel p = flown(f, 0.5, 1e-5);
  // 0.1 s and 0.2 s of the ends, 0.2 s of the mean.
  EXPECT_NEAR(p.velocity.z, -(1.0 + 4.0 + 6.0), 1e-6);
  EXPECT_NEAR(p.velocity.x, 0.4 + 0.8, 1e-6);
}

}  // namespace
