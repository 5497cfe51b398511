// SPDX-License-Identifier: Apache-2.0
// A sphere on a plane under tilted gravity: sliding, rolling and sticking. Rolling resistance:
// validation/rolling.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/incline.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double gravity = Incline::gravity, radius = Incline::radius,
                 degree = 3.14159265358979323846 / 180.0;

Incline incline(double angle, double friction, double rolling_friction = 0.0) {
  return {.angle = angle * degree, .friction = friction, .rolling_friction = rolling_friction};
}

const Parcel& sphere(const Simulation& s) { return s.state().parcels.body[0]; }

/// The sphere after a time.
Parcel after(const Incline& i, double seconds) {
  Simulation s = i.start();
  run_to(s, seconds);
  return sphere(s);
}

TEST(SphereOnAnIncline, SlidesWithCoulombFrictionWhereItIsSteep) {
  // tan(theta) > 3.5 mu: a = g (sin - mu cos), d(omega)/dt = 5 mu g cos/(2 R).
  for (const double angle : {30.0, 45.0, 60.0}) {
    const Parcel p = after(incline(angle, 0.15), 0.2);
    const double s = std::sin(angle * degree), c = std::cos(angle * degree);
    EXPECT_NEAR(p.velocity.x / (0.2 * gravity * (s - 0.15 * c)), 1.0, 2e-3) << angle;
    EXPECT_NEAR(p.spin.y / (0.2 * 2.5 * 0.15 * gravity * c / radius), 1.0, 2e-3) << angle;
    EXPECT_NEAR(p.velocity.y, 0.0, 1e-12);
  }
}

TEST(SphereOnAnIncline, RollsWithoutSlippingWhereItIsShallow) {
  // a = 5/7 g sin(theta), v = omega R.
  for (const double angle : {5.0, 20.0, 40.0}) {
    const Parcel p = after(incline(angle, 0.5), 0.2);
    EXPECT_NEAR(p.velocity.x / (0.2 * 5.0 / 7.0 * gravity * std::sin(angle * degree)), 1.0, 2e-3) << angle;
    EXPECT_NEAR(p.spin.y * radius / p.velocity.x, 1.0, 1e-3) << angle;
  }
}

TEST(SphereOnAnIncline, BeginsToSlipWhereTheTangentIsThreeAndAHalfTimesTheFriction) {
  const double angle = 35.0, threshold = std::tan(angle * degree) / 3.5;
  const auto slip = [&](double friction) {
    const Parcel p = after(incline(angle, friction), 0.3);
    return (p.velocity.x - p.spin.y * radius) / p.velocity.x;
  };
  EXPECT_LT(slip(1.01 * threshold), 1e-3);
  EXPECT_GT(slip(0.99 * threshold), 5e-3);
}

TEST(SphereThatCannotRoll, SlidesOrSticksAsTheTangentIsAboveOrBelowTheFriction) {
  for (const double angle : {10.0, 20.0, 35.0}) {
    const double tangent = std::tan(angle * degree), s = std::sin(angle * degree),
                 c = std::cos(angle * degree);
    // Released suddenly it swings on its rolling spring, which nothing damps, and slips a little less than it
    // should until it is faster than the swing; then 1 % of the pull of gravity is left.
    Simulation slides = incline(angle, 0.99 * tangent, 2.0).start();
    run_to(slides, 0.3);
    const double speed = sphere(slides).velocity.x;
    run_to(slides, 0.6);
    const double gained = sphere(slides).velocity.x - speed;
    EXPECT_NEAR(gained / (0.3 * gravity * (s - 0.99 * tangent * c)), 1.0, 1e-2) << angle;
    Simulation rests = incline(angle, 1.01 * tangent, 2.0).start();
    run_to(rests, 0.3);
    const double there = sphere(rests).position.x;
    run_to(rests, 0.6);
    EXPECT_NEAR(sphere(rests).position.x, there, 1e-6) << angle;
    EXPECT_LT(there, 0.05 * radius);
  }
}

}  // namespace
