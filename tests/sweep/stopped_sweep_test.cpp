// SPDX-License-Identifier: Apache-2.0
// Sweeps that are stopped or killed while their runs go on, and what they leave in the list of processes.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

/// Three runs of some seconds, two at once.
struct Place {
  TemporaryFolder folder;
  std::string file =
      folder.file("die.toml", with(with(small_die, "duration = \"0.01 s\"", "duration = \"0.2 s\""),
                                   "picture = false", "picture = false\ncheckpoint_interval = \"50 ms\""));
  std::string out = folder / "sweep";
  std::vector<std::string> command{"sweep", file,        "--seeds", "3",     "--jobs",
                                   "2",     "--threads", "1",       "--out", out};

  std::string in(const std::string& name) const { return out + "/" + name; }

  /// Waits until the first two runs have a checkpoint in their first phases.
  bool both_run() const {
    for (int look = 0; look < 6000; ++look) {
      int running = 0;
      for (const char* run : {"die-seed-1", "die-seed-2"}) {
        const std::string log = in(run) + "/log.csv";
        running += fs::exists(log) && lines_of(text_of(log)).size() > 20;
      }
      if (running == 2) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }
};

/// A process as /proc has it.
struct Listed {
  int id = 0, parent = 0;
  char state = '?';
  std::string command;
};

std::vector<Listed> processes() {
  std::vector<Listed> list;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    Listed p;
    p.id = std::atoi(entry.path().filename().c_str());
    std::ifstream stat(entry.path() / "stat"), words(entry.path() / "cmdline");
    std::string text;
    if (p.id <= 0 || !std::getline(stat, text)) continue;
    // "12 (name) S 1": the name may hold anything.
    const auto end = text.rfind(')');
    if (end == std::string::npos || std::sscanf(text.c_str() + end + 1, " %c %d", &p.state, &p.parent) != 2)
      continue;
    std::getline(words, p.command);
    list.push_back(p);
  }
  return list;
}

/// Processes other than the sweep itself that work in a folder.
std::vector<Listed> runs_in(const std::string& folder) {
  std::vector<Listed> list;
  for (const Listed& p : processes())
    if (has(p.command, folder) && has(p.command, std::string("run\0", 4))) list.push_back(p);
  return list;
}

void expect_as_undisturbed(const Place& place) {
  for (const char* seed : {"1", "2", "3"}) {
    const std::string straight = place.folder / ("straight-" + std::string(seed));
    ASSERT_EQ(
        call({"run", place.file, "--out", straight, "--threads", "1", "--set", std::string("seed=") + seed})
            .exit,
        0);
    const std::string run = place.in(std::string("die-seed-") + seed);
    EXPECT_EQ(json_of(run + "/result.json")["state_hash"], json_of(straight + "/result.json")["state_hash"]);
    EXPECT_EQ(text_of(run + "/log.csv"), text_of(straight + "/log.csv"));
  }
}

TEST(StoppedSweep, LeavesCheckpointsAndGoesOnToTheSameResults) {
  for (const int signal : {SIGTERM, SIGINT}) {
    const Place place;
    Process sweep(place.command);
    ASSERT_TRUE(place.both_run());
    sweep.signal(signal);
    const auto stopped = sweep.wait(20.0);
    ASSERT_TRUE(stopped) << "still running";
    EXPECT_EQ(stopped->exit, signal == SIGINT ? 130 : 75) << stopped->err;
    EXPECT_TRUE(has(stopped->err, "3 runs are not complete; the same command goes on")) << stopped->err;
    EXPECT_TRUE(runs_in(place.out).empty());
    for (const char* run : {"die-seed-1", "die-seed-2"})
      EXPECT_EQ(json_of(place.in(run) + "/result.json").at("exit"), 75) << run;
    EXPECT_FALSE(fs::exists(place.in("die-seed-3"))) << "no more are started";
    EXPECT_TRUE(has(text_of(place.in("sweep.csv")), "not started"));

    const Outcome on = call(place.command);
    ASSERT_EQ(on.exit, 0) << on.err;
    EXPECT_EQ(json_of(place.in("die-seed-1/result.json")).at("resumes"), 1);
    if (signal == SIGTERM) expect_as_undisturbed(place);
  }
}

TEST(KilledSweep, TakesItsRunsWithItAndGoesOnToTheSameResults) {
  const Place place;
  {
    Process sweep(place.command);
    ASSERT_TRUE(place.both_run());
    EXPECT_EQ(runs_in(place.out).size(), 2u);
    sweep.signal(SIGKILL);
    ASSERT_TRUE(sweep.wait(10.0));
  }
  // At once: the runs are still writing their checkpoints, or not.
  const Outcome on = call(place.command);
  ASSERT_EQ(on.exit, 0) << on.err;
  expect_as_undisturbed(place);
  EXPECT_TRUE(runs_in(place.out).empty());
}

TEST(KilledSweep, LeavesNoRunBehind) {
  const Place place;
  auto endless = place.command;
  endless.insert(endless.end(), {"--set", "phases.measure.duration=\"1000 s\""});
  Process sweep(endless);
  ASSERT_TRUE(place.both_run());
  sweep.signal(SIGKILL);
  ASSERT_TRUE(sweep.wait(10.0));
  for (int look = 0; look < 400 && !runs_in(place.out).empty(); ++look)
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  EXPECT_TRUE(runs_in(place.out).empty());
}

TEST(RunningSweep, LeavesNoZombieOfWhatHasEndedAndIsHeldAgainstAnother) {
  const Place place;
  auto mixed = place.command;
  mixed.insert(mixed.end(), {"--vary", "phases.measure.duration=\"0.1 ms\",\"1000 s\"", "--jobs", "3"});
  mixed.erase(std::find(mixed.begin(), mixed.end(), "--jobs"),
              std::find(mixed.begin(), mixed.end(), "--threads"));
  Process sweep(mixed);
  const std::string quick = place.in("die-duration-0.1-ms-seed-1/result.json");
  for (int look = 0; look < 4000; ++look) {
    if (fs::exists(quick) && json_of(quick).at("exit") == 0) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_EQ(json_of(quick).at("exit"), 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  int children = 0;
  for (const Listed& p : processes()) {
    if (p.parent != sweep.id()) continue;
    EXPECT_NE(p.state, 'Z') << p.id;
    ++children;
  }
  EXPECT_GT(children, 0) << "those of the long phase";
  const Outcome second = call(mixed);
  EXPECT_EQ(second.exit, 2);
  EXPECT_TRUE(has(second.err, "another run is writing to")) << second.err;
  sweep.signal(SIGTERM);
  EXPECT_TRUE(sweep.wait(20.0));
}

TEST(RunningSweep, NamesARunThatASignalEnds) {
  const Place place;
  Process sweep(place.command);
  ASSERT_TRUE(place.both_run());
  for (const Listed& p : runs_in(place.out))
    if (has(p.command, "die-seed-1")) ::kill(p.id, SIGKILL);
  const auto ended = sweep.wait(60.0);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->exit, 1) << ended->err;
  EXPECT_TRUE(has(ended->err, "die-seed-1 failed with exit code 137: ended by signal 9")) << ended->err;
  EXPECT_TRUE(has(ended->err, "2 of 3 runs complete, 1 failed")) << ended->err;
  EXPECT_EQ(call(place.command).exit, 0) << "and goes on with it";
}

}  // namespace
