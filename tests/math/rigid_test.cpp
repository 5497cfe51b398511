// SPDX-License-Identifier: Apache-2.0
#include "engine/math/rigid.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "validation/draw.hpp"

using namespace pulvis;
using pulvis::validation::Draw;

namespace {

using Long = std::array<long double, 3>;

/// The point turned by a unit quaternion, in long double: q x q* multiplied out, not the formula under test.
Long turned(double cycles, const Vec3& point, const Vec3& axis, const Vec3& x) {
  const long double half = std::numbers::pi_v<long double> * static_cast<long double>(cycles);
  const long double w = std::cos(half), s = std::sin(half);
  const long double a = s * axis.x, b = s * axis.y, c = s * axis.z;
  const Long v = {static_cast<long double>(x.x) - point.x, static_cast<long double>(x.y) - point.y,
                  static_cast<long double>(x.z) - point.z};
  return {point.x + (w * w + a * a - b * b - c * c) * v[0] + 2 * (a * b - w * c) * v[1] +
              2 * (a * c + w * b) * v[2],
          point.y + 2 * (a * b + w * c) * v[0] + (w * w - a * a + b * b - c * c) * v[1] +
              2 * (b * c - w * a) * v[2],
          point.z + 2 * (a * c - w * b) * v[0] + 2 * (b * c + w * a) * v[1] +
              (w * w - a * a - b * b + c * c) * v[2]};
}

Rigid some_rigid(Draw& draw) {
  return Rigid::translation(draw.vector(1.0)) *
         Rigid::rotation(draw.between(-1.0, 1.0), draw.vector(1.0), draw.direction());
}

TEST(Rigid, TurnsAsALongDoubleQuaternionDoes) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(k, 61);
    const double cycles = draw.between(-2.0, 2.0);
    const Vec3 point = draw.vector(1.0), axis = draw.direction(), x = draw.vector(1.0);
    const Vec3 ours = Rigid::rotation(cycles, point, axis)(x);
    const Long exact = turned(cycles, point, axis, x);
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(ours[i], static_cast<double>(exact[i]), 2e-15);
  }
}

TEST(Rigid, AWholeTurnIsNoneAndAQuarterIsExact) {
  EXPECT_EQ(Rigid::rotation(3.0, {1, 2, 3}, {0, 0, 1}), Rigid{});
  EXPECT_EQ(Rigid::rotation(0.25, {0, 0, 0}, {0, 0, 1})(Vec3{1, 0, 5}), (Vec3{0, 1, 5}));
  EXPECT_EQ(Rigid::rotation(0.25, {1, 1, 0}, {0, 0, 1})(Vec3{2, 1, 5}), (Vec3{1, 2, 5}));
}

TEST(Rigid, AShiftMovesToTheSameBitsAsAddingIt) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Draw draw(k, 62);
    const Vec3 by = draw.vector(1.0), x = draw.vector(1e-3);
    ASSERT_EQ(Rigid::translation(by)(x), x + by);
    ASSERT_EQ((Rigid::translation(by) * Rigid{})(x), x + by);
  }
}

TEST(Rigid, ThePointsOfTheAxisStay) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Draw draw(k, 63);
    const Vec3 point = draw.vector(1.0), axis = draw.direction();
    const Vec3 on_axis = point + draw.between(-1.0, 1.0) * axis;
    ASSERT_LT(norm(Rigid::rotation(draw.between(0.0, 1.0), point, axis)(on_axis) - on_axis), 2e-15);
  }
}

TEST(Rigid, ComposesFromTheRightAndGoesBack) {
  for (std::uint64_t k = 0; k < 5000; ++k) {
    Draw draw(k, 64);
    const Rigid inner = some_rigid(draw), outer = some_rigid(draw);
    const Vec3 x = draw.vector(1.0);
    ASSERT_LT(norm((outer * inner)(x)-outer(inner(x))), 4e-15);
    ASSERT_LT(norm(outer.back(outer(x)) - x), 4e-15);
    ASSERT_LT(norm(outer.turn_back(outer.turn(x)) - x), 2e-15);
    EXPECT_NEAR(norm(outer.turn(x)), norm(x), 1e-15);
  }
}

TEST(Rigid, TheTurnBetweenTwoPosesIsOffByItsCubeOverSix) {
  for (std::uint64_t k = 0; k < 1000; ++k) {
    Draw draw(k, 65);
    const Rigid before = some_rigid(draw);
    const Vec3 axis = draw.direction();
    for (const double angle : {0.2, 0.1, 0.05, 1e-3}) {
      const double cycles = angle / (2.0 * std::numbers::pi);
      const Rigid now = Rigid::rotation(cycles, draw.vector(1.0), axis) * before;
      const Vec3 error = angle * axis - turned_between(before, now);
      ASSERT_NEAR(dot(error, axis), std::pow(angle, 3) / 6.0, std::pow(angle, 5) / 119.0 + 1e-15);
      ASSERT_LT(norm(cross(error, axis)), 1e-15);
    }
  }
}

TEST(Rigid, SmallTurnsAddUpToALargeOne) {
  const Vec3 point{0.3, -0.2, 0.1}, axis{0.6, 0.0, 0.8};
  Rigid sum;
  constexpr int steps = 10000;
  for (int k = 0; k < steps; ++k) sum = Rigid::rotation(1.0 / (4 * steps), point, axis) * sum;
  const Rigid once = Rigid::rotation(0.25, point, axis);
  for (const Vec3& x : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    EXPECT_LT(norm(sum(x) - once(x)), 1e-12);
}

}  // namespace
