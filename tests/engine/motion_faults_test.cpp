// SPDX-License-Identifier: Apache-2.0
// What motions say is wrong with them, and what they say of their cycles and ends.
#include <gtest/gtest.h>

#include "tests/engine/motion_samples.hpp"

using namespace pulvis;
using namespace pulvis::motions;
using pulvis::validation::Draw;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Motion, FindsNoFaultInWhatIsSound) {
  for (std::uint64_t k = 0; k < 300; ++k) {
    Draw draw(k, 91);
    for (const Kind& kind : pulvis::validation::one_of_each(draw)) {
      ASSERT_EQ(fault({kind}), std::nullopt) << *fault({kind});
      ASSERT_EQ(fault({kind, 0.5, 2.0}), std::nullopt);
    }
  }
}

TEST(Motion, SaysWhatIsWrong) {
  const Sine sine{{1e-3, 10.0, 0.0}, {0, 0, 1}};
  const auto square_wave = [&](std::optional<double> rise, std::optional<double> modulation) {
    return Motion{SquareWave{1e-3, 10.0, {0, 0, 1}, rise, modulation}};
  };
  const std::vector<std::pair<Motion, std::string>> wrong = {
      {{sine, -1.0}, "the start must not be negative, but is -1 s"},
      {{sine, not_a_number}, "the start is not a finite number"},
      {{sine, 1.0, 1.0}, "the end, 1 s, must be after the start, 1 s"},
      {{sine, 0.0, not_a_number}, "the end, nan s, must be after the start, 0 s"},
      {{Translation{{0, infinity, 0}}},
       "the velocity (0, inf, 0) has a component that is not a finite number"},
      {{Rotation{{}, {0, 0, 2}, 1.0, 0.0}}, "the axis (0, 0, 2) is not of length 1"},
      {{Rotation{{}, {0, 0, 1}, not_a_number, 0.0}}, "the rate is not a finite number"},
      {{Rotation{{}, {0, 0, 1}, 1.0, -0.5}}, "the ramp must not be negative, but is -0.5 s"},
      {{Sine{{1e-3, 0.0, 0.0}, {0, 0, 1}}}, "the frequency must be above 0, but is 0 Hz"},
      {{Sine{{infinity, 1.0, 0.0}, {0, 0, 1}}}, "the amplitude is not a finite number"},
      {{Sine{{1e-3, 1.0, 0.0}, {}}}, "the direction (0, 0, 0) is not of length 1"},
      {{Swing{{1e-3, -1.0, 0.0}, {}, {0, 0, 1}}}, "the frequency must be above 0, but is -1 Hz"},
      {{Swing{{1e-3, 1.0, 0.0}, {not_a_number, 0, 0}, {0, 0, 1}}},
       "the point (nan, 0, 0) has a component that is not a finite number"},
      {{Sines{}}, "it has no sines"},
      {{Sines{{{1, 1, 0}, {1, 0, 0}}, {0, 0, 1}}}, "sine 2: the frequency must be above 0, but is 0 Hz"},
      {square_wave(0.0, {}), "the rise time must be above 0, but is 0 s"},
      {square_wave(0.051, {}), "the rise time 0.051 s is longer than half a period, 0.05 s"},
      {square_wave({}, 0.09), "the period of the modulation 0.09 s is shorter than that of the wave, 0.1 s"},
      {square_wave({}, infinity), "the period of the modulation is not a finite number"},
      {{Path{}}, "it needs at least two times and positions"},
      {{Path{{0, 1}, {{}}, Path::Between::cubic}}, "it has 2 times, but 1 positions"},
      {{Path{{-1, 1}, {{}, {}}, Path::Between::cubic}}, "the first time is negative: -1 s"},
      {{Path{{0, 1, 1}, {{}, {}, {}}, Path::Between::cubic}},
       "point 3: the times must ascend, but 1 s follows 1 s"},
      {{Path{{0, not_a_number}, {{}, {}}, Path::Between::linear}},
       "point 2: the time is not a finite number"},
      {{Stroke{0.0, {1, 0, 0}, 1.0, 1.0, 1, 0.0}}, "the distance must be above 0, but is 0 m"},
      {{Stroke{1.0, {1, 0, 0}, 0.0, 1.0, 1, 0.0}}, "the speed must be above 0, but is 0 m/s"},
      {{Stroke{1.0, {1, 0, 0}, 1.0, -1.0, 1, 0.0}}, "the acceleration must be above 0, but is -1 m/s^2"},
      {{Stroke{1.0, {1, 0, 0}, 1.0, 1.0, 0, 0.0}}, "the passes must be at least 1, but are 0"},
      {{Stroke{1.0, {1, 0, 0}, 1.0, 1.0, 1, -1.0}}, "the pause must not be negative, but is -1 s"},
  };
  for (const auto& [motion, words] : wrong) EXPECT_EQ(fault(motion), words);
}

TEST(Motion, KnowsItsCycle) {
  const auto sines = [](std::initializer_list<double> frequencies) {
    Sines m;
    for (const double f : frequencies) m.waves.push_back({1e-3, f, 0.0});
    return Motion{m};
  };
  EXPECT_EQ(cycle({Translation{}}), std::nullopt);
  EXPECT_EQ(cycle({Rotation{{}, {0, 0, 1}, -0.5, 1.0}}), 2.0);
  EXPECT_EQ(cycle({Rotation{}}), std::nullopt);
  EXPECT_EQ(cycle({Sine{{1e-3, 50.0, 0.0}, {0, 0, 1}}}), 0.02);
  EXPECT_EQ(cycle({Swing{{1e-3, 50.0, 0.0}, {}, {0, 0, 1}}}), 0.02);
  EXPECT_EQ(cycle({SquareWave{1e-3, 50.0, {0, 0, 1}, {}, 0.13}}), 0.02);
  EXPECT_NEAR(*cycle(sines({60.0, 20.0, 40.0})), 0.05, 1e-17);
  EXPECT_NEAR(*cycle(sines({20.0, 30.0})), 0.1, 1e-16);
  EXPECT_NEAR(*cycle(sines({9.9, 10.0})), 10.0, 1e-13);
  EXPECT_EQ(cycle(sines({10.0, 10.0 * std::sqrt(2.0)})), std::nullopt);
}

TEST(Motion, KnowsWhenItHasEnded) {
  const Sine sine{{1e-3, 50.0, 0.0}, {0, 0, 1}};
  const Stroke stroke{1.0, {1, 0, 0}, 0.5, 1.0, 2, 0.25};  // 2.5 s a pass
  EXPECT_EQ(duration({sine}), std::nullopt);
  EXPECT_EQ(duration({sine, 1.0, 3.0}), 3.0);
  EXPECT_EQ(duration({stroke}), 5.25);
  EXPECT_EQ(duration({stroke, 1.0}), 6.25);
  EXPECT_EQ(duration({stroke, 1.0, 3.0}), 3.0);
  EXPECT_EQ(duration({stroke, 1.0, 10.0}), 6.25);
}

}  // namespace
