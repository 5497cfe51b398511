// SPDX-License-Identifier: Apache-2.0
// Ctrl-C while a run goes on.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

/// Hours of work, were it not stopped.
const std::string endless = with(small_die, "duration = \"0.01 s\"", "duration = \"1000 s\"");

/// Waits until the run has written that many lines of its log.
bool has_logged(const std::string& out, std::size_t lines) {
  for (int look = 0; look < 6000; ++look) {
    if (fs::exists(out + "/log.csv") && lines_of(text_of(out + "/log.csv")).size() >= lines) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

TEST(CtrlC, EndsWithinSecondsWithValidResults) {
  TemporaryFolder folder;
  const std::string out = folder / "out";
  Process run({"run", folder.file("case.toml", endless), "--out", out, "--threads", "1", "--set",
               "output.log_interval=\"0.5 ms\"", "--set", "output.interval=\"5 ms\""});
  ASSERT_TRUE(has_logged(out, 50));
  run.signal(SIGINT);
  const auto outcome = run.wait(10.0);
  ASSERT_TRUE(outcome) << "still running";
  EXPECT_EQ(outcome->exit, 130) << outcome->err;
  EXPECT_TRUE(has(outcome->out, "result.json")) << "the results are pointed to";
  const Json r = json_of(out + "/result.json");
  EXPECT_EQ(r.at("exit"), 130);
  EXPECT_TRUE(has(r.at("exit_reason"), "stopped on request"));
  EXPECT_EQ(r.at("ledger").at("inserted"), r.at("ledger").at("present"));
  EXPECT_EQ(r.at("phases").back().at("ended_by"), "stopped on request");
  EXPECT_EQ(r.at("phases").back().at("end_s"), r.at("simulated_time_s"));
  EXPECT_TRUE(r.at("measures").contains("porosity_mean"));
  const Json parcels = open_series(out + "/parcels.pvd");
  EXPECT_GT(parcels.size(), 2u);
  EXPECT_EQ(parcels.back().at("time"), r.at("simulated_time_s")) << "the last frame is where it stopped";
  EXPECT_EQ(parcels.back().at("points"), r.at("particles"));
  EXPECT_TRUE(vtk_reads_all_of(out));
  const auto lines = lines_of(text_of(out + "/log.csv"));
  EXPECT_EQ(std::count(lines.back().begin(), lines.back().end(), ','), 11);
}

TEST(CtrlC, AtOnceStillEndsValid) {
  TemporaryFolder folder;
  const std::string out = folder / "out";
  Process run({"run", folder.file("case.toml", endless), "--out", out, "--threads", "1"});
  ASSERT_TRUE(has_logged(out, 1));
  run.signal(SIGINT);
  const auto outcome = run.wait(10.0);
  ASSERT_TRUE(outcome) << "still running";
  EXPECT_EQ(outcome->exit, 130) << outcome->err;
  EXPECT_EQ(json_of(out + "/result.json").at("exit"), 130);
}

TEST(TwoRuns, NeverShareAFolder) {
  TemporaryFolder folder;
  const std::string out = folder / "out", file = folder.file("case.toml", endless);
  Process first({"run", file, "--out", out, "--threads", "1"});
  ASSERT_TRUE(has_logged(out, 2));
  const Outcome second = call({"run", file, "--out", out, "--force", "--threads", "1"});
  EXPECT_EQ(second.exit, 2) << second.err;
  EXPECT_TRUE(has(second.err, "another run is writing")) << second.err;
  first.signal(SIGINT);
  const auto outcome = first.wait(10.0);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->exit, 130) << "the first did not notice";
}

}  // namespace
