// SPDX-License-Identifier: Apache-2.0
// Displacements of all kinds of motion against independent evaluations in long double.
#include "engine/walls/motions/motion.hpp"

#include <gtest/gtest.h>

#include "tests/engine/motion_samples.hpp"

using namespace pulvis;
using namespace pulvis::motions;
using pulvis::validation::Draw;
using pulvis::validation::true_sine;

namespace {

void expect_near(const Vec3& ours, long double along, const Vec3& direction, double tolerance) {
  for (int i = 0; i < 3; ++i)
    ASSERT_NEAR(ours[i], static_cast<double>(along * static_cast<long double>(direction[i])), tolerance);
}

long double true_wave(const Wave& w, double t) {
  const long double f = w.frequency, phase = w.phase;
  return w.amplitude * (true_sine(f * t + phase) - true_sine(phase));
}

TEST(Motion, StandsStillUpToItsStart) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 71);
    for (const Kind& kind : pulvis::validation::one_of_each(draw)) {
      ASSERT_EQ(displacement({kind}, 0.0), Rigid{});
      const Motion later{kind, 0.25};
      for (const double t : {-1.0, 0.0, 0.1, 0.25}) ASSERT_EQ(displacement(later, t), Rigid{});
      // No jump either.
      const Rigid soon = displacement({kind}, 1e-12);
      ASSERT_LT(norm(soon(Vec3{}) - Vec3{}), 1e-10) << kind.index();
    }
  }
}

TEST(Motion, CountsItsOwnTimeFromItsStartAndStaysFromItsEndOn) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 72);
    for (const Kind& kind : pulvis::validation::one_of_each(draw)) {
      const Motion m{kind, 0.25, 1.5};  // differences of these numbers are exact
      for (const double t : {0.5, 1.0, 1.5}) ASSERT_EQ(displacement(m, t), displacement({kind}, t - 0.25));
      for (const double t : {1.5000001, 2.0, 1e6}) ASSERT_EQ(displacement(m, t), displacement(m, 1.5));
    }
  }
}

TEST(Translation, MovesAtItsVelocity) {
  const Motion m{Translation{{0.1, -0.2, 0.4}}, 1.0};
  EXPECT_EQ(displacement(m, 3.0), Rigid::translation({0.2, -0.4, 0.8}));
}

TEST(Rotation, TurnsByTheIntegralOfItsRate) {
  for (std::uint64_t k = 0; k < 5000; ++k) {
    Draw draw(k, 73);
    const Rotation m{draw.vector(0.1), draw.direction(), draw.between(-5.0, 5.0), draw.between(0.0, 2.0)};
    const double t = draw.between(0.0, 10.0);
    // The rate is a trapezium over time.
    const long double ramp = m.ramp, rising = std::min<long double>(t, ramp);
    const long double cycles = m.rate * (0.5L * rising * (rising / ramp) + (t - rising));
    const Rigid ours = displacement({m}, t);
    const Vec3 across = cross(m.axis, draw.direction()), ahead = cross(m.axis, across);
    const long double c = true_sine(cycles + 0.25L), s = true_sine(cycles);
    const Vec3 moved = ours(m.point + across) - m.point;
    for (int i = 0; i < 3; ++i)
      ASSERT_NEAR(moved[i], static_cast<double>(c * across[i] + s * ahead[i]), 1e-13);
    ASSERT_LT(norm(ours(m.point + m.axis) - m.point - m.axis), 1e-15);
  }
}

TEST(Sine, FollowsALongDoubleSine) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(k, 74);
    const Sine m{pulvis::validation::some_wave(draw), draw.direction()};
    const double t = draw.between(0.0, 100.0 / m.wave.frequency);
    expect_near(displacement({m}, t).shift, true_wave(m.wave, t), m.direction, 1e-13 * m.wave.amplitude);
  }
}

TEST(Swing, TurnsToAndFroAboutItsAxis) {
  for (std::uint64_t k = 0; k < 2000; ++k) {
    Draw draw(k, 75);
    Swing m{pulvis::validation::some_wave(draw), draw.vector(0.1), draw.direction()};
    m.wave.amplitude = draw.decades(1e-3, 0.5);
    const double t = draw.between(0.0, 100.0 / m.wave.frequency);
    const auto cycles = static_cast<double>(true_wave(m.wave, t));
    const Vec3 x = draw.vector(0.1);
    ASSERT_LT(norm(displacement({m}, t)(x) - Rigid::rotation(cycles, m.point, m.axis)(x)), 1e-13);
  }
}

TEST(Sines, AreTheSumOfTheirParts) {
  for (std::uint64_t k = 0; k < 5000; ++k) {
    Draw draw(k, 76);
    Sines m{{}, draw.direction()};
    for (int i = 0; i < 4; ++i) m.waves.push_back(pulvis::validation::some_wave(draw));
    const double t = draw.between(0.0, 0.5);
    long double along = 0.0L, sizes = 0.0L;
    for (const Wave& w : m.waves) along += true_wave(w, t), sizes += w.amplitude;
    expect_near(displacement({m}, t).shift, along, m.direction, 1e-13 * static_cast<double>(sizes));
  }
}

TEST(Sines, OfOneIsTheSineToTheBit) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 77);
    const Wave wave = pulvis::validation::some_wave(draw);
    const Vec3 d = draw.direction();
    const double t = draw.between(0.0, 5.0);
    ASSERT_EQ(displacement({Sines{{wave}, d}}, t), displacement({Sine{wave, d}}, t));
  }
}

