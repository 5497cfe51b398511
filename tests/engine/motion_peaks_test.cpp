// SPDX-License-Identifier: Apache-2.0
// Peaks that motions state against what is seen when their displacements are sampled densely.
#include <gtest/gtest.h>

#include "tests/engine/motion_samples.hpp"

using namespace pulvis;
using namespace pulvis::motions;
using pulvis::validation::Draw;
using pulvis::validation::two_pi;

namespace {

/// Largest values seen from central differences over 2 h at `samples` points of a stretch of time. The
/// accelerations are off by (h/time scale)^2/12 and by rounding, 4e-16 of the displacement over h^2.
Peaks sampled(const Motion& m, double from, double to, int samples, double h) {
  Peaks seen;
  for (int k = 0; k <= samples; ++k) {
    const double t = from + h + (to - from - 2.0 * h) * k / samples;
    const Rigid before = displacement(m, t - h), now = displacement(m, t), after = displacement(m, t + h);
    const Vec3 last = turned_between(before, now), next = turned_between(now, after);
    seen.speed = std::max(seen.speed, norm(after.shift - before.shift) / (2.0 * h));
    seen.acceleration =
        std::max(seen.acceleration, norm(after.shift - 2.0 * now.shift + before.shift) / (h * h));
    seen.rate = std::max(seen.rate, norm(last + next) / (2.0 * h));
    seen.angular_acceleration = std::max(seen.angular_acceleration, norm(next - last) / (h * h));
  }
  return seen;
}

void expect_reached(double stated, double seen, double above, const char* what) {
  EXPECT_LE(seen, stated * (1.0 + 1e-6)) << what;
  EXPECT_GE(seen, stated * (1.0 - above)) << what;
}

TEST(Peaks, OfASineAreThoseOfItsFormula) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    Draw draw(k, 101);
    const Sine m{pulvis::validation::some_wave(draw), draw.direction()};
    const double period = 1.0 / m.wave.frequency, omega = two_pi * m.wave.frequency;
    const Peaks stated = peaks({m}), seen = sampled({m}, 0.0, 1.01 * period, 5000, 1e-4 * period);
    EXPECT_DOUBLE_EQ(stated.speed, omega * m.wave.amplitude);
    EXPECT_DOUBLE_EQ(stated.acceleration, omega * omega * m.wave.amplitude);
    expect_reached(stated.speed, seen.speed, 1e-6, "speed");
    expect_reached(stated.acceleration, seen.acceleration, 1e-6, "acceleration");
    EXPECT_EQ(stated.rate, 0.0);
  }
}

TEST(Peaks, OfTurningAreThoseOfItsFormula) {
  const Vec3 point{0.1, 0.2, 0.3}, axis{0.6, 0.0, 0.8};
  const Swing swing{{0.1, 5.0, 0.3}, point, axis};
  const Peaks stated = peaks({swing}), seen = sampled({swing}, 0.0, 0.202, 5000, 4e-5);
  EXPECT_DOUBLE_EQ(stated.rate, two_pi * two_pi * 5.0 * 0.1);
  expect_reached(stated.rate, seen.rate, 1e-6, "rate");
  expect_reached(stated.angular_acceleration, seen.angular_acceleration, 2e-6, "angular acceleration");
  EXPECT_EQ(stated.point, point);
  EXPECT_EQ(stated.axis, axis);
  const Rotation rotation{point, axis, -2.0, 0.5};
  const Peaks turning = peaks({rotation}), turned = sampled({rotation}, 0.0, 1.0, 1000, 1e-4);
  EXPECT_DOUBLE_EQ(turning.rate, 2.0 * two_pi);
  EXPECT_DOUBLE_EQ(turning.angular_acceleration, 4.0 * two_pi);
  expect_reached(turning.rate, turned.rate, 1e-6, "rate");
  expect_reached(turning.angular_acceleration, turned.angular_acceleration, 1e-6, "angular acceleration");
}

TEST(Peaks, OfSinesWithACommonCycleAreReached) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    Draw draw(k, 102);
    Sines m{{}, draw.direction()};
    for (int i = 0; i < 3; ++i)
      m.waves.push_back(
          {draw.decades(1e-4, 1e-3), std::floor(draw.between(1.0, 9.0)), draw.between(-1.0, 1.0)});
    const Peaks stated = peaks({m}), seen = sampled({m}, 0.0, 1.01, 20000, 2e-5);
    expect_reached(stated.speed, seen.speed, 1e-6, "speed");
    expect_reached(stated.acceleration, seen.acceleration, 2e-6, "acceleration");
  }
}

