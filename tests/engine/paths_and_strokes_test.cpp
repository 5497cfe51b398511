// SPDX-License-Identifier: Apache-2.0
// Motions along a table of places and passes of a feeding shoe.
#include <gtest/gtest.h>

#include <array>

#include "tests/engine/motion_samples.hpp"

using namespace pulvis;
using namespace pulvis::motions;
using pulvis::validation::Draw;
using pulvis::validation::some_path;
using pulvis::validation::some_stroke;

namespace {

Path heights(std::vector<double> times, const std::vector<double>& z) {
  Path m{std::move(times), {}, Path::Between::cubic};
  for (const double value : z) m.positions.push_back({0, 0, value});
  return m;
}

double z(const Path& m, double t) { return displacement({m}, t).shift.z; }

double velocity(const Path& m, double t) { return (z(m, t + 1e-6) - z(m, t - 1e-6)) / 2e-6; }

TEST(Path, PassesItsPointsExactlyAndStaysAtTheLast) {
  for (std::uint64_t k = 0; k < 500; ++k) {
    Draw draw(k, 81);
    const auto between = draw.chance(0.5) ? Path::Between::cubic : Path::Between::linear;
    const Path m = some_path(draw, between, 2 + k % 9);
    for (std::size_t i = 0; i < m.times.size(); ++i)
      ASSERT_EQ(displacement({m}, m.times[i]), Rigid::translation(m.positions[i] - m.positions[0]));
    ASSERT_EQ(displacement({m}, 0.5 * m.times[0]), Rigid{});
    ASSERT_EQ(displacement({m}, m.times.back() + 1.0).shift, m.positions.back() - m.positions[0]);
    ASSERT_EQ(duration({m, 2.0}), 2.0 + m.times.back());
  }
}

/// Velocity at point i after Steffen, with signs and minima as he writes them.
long double true_velocity(const Path& m, std::size_t i, int axis) {
  const auto sign = [](long double x) { return x > 0 ? 1.0L : x < 0 ? -1.0L : 0.0L; };
  const auto h = [&](std::size_t k) { return static_cast<long double>(m.times[k + 1]) - m.times[k]; };
  const auto s = [&](std::size_t k) {
    return (static_cast<long double>(m.positions[k + 1][axis]) - m.positions[k][axis]) / h(k);
  };
  const std::size_t last = m.times.size() - 1;
  if (i > 0 && i < last) {
    const long double p = (s(i - 1) * h(i) + s(i) * h(i - 1)) / (h(i - 1) + h(i));
    return (sign(s(i - 1)) + sign(s(i))) * std::min({std::abs(s(i - 1)), std::abs(s(i)), 0.5L * std::abs(p)});
  }
  const std::size_t own = i == 0 ? 0 : last - 1, next = i == 0 ? 1 : last - 2;
  const long double share = h(own) / (h(own) + h(next));
  const long double p = s(own) * (1.0L + share) - s(next) * share;
  return (sign(p) + sign(s(own))) * std::min(std::abs(s(own)), 0.5L * std::abs(p));
}

TEST(Path, IsTheHermiteCubicOfSteffensVelocities) {
  for (std::uint64_t k = 0; k < 5000; ++k) {
    Draw draw(k, 82);
    const Path m = some_path(draw, Path::Between::cubic, 3 + k % 6);
    const auto i = static_cast<std::size_t>(draw.between(0.0, static_cast<double>(m.times.size() - 1)));
    const long double u = draw.between(0.0, 1.0), h = static_cast<long double>(m.times[i + 1]) - m.times[i];
    const auto t = static_cast<double>(m.times[i] + u * h);
    const long double x = (t - static_cast<long double>(m.times[i])) / h;
    const Vec3 ours = displacement({m}, t).shift;
    for (int axis = 0; axis < 3; ++axis) {
      const long double expected = (1 + 2 * x) * (1 - x) * (1 - x) * m.positions[i][axis] +
                                   x * x * (3 - 2 * x) * m.positions[i + 1][axis] +
                                   h * x * (1 - x) * (1 - x) * true_velocity(m, i, axis) -
                                   h * x * x * (1 - x) * true_velocity(m, i + 1, axis);
      ASSERT_NEAR(ours[axis], static_cast<double>(expected - m.positions[0][axis]), 1e-14 * 0.1);
    }
  }
}

TEST(Path, MeetsAParabolaExactly) {
  // Uneven times; none of Steffen's limits is reached.
  const Path m = heights({0.0, 0.1, 0.25, 0.3, 0.6}, {0.0, 0.21, 0.5625, 0.69, 1.56});
  for (double t = 0.0; t < 0.6; t += 0.001) ASSERT_NEAR(z(m, t), t * t + 2.0 * t, 1e-15);
}

TEST(Path, LimitsItsVelocityAsWorkedByHand) {
  // Slopes 1, 10, -2, -2: the parabola at point 2 has 5.5, limited to 2; at the turn 0; then -2; at the start
  // the parabola has 1 - 4.5 < 0, so 0; at the end -2.
  const Path m = heights({0, 1, 2, 3, 4}, {0, 1, 11, 9, 7});
  EXPECT_NEAR(z(m, 1e-4) / 1e-4, 0.0, 1e-3);
  EXPECT_NEAR(velocity(m, 1.0), 2.0, 1e-4);
  EXPECT_NEAR(velocity(m, 2.0), 0.0, 1e-4);
  EXPECT_NEAR(velocity(m, 3.0), -2.0, 1e-5);
  EXPECT_NEAR((z(m, 4.0) - z(m, 4.0 - 1e-5)) / 1e-5, -2.0, 1e-5);
  // Half way in the second piece: (1 + 11)/2 + h (v0 - v1)/8.
  EXPECT_NEAR(z(m, 1.5), 6.25, 1e-14);
}

TEST(Path, IsMonotoneWhereItsPointsAre) {
  for (std::uint64_t k = 0; k < 300; ++k) {
    Draw draw(k, 83);
    const Path m = some_path(draw, Path::Between::cubic, 8);
    for (std::size_t i = 0; i + 1 < m.times.size(); ++i) {
      const double h = m.times[i + 1] - m.times[i];
      Vec3 before = displacement({m}, m.times[i]).shift;
      for (int n = 1; n <= 200; ++n) {
        const Vec3 now = displacement({m}, m.times[i] + h * n / 200.0).shift;
        for (int axis = 0; axis < 3; ++axis) {
          const bool rises = m.positions[i + 1][axis] > m.positions[i][axis];
          ASSERT_GE((rises ? 1.0 : -1.0) * (now[axis] - before[axis]), -5e-17);
        }
        before = now;
      }
    }
  }
}

TEST(Path, HasNoJumpInVelocityIfCubic) {
  for (std::uint64_t k = 0; k < 300; ++k) {
    Draw draw(k, 84);
    const Path m = some_path(draw, Path::Between::cubic, 8);
    const double limit = peaks({m}).acceleration;
    for (std::size_t i = 1; i + 1 < m.times.size(); ++i) {
      const auto x = [&](double h) { return displacement({m}, m.times[i] + h).shift; };
      constexpr double h = 1e-6;
      ASSERT_LT(norm(x(h) - 2.0 * x(0.0) + x(-h)) / h, 1.001 * limit * h + 1e-9);
    }
  }
}

TEST(Path, OfTwoPointsIsStraightAndLinearOnesToo) {
  Path m{{0.0, 2.0}, {{1, 1, 1}, {2, 3, 1}}, Path::Between::cubic};
  EXPECT_EQ(displacement({m}, 0.5).shift, (Vec3{0.25, 0.5, 0.0}));
  m = {{0.0, 2.0, 3.0}, {{1, 1, 1}, {2, 3, 1}, {2, 3, 5}}, Path::Between::linear};
  EXPECT_EQ(displacement({m}, 0.5).shift, (Vec3{0.25, 0.5, 0.0}));
  EXPECT_EQ(displacement({m}, 2.25).shift, (Vec3{1.0, 2.0, 1.0}));
}

/// Way of one pass by integrating its speed, which is linear between its corners; exact in long double.
long double true_way(const Stroke& m, long double t) {
  const long double v =
      std::min<long double>(m.speed, std::sqrt(static_cast<long double>(m.acceleration) * m.distance));
  const long double ramp = v / m.acceleration, cruise = std::max(m.distance - v * ramp, 0.0L) / v;
  const std::array<long double, 4> corner = {0.0L, ramp, ramp + cruise, 2.0L * ramp + cruise};
  const std::array<long double, 4> speed = {0.0L, v, v, 0.0L};
  long double way = 0.0L;
  for (std::size_t i = 0; i < 3; ++i) {
    const long double h = corner[i + 1] - corner[i], in = std::clamp(t - corner[i], 0.0L, h);
    if (in > 0.0L) way += in * (speed[i] + 0.5L * (speed[i + 1] - speed[i]) * (in / h));
  }
  return way;
}

TEST(Stroke, IsTheIntegralOfItsSpeeds) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(k, 85);
    const Stroke m = some_stroke(draw);
    const long double v =
        std::min<long double>(m.speed, std::sqrt(static_cast<long double>(m.acceleration) * m.distance));
    const long double pass = m.distance / v + v / m.acceleration;
    const auto whole =
        static_cast<double>(m.passes * pass + (m.passes - 1) * static_cast<long double>(m.pause));
    ASSERT_NEAR(*duration({m}), whole, 1e-14 * whole);
    const double t = draw.between(0.0, 1.1 * whole);
    long double way = 0.0L;
    for (int n = 0; n < m.passes; ++n) way += (n % 2 == 0 ? 1 : -1) * true_way(m, t - n * (pass + m.pause));
    const Vec3 ours = displacement({m}, t).shift;
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(ours[axis], static_cast<double>(way * m.direction[axis]), 1e-14 * m.distance * m.passes);
  }
}