/// In other words than the engine's: flanks numbered in time, smoothstep u^3 (10 - 15 u + 6 u^2) and a raised
/// cosine.
long double true_square_wave(const SquareWave& m, double t) {
  const long double f = m.frequency, rise = m.rise();
  const long double number = std::round(2.0L * f * t);
  const long double u = std::clamp((t - number / (2.0L * f)) / rise + 0.5L, 0.0L, 1.0L);
  const long double step = 2.0L * u * u * u * (10.0L + u * (-15.0L + 6.0L * u)) - 1.0L;
  const long double swell = 0.5L * (1.0L - true_sine(static_cast<long double>(t) / m.modulation() + 0.25L));
  return (std::remainder(number, 2.0L) == 0.0L ? step : -step) * swell * m.amplitude;
}

TEST(SquareWave, FollowsItsEquations) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    Draw draw(k, 78);
    const SquareWave m = pulvis::validation::some_square_wave(draw);
    const double t = draw.between(0.0, 100.0 / m.frequency);
    // The rounding of f t, 1.1e-14 of a cycle at most here, counts by the steepness of the flank.
    const double tolerance = m.amplitude * (1e-13 + 2e-14 * 3.75 / (m.frequency * m.rise()));
    expect_near(displacement({m}, t).shift, true_square_wave(m, t), m.direction, tolerance);
  }
}

TEST(SquareWave, StandsOnItsPlateausAndCrossesOnItsFlanks) {
  // Modulation so slow that it is at its crest for the wave looked at.
  const SquareWave m{1e-3, 10.0, {0, 0, 1}, 0.02, 2e6};
  const auto z = [&](double t) { return displacement({m}, 1e6 + t).shift.z; };
  EXPECT_NEAR(z(0.0), 0.0, 1e-9);
  for (const double t : {0.01, 0.02, 0.025, 0.04}) EXPECT_NEAR(z(t), 1e-3, 1e-12);
  EXPECT_NEAR(z(0.05), 0.0, 1e-9);
  for (const double t : {0.06, 0.08, 0.09}) EXPECT_NEAR(z(t), -1e-3, 1e-12);
}

TEST(SquareWave, SwellsFromNothingAndFadesToNothing) {
  const SquareWave m{1e-3, 10.0, {0, 0, 1}, {}, {}};
  EXPECT_EQ(m.rise(), 0.01);
  EXPECT_EQ(m.modulation(), 1.0);
  EXPECT_NEAR(displacement({m}, 0.525).shift.z, 1e-3 * square(std::sin(0.525 * std::numbers::pi)), 1e-16);
  for (const double t : {1.0, 2.0, 5.0}) EXPECT_LT(std::abs(displacement({m}, t).shift.z), 1e-30);
}

TEST(SquareWave, HasNoJumpInVelocityOrAcceleration) {
  for (const double rise : {0.1, 0.3, 0.5}) {
    const SquareWave m{1.0, 1.0, {0, 0, 1}, rise, 4.0};
    const auto z = [&](double t) { return displacement({m}, t).shift.z; };
    // The third derivative is at most 15 * 8/t_r^3 and some for the modulation.
    const double jerk = 200.0 / (rise * rise * rise);
    for (const double centre : {0.5, 1.0, 1.5, 2.0, 2.5})
      for (const double edge : {centre - 0.5 * rise, centre, centre + 0.5 * rise})
        for (const double h : {1e-3, 1e-4}) {
          const double before = z(edge - h) - 2.0 * z(edge - 2.0 * h) + z(edge - 3.0 * h);
          const double after = z(edge + 3.0 * h) - 2.0 * z(edge + 2.0 * h) + z(edge + h);
          EXPECT_NEAR(after / (h * h), before / (h * h), 4.0 * h * jerk + 1e-15 / (h * h));
          const double jump = (z(edge + 2.0 * h) - z(edge + h)) - (z(edge - h) - z(edge - 2.0 * h));
          EXPECT_NEAR(jump / h, 0.0, 3.0 * h * peaks({m}).acceleration + 1e-15 / h);
        }
  }
}

TEST(Motion, LosesNoMoreAfterALongTimeThanTheRoundingOfItsCycles) {
  double worst_sine = 0.0, worst_square = 0.0;
  for (std::uint64_t k = 0; k < 5000; ++k) {
    Draw draw(k, 79);
    const double t = draw.between(0.9e6, 1e6);
    const Sine sine{pulvis::validation::some_wave(draw), {0, 0, 1}};
    const double cycles = sine.wave.frequency * t;
    const auto miss = displacement({sine}, t).shift.z - true_wave(sine.wave, t);
    worst_sine = std::max(worst_sine, static_cast<double>(std::abs(miss)) / (sine.wave.amplitude * cycles));
    SquareWave wave = pulvis::validation::some_square_wave(draw);
    wave.direction = {0, 0, 1};
    const auto off = displacement({wave}, t).shift.z - true_square_wave(wave, t);
    const double steepness = 1.0 / (wave.frequency * wave.rise());
    worst_square = std::max(
        worst_square, static_cast<double>(std::abs(off)) / (wave.amplitude * wave.frequency * t * steepness));
  }
  EXPECT_LT(worst_sine, 1.4e-15);
  EXPECT_LT(worst_square, 7e-16);
}

}  // namespace
