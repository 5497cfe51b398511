// SPDX-License-Identifier: Apache-2.0
#include "output/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace pulvis {
namespace {

// A progress display whose clock the test moves.
struct Display {
  explicit Display(ProgressOptions options) : progress(stream, options, [this] { return now; }) {}
  std::string take() {
    std::string text = stream.str();
    stream.str("");
    return text;
  }
  std::ostringstream stream;
  double now = 1000.0;
  Progress progress;
};

ProgressState state_at(double fraction, std::uint64_t steps) {
  ProgressState state;
  state.phase = "shake";
  state.simulated_time = 0.25;
  state.fraction = fraction;
  state.parcels = 5000;
  state.particle_steps = steps;
  return state;
}

TEST(Progress, WritesAPlainLineEveryThirtySecondsAndWithEachPhase) {
  Display display({ProgressStyle::lines, false, 80});
  display.progress.update(state_at(0.0, 0));
  EXPECT_EQ(display.take(), "shake 0.0 % | t = 0.25 s | 5000 parcels\n");
  display.now += 29.9;
  display.progress.update(state_at(0.1, 10));
  EXPECT_EQ(display.take(), "");
  display.now += 0.1;
  display.progress.update(state_at(0.1, 10));
  const auto line = display.take();
  EXPECT_TRUE(line.starts_with("shake 10.0 % |")) << line;
  EXPECT_EQ(std::ranges::count(line, '\n'), 1);
  auto settle = state_at(0.0, 20);
  settle.phase = "settle";
  display.now += 0.01;
  display.progress.update(settle);
  EXPECT_TRUE(display.take().starts_with("settle 0.0 %"));
}

TEST(Progress, PredictsTheRemainingTimeFromASteadyRate) {
  Display display({ProgressStyle::lines, false, 80});
  // 1 % and two million particle-steps each second.
  for (int second = 0; second <= 30; ++second) {
    display.progress.update(state_at(0.01 * second, 2'000'000u * static_cast<std::uint64_t>(second)));
    if (second < 30) display.take();
    display.now += 1.0;
  }
  EXPECT_EQ(display.take(),
            "shake 30.0 % | t = 0.25 s | 5000 parcels | 2.00 M particle-steps/s | 1 min 10 s left\n");
}

TEST(Progress, ForgetsAnOldRate) {
  Display display({ProgressStyle::lines, false, 80});
  double fraction = 0.0;
  std::string last;
  for (int second = 0; second <= 150; ++second) {
    display.progress.update(state_at(fraction, 0));
    if (const auto text = display.take(); !text.empty()) last = text;
    fraction += second < 30 ? 0.01 : 0.001;  // ten times slower after half a minute
    display.now += 1.0;
  }
  // 0.42 is done; at 0.1 % a second 580 s remain. The fast start, 8 memory times ago, weighs exp(-8) x 9.
  EXPECT_NE(last.find(" 9 min "), std::string::npos) << last;
}

TEST(Progress, StartsTheEstimateOverWhenTheFractionDoes) {
  Display display({ProgressStyle::lines, false, 80});
  display.progress.update(state_at(0.0, 0));
  display.now += 10.0;
  display.progress.update(state_at(0.9, 0));
  display.now += 20.0;
  display.take();
  display.progress.update(state_at(0.0, 0));
  EXPECT_EQ(display.take().find("left"), std::string::npos);
}

TEST(Progress, ForeseesNothingFromAFractionThatStandsStill) {
  Display display({ProgressStyle::lines, false, 80});
  std::string last;
  for (int second = 0; second <= 90; ++second) {
    display.progress.update(state_at(0.01 * std::min(second, 30), 0));
    if (const auto text = display.take(); !text.empty()) last = text;
    display.now += 1.0;
  }
  EXPECT_TRUE(last.starts_with("shake 30.0 %")) << last;
  EXPECT_EQ(last.find("left"), std::string::npos) << last;
}

TEST(Progress, LeavesOutWhatCannotBeForeseen) {
  Display display({ProgressStyle::lines, false, 80});
  auto state = state_at(0.0, 0);
  state.fraction.reset();
  display.progress.update(state);
  EXPECT_EQ(display.take(), "shake | t = 0.25 s | 5000 parcels\n");
}

TEST(Progress, RedrawsTheBarAtMostEveryFifthOfASecond) {
  Display display({ProgressStyle::bar, false, 80});
  display.progress.update(state_at(0.5, 0));
  const auto bar = display.take();
  EXPECT_EQ(bar, "\rshake [############------------]  50 % | t = 0.25 s | 5000 parcels\x1b[K");
  display.now += 0.19;
  display.progress.update(state_at(0.51, 0));
  EXPECT_EQ(display.take(), "");
  display.now += 0.02;
  display.progress.update(state_at(0.52, 0));
  EXPECT_NE(display.take().find("52 %"), std::string::npos);
}

TEST(Progress, NeverFillsTheTerminalsLastColumn) {
  for (const int width : {1, 10, 20, 40, 60, 100}) {
    Display display({ProgressStyle::bar, false, width});
    auto state = state_at(0.5, 0);
    state.phase = "Schütteln";
    display.progress.update(state);
    auto bar = display.take();
    ASSERT_TRUE(bar.starts_with("\r") && bar.ends_with("\x1b[K"));
    bar = bar.substr(1, bar.size() - 4);
    const auto columns = std::ranges::count_if(bar, [](char letter) { return (letter & 0xC0) != 0x80; });
    EXPECT_LE(columns, std::max(1, width - 1)) << bar;
  }
}

TEST(Progress, IsColouredOnlyWhereAsked) {
  for (const bool colour : {false, true}) {
    Display display({ProgressStyle::bar, colour, 80});
    display.progress.update(state_at(0.5, 0));
    EXPECT_EQ(display.take().find("\x1b[32m") != std::string::npos, colour);
  }
}

TEST(Progress, PutsMessagesOnLinesOfTheirOwn) {
  Display display({ProgressStyle::bar, false, 80});
  display.progress.update(state_at(0.5, 0));
  display.take();
  display.progress.message("warning: 3 % overlap");
  EXPECT_EQ(display.take(), "\r\x1b[Kwarning: 3 % overlap\n");
  display.now += 1.0;
  display.progress.update(state_at(1.0, 0));
  display.take();
  display.progress.finish();
  EXPECT_TRUE(display.take().ends_with("\n"));
}

TEST(Progress, IsSilentWhenQuiet) {
  Display display({ProgressStyle::quiet, false, 80});
  display.progress.update(state_at(0.5, 0));
  display.progress.finish();
  EXPECT_EQ(display.take(), "");
}

TEST(Progress, TakesPlainLinesWhereTheTerminalCannotRedraw) {
  ::setenv("TERM", "dumb", 1);
  EXPECT_EQ(ProgressOptions::for_stderr().style, ProgressStyle::lines);
}

TEST(Progress, WritesDurationsForPeople) {
  EXPECT_EQ(duration_text(0.0), "0 s");
  EXPECT_EQ(duration_text(59.2), "1 min 00 s");
  EXPECT_EQ(duration_text(185.0), "3 min 05 s");
  EXPECT_EQ(duration_text(8040.0), "2 h 14 min");
  EXPECT_EQ(duration_text(273600.0), "3 d 4 h");
}

TEST(Progress, WritesCountsInThreeDigits) {
  EXPECT_EQ(count_text(0.0), "0");
  EXPECT_EQ(count_text(950.0), "950");
  EXPECT_EQ(count_text(999.6), "1.00 k");
  EXPECT_EQ(count_text(12345.0), "12.3 k");
  EXPECT_EQ(count_text(4.56e6), "4.56 M");
  EXPECT_EQ(count_text(789e9), "789 G");
}

}  // namespace
}  // namespace pulvis
