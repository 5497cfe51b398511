// SPDX-License-Identifier: Apache-2.0
// What a run gives must not depend on how it is run.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

Json result_of(const std::string& text, const std::vector<std::string>& options,
               const Surroundings& where = {}) {
  const RunOfCase run(text, options, where);
  EXPECT_EQ(run.exit(), 0) << run.outcome().err;
  return run.result();
}

const Json& plain() {
  static const Json result = result_of(small_die, {"--threads", "1"});
  return result;
}

void expect_same(const Json& other, const std::string& how) {
  for (const char* key : {"state_hash", "steps", "ledger", "ledger_mass", "measures", "phases"})
    EXPECT_EQ(other.at(key), plain().at(key)) << key << " " << how;
}

TEST(SameBits, ComeOutOfASecondRun) { expect_same(result_of(small_die, {"--threads", "1"}), "again"); }

/// Enough parcels that two threads really share them, falling onto the floor and each other for a moment.
std::string crowd() {
  std::string text = thrown(R"(["0.4 m/s", "0.1 m/s", "-2 m/s"])", 11000);
  text = with(text, R"(max = ["4 mm", "4 mm", "12 mm"])", R"(max = ["20 mm", "20 mm", "20 mm"])");
  text = with(text, R"(max = ["3 mm", "3 mm", "4 mm"])", R"(max = ["15 mm", "15 mm", "14 mm"])");
  text = with(text, R"(min = ["0.5 mm", "0.5 mm", "1 mm"])", R"(min = ["0 mm", "0 mm", "0 mm"])");
  text = with(text, R"(max = ["2.5 mm", "2.5 mm", "3 mm"])", R"(max = ["15 mm", "15 mm", "12 mm"])");
  return with(text, "20 ms", "1 ms");
}

TEST(SameBits, ComeOutOfTwoThreads) {
  const Json one = result_of(crowd(), {"--threads", "1"}), two = result_of(crowd(), {"--threads", "2"});
  EXPECT_EQ(one.at("threads"), 1);
  EXPECT_EQ(two.at("threads"), 2);
  EXPECT_EQ(two.at("threads_used"), 2);
  EXPECT_GT(one.at("measures").at("coordination_mean").at("value"), 0.2) << "they touch each other";
  EXPECT_GT(one.at("measures").at("coordination_walls_mean").at("value"), 0.05) << "and the die";
  for (const char* key : {"state_hash", "steps", "ledger", "ledger_mass", "measures", "phases"})
    EXPECT_EQ(one.at(key), two.at(key)) << key;
}

TEST(SameBits, ComeOutOfEveryInstructionSet) {
  const std::string best = plain().at("instruction_set");
  for (const std::string set : {"baseline", "avx2", "avx512"}) {
    const Json result =
        result_of(small_die, {"--threads", "1"}, {.environment = {{"PULVIS_INSTRUCTION_SET", set}}});
    // A processor without the set takes the best it has.
    if (best == "avx512" || set == best || set == "baseline") {
      EXPECT_EQ(result.at("instruction_set"), set);
    }
    expect_same(result, "with " + set);
  }
}

TEST(SameBits, ComeOutOfFrequentAndOfNoOutput) {
  const Json often = result_of(small_die, {"--threads", "1", "--set", "output.interval=\"2 ms\"", "--set",
                                           "output.log_interval=\"0.1 ms\""});
  EXPECT_EQ(often.at("state_hash"), plain().at("state_hash"));
  expect_same(often, "with frequent output");
  expect_same(result_of(small_die, {"--threads", "1", "--set", "output.interval=\"0 s\""}), "without frames");
}

TEST(SameBits, DoNotComeOutOfAnotherSeed) {
  const Json other = result_of(small_die, {"--threads", "1", "--set", "seed=4"});
  EXPECT_NE(other.at("state_hash"), plain().at("state_hash"));
}

}  // namespace