TEST(Stroke, ReturnsExactlyAndRestsExactly) {
  for (std::uint64_t k = 0; k < 2000; ++k) {
    Draw draw(k, 86);
    Stroke m = some_stroke(draw);
    const double end = *duration({m});
    for (const double late : {0.0, 1e-9, 1.0, 1e6})
      ASSERT_EQ(displacement({m}, end * (1.0 + 1e-15) + late).shift,
                m.passes % 2 == 0 ? Vec3{} : m.distance * m.direction);
    m.pause = 0.5;
    m.passes = 3;
    const double pass = *duration({Stroke{m.distance, m.direction, m.speed, m.acceleration, 1, 0.0}});
    for (const double share : {0.01, 0.5, 0.99}) {
      ASSERT_EQ(displacement({m}, pass + share * m.pause).shift, m.distance * m.direction);
      ASSERT_EQ(displacement({m}, 2.0 * pass + (1.0 + share) * m.pause).shift, Vec3{});
    }
  }
}

TEST(Stroke, NeverLeavesItsWayNorJumps) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 87);
    Stroke m = some_stroke(draw);
    m.direction = {1, 0, 0};
    const double step = *duration({m}) / 3000.0, fastest = peaks({m}).speed;
    double before = 0.0;
    for (int n = 1; n <= 3010; ++n) {
      const double x = displacement({m}, n * step).shift.x;
      ASSERT_GE(x, 0.0);
      ASSERT_LE(x, m.distance);
      ASSERT_LE(std::abs(x - before), fastest * step * (1.0 + 1e-12) + 1e-15);
      before = x;
    }
  }
}

}  // namespace
