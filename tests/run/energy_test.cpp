// SPDX-License-Identifier: Apache-2.0
// The ledger of energy as a user sees it.
#include <gtest/gtest.h>

#include "run/energy_lines.hpp"
#include "run/run_summary.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

const std::string die = with(small_die, "[output]", "[measures]\nenergy_ledger = true\n\n[output]");

const RunOfCase& accounted() {
  static const RunOfCase run(die);
  EXPECT_EQ(run.exit(), 0) << run.outcome().err;
  return run;
}

TEST(EnergyOfARun, IsInTheResultAndCloses) {
  const Json energy = accounted().result().at("energy");
  EXPECT_GT(accounted().result().at("time_table_s").at("energy_ledger").get<double>(), 0.0);
  const auto of = [&](const std::string& line) { return energy.at(line + "_J").get<double>(); };
  double now = 0.0, lost = 0.0, brought_in = 0.0;
  for (const char* line : {"translational", "rotational", "potential", "elastic", "cohesive",
                           "sliding_springs", "rolling_springs", "twisting_springs"})
    now += of(line);
  for (const char* line : {"normal_dashpots", "tangential_dashpots", "sliding_friction", "rolling_friction",
                           "rolling_dashpots", "twisting_friction", "twisting_dashpots", "viscous_friction",
                           "liquid", "touch", "separation", "forgotten_springs"})
    lost += of(line);
  for (const char* line : {"walls", "sliding_stiffness", "rolling_stiffness", "changed_contacts"})
    brought_in += of(line);
  EXPECT_NEAR(lost, of("lost"), 1e-12 * lost);
  EXPECT_NEAR(of("closing_error"), now + of("removed") + lost - of("start") - of("inserted") - brought_in,
              1e-9 * of("put_through"));
  EXPECT_GT(of("walls"), 0.0);
  EXPECT_GT(of("touch"), 0.0);
  EXPECT_LT(std::abs(energy.at("closing_share").get<double>()), 0.01);
}

TEST(EnergyOfARun, IsPrintedAndLoggedAndChangesNothingElse) {
  EXPECT_TRUE(has(accounted().outcome().out, "put through, closing error"));
  EXPECT_TRUE(has(accounted().outcome().out, "adhesion, at touch"));
  const auto lines = lines_of(text_of(accounted().out("log.csv")));
  EXPECT_TRUE(lines.front().ends_with(
      ",potential_energy_J,stored_energy_J,lost_energy_J,brought_in_energy_J,energy_closing_error_J"));
  const RunOfCase plain(small_die);
  EXPECT_EQ(plain.result().at("state_hash"), accounted().result().at("state_hash"));
  EXPECT_FALSE(plain.result().contains("energy"));
}

TEST(EnergyOfARun, IsOnThePageOfTheRun) {
  const RunOfCase& run = accounted();
  ASSERT_EQ(call({"report", run.out()}).exit, 0);
  EXPECT_TRUE(has(text_of(run.out("report.html")), "ledger of energy"));
}

TEST(EnergyOfARun, IsWarnedOfWhereMoreThanAHundredthIsUnaccountedFor) {
  // A run at a step that the program accepts closes better than that, so the balance is made up.
  pulvis::EnergyBalance balance;
  balance.start = 1.0;
  pulvis::RunSummary summary;
  balance.translational = 1.009;  // J more than there were
  pulvis::warn_of_energy(balance, summary);
  EXPECT_TRUE(summary.warnings.empty());
  balance.translational = 1.011;
  pulvis::warn_of_energy(balance, summary);
  ASSERT_EQ(summary.warnings.size(), 1u);
  EXPECT_TRUE(has(summary.warnings.front(), "the ledger of energy does not close"));
}

TEST(EnergyOfARun, IsTheSameForTwoThreadsAndEveryInstructionSet) {
  std::string text = with(thrown(R"(["0.4 m/s", "0.1 m/s", "-2 m/s"])", 11000), "[output]",
                          "[measures]\nenergy_ledger = true\n\n[output]");
  text = with(text, R"(max = ["4 mm", "4 mm", "12 mm"])", R"(max = ["20 mm", "20 mm", "20 mm"])");
  text = with(text, R"(max = ["3 mm", "3 mm", "4 mm"])", R"(max = ["15 mm", "15 mm", "14 mm"])");
  text = with(text, R"(min = ["0.5 mm", "0.5 mm", "1 mm"])", R"(min = ["0 mm", "0 mm", "0 mm"])");
  text = with(text, R"(max = ["2.5 mm", "2.5 mm", "3 mm"])", R"(max = ["15 mm", "15 mm", "12 mm"])");
  text = with(text, "20 ms", "1 ms");
  const Json one = RunOfCase(text, {"--threads", "1"}).result(),
             two = RunOfCase(text, {"--threads", "2"}).result();
  EXPECT_EQ(two.at("threads_used"), 2);
  EXPECT_EQ(one.at("energy"), two.at("energy"));
  const RunOfCase baseline(text, {"--threads", "1"},
                           {.environment = {{"PULVIS_INSTRUCTION_SET", "baseline"}}});
  EXPECT_EQ(one.at("energy"), baseline.result().at("energy"));
}

}  // namespace