TEST(Peaks, OfSinesWithoutACommonCycleAreNeverPassed) {
  const Sines m{{{1e-3, 10.0, 0.1}, {2e-3, 10.0 * std::sqrt(2.0), 0.7}}, {0, 0, 1}};
  const Peaks stated = peaks({m}), seen = sampled({m}, 0.0, 20.0, 200000, 1e-5);
  expect_reached(stated.speed, seen.speed, 0.01, "speed");
  expect_reached(stated.acceleration, seen.acceleration, 0.01, "acceleration");
}

TEST(Peaks, OfASquareWaveAreNeverPassedAndReachedIfTheModulationIsWhole) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    Draw draw(k, 103);
    SquareWave m = pulvis::validation::some_square_wave(draw);
    const double period = 1.0 / m.frequency, whole = std::round(draw.between(1.0, 20.0));
    m.modulation_period = whole * period;
    const double share = m.rise() / m.modulation();
    const int samples = static_cast<int>(2000.0 / share);
    const Peaks stated = peaks({m}), seen = sampled({m}, 0.0, m.modulation(), samples, 3e-4 * m.rise());
    EXPECT_NEAR(stated.speed, m.amplitude * 15.0 / (4.0 * m.rise()), 1e-14 * stated.speed);
    expect_reached(stated.speed, seen.speed, 2e-6, "speed");
    expect_reached(stated.acceleration, seen.acceleration, 2e-6 + share * share, "acceleration");
  }
}

TEST(Peaks, OfASquareWaveAreNeverPassedAndNearlyReachedIfTheModulationIsNot) {
  for (std::uint64_t k = 0; k < 20; ++k) {
    Draw draw(k, 104);
    SquareWave m = pulvis::validation::some_square_wave(draw);
    const double periods = draw.between(2.0, 12.0);
    m.modulation_period = periods / m.frequency;
    const double span = m.modulation(), miss = std::numbers::pi / (4.0 * periods);
    const int samples = static_cast<int>(2000.0 * span / m.rise());
    const Peaks stated = peaks({m}), seen = sampled({m}, 0.0, span, samples, 3e-4 * m.rise());
    expect_reached(stated.speed, seen.speed, 1.1 * miss * miss, "speed");
    expect_reached(stated.acceleration, seen.acceleration, 1.1 * miss * miss + 1e-5, "acceleration");
  }
}

TEST(Peaks, OfASquareWaveUnderASlowModulationAreThoseOfTheFlank) {
  const SquareWave m{1e-3, 20.0, {0, 0, 1}, 5e-3, 1e4};
  EXPECT_NEAR(peaks({m}).speed, 3.75 * 1e-3 / 5e-3, 1e-15);
  EXPECT_NEAR(peaks({m}).acceleration / (20.0 / std::sqrt(3.0) * 1e-3 / 25e-6), 1.0, 1e-12);
}

TEST(Peaks, OfAPathAreReachedInOneOfItsPieces) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    Draw draw(k, 105);
    const auto between = k % 4 == 0 ? Path::Between::linear : Path::Between::cubic;
    const Path m = pulvis::validation::some_path(draw, between, 2 + k % 7);
    Peaks seen;
    for (std::size_t i = 0; i + 1 < m.times.size(); ++i) {
      const double h = m.times[i + 1] - m.times[i];
      const Peaks piece = sampled({m}, m.times[i], m.times[i + 1], 2000, 1e-4 * h);
      seen.speed = std::max(seen.speed, piece.speed);
      seen.acceleration = std::max(seen.acceleration, piece.acceleration);
    }
    const Peaks stated = peaks({m});
    expect_reached(stated.speed, seen.speed, 1e-3, "speed");
    if (between == Path::Between::linear || m.times.size() == 2)
      EXPECT_LT(stated.acceleration, 1e-10);
    else
      expect_reached(stated.acceleration, seen.acceleration, 1e-3, "acceleration");
  }
}

TEST(Peaks, OfAStrokeAndATranslation) {
  for (std::uint64_t k = 0; k < 100; ++k) {
    Draw draw(k, 106);
    const Stroke m = pulvis::validation::some_stroke(draw);
    const Peaks stated = peaks({m});
    const double time = *duration({m}), ramp = stated.speed / m.acceleration;
    const Peaks all = sampled({m}, 0.0, time, 20000, 1e-3 * ramp);
    EXPECT_LE(all.speed, stated.speed * (1.0 + 1e-6));
    EXPECT_LE(all.acceleration, stated.acceleration * (1.0 + 1e-4));
    const Peaks seen = sampled({m}, 0.0, 1.1 * ramp, 2000, 1e-3 * ramp);
    expect_reached(stated.speed, seen.speed, 1e-3, "speed");
    expect_reached(stated.acceleration, seen.acceleration, 1e-6, "acceleration");
  }
  EXPECT_EQ(peaks({Translation{{3, 0, 4}}}).speed, 5.0);
  EXPECT_EQ(peaks({Translation{{3, 0, 4}}}).acceleration, 0.0);
}

}  // namespace
