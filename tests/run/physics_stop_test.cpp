// SPDX-License-Identifier: Apache-2.0
// Runs that cannot go on: each stops with exit 5, says which parcel, where and when, and keeps what it has.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_TRUE(has(text, part)) << "no \"" << part << "\" in\n" << text;
}

/// Stopped by physics, with valid results up to then.
Json expect_stopped(const RunOfCase& run) {
  EXPECT_EQ(run.exit(), 5) << run.outcome().err;
  const Json r = run.result();
  EXPECT_EQ(r.at("exit"), 5);
  const std::string reason = r.at("exit_reason");
  EXPECT_TRUE(has(run.outcome().err, reason)) << "stderr says the same";
  const Json& l = r.at("ledger");
  EXPECT_EQ(l.at("inserted").get<int>(),
            l.at("present").get<int>() + l.at("removed").get<int>() + l.at("escaped").get<int>());
  EXPECT_TRUE(r.at("measures").is_object());
  EXPECT_TRUE(vtk_reads_all_of(run.out()));
  EXPECT_GE(lines_of(text_of(run.out("log.csv"))).size(), 2u);
  return r;
}

const char* const upwards = R"(["0 m/s", "0 m/s", "3 m/s"])";

TEST(EscapeFromTheDomain, StopsTheRunWithIdTimePlaceAndSpeed) {
  const Json r = expect_stopped(RunOfCase(thrown(upwards)));
  const Json& escapes = r.at("escapes");
  ASSERT_EQ(escapes.size(), 1u) << "the first is enough";
  const Json& e = escapes[0];
  EXPECT_EQ(e.at("through"), "domain");
  EXPECT_LT(e.at("id").get<int>(), 5);
  EXPECT_GT(e.at("position_m")[2].get<double>(), 12e-3);
  EXPECT_LT(e.at("position_m")[2].get<double>(), 12.1e-3);
  // It began 1 to 3 mm high, so that it flew 9 to 11 mm.
  EXPECT_GT(e.at("time_s").get<double>(), 9e-3 / 3.0);
  EXPECT_LT(e.at("time_s").get<double>(), 11.1e-3 / 2.95);
  const double fallen = 9.81 * e.at("time_s").get<double>();
  EXPECT_NEAR(e.at("speed_m_s").get<double>(), 3.0 - fallen, 1e-4);
  expect_in(r.at("exit_reason"),
            {"parcel " + std::to_string(e.at("id").get<int>()), "escaped through domain",
             fmt::format("t = {:.6g} s", e.at("time_s").get<double>()),
             fmt::format("{:.5g}) m", e.at("position_m")[2].get<double>()),
             fmt::format("speed {:.4g} m/s", e.at("speed_m_s").get<double>()), "domain.escape"});
  EXPECT_EQ(r.at("ledger").at("escaped"), 1);
}

TEST(EscapeFromTheDomain, IsCountedIfTheCaseAllowsIt) {
  const RunOfCase run(thrown(upwards), {"--threads", "1", "--set", "domain.escape=\"count\""});
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json r = run.result();
  EXPECT_EQ(r.at("ledger"), (Json{{"inserted", 5}, {"present", 0}, {"removed", 0}, {"escaped", 5}}));
  EXPECT_NEAR(r.at("ledger_mass").at("escaped").get<double>(),
              r.at("ledger_mass").at("inserted").get<double>(), 1e-18);
  std::set<int> ids;
  for (const Json& e : r.at("escapes")) {
    ids.insert(e.at("id").get<int>());
    EXPECT_EQ(e.at("through"), "domain");
    EXPECT_GT(e.at("time_s"), 0.0);
    EXPECT_GT(e.at("speed_m_s"), 2.9);
  }
  EXPECT_EQ(ids, (std::set<int>{0, 1, 2, 3, 4}));
  const auto lines = lines_of(text_of(run.out("log.csv")));
  EXPECT_EQ(lines.back().substr(lines.back().rfind(',')), ",5");
  EXPECT_TRUE(has(run.outcome().out, "5 inserted = 0 present + 0 removed + 5 escaped"));
  ASSERT_FALSE(r.at("warnings").empty());
  const Json& first = r.at("escapes")[0];
  expect_in(r.at("warnings").back(),
            {"5 parcels (", "ug) escaped", "first was parcel " + std::to_string(first.at("id").get<int>()),
             "through domain", fmt::format("t = {:.6g} s", first.at("time_s").get<double>()),
             fmt::format("speed {:.4g} m/s", first.at("speed_m_s").get<double>())});
}

/// Too fast for walls so soft.
std::string shot() {
  std::string text = thrown(R"(["30 m/s", "0 m/s", "0 m/s"])", 1);
  return with(with(text, "\"2 MPa\"", "\"0.1 MPa\""), "fraction = 1.0", "fraction = 0.2");
}

TEST(EscapeThroughAWall, StopsTheRunAndNamesTheWall) {
  const Json r = expect_stopped(RunOfCase(shot()));
  ASSERT_EQ(r.at("escapes").size(), 1u);
  EXPECT_EQ(r.at("escapes")[0].at("through"), "die.+x");
  EXPECT_NEAR(r.at("escapes")[0].at("position_m")[0].get<double>(), 3e-3, 0.2e-3);
  expect_in(r.at("exit_reason"), {"parcel 0", "through die.+x", "t = ", "speed"});
}

TEST(EscapeThroughAWall, IsCountedIfTheCaseAllowsIt) {
  const RunOfCase run(shot(), {"--threads", "1", "--set", "domain.escape=\"count\""});
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  EXPECT_EQ(run.result().at("ledger").at("escaped"), 1);
  EXPECT_EQ(run.result().at("escapes")[0].at("through"), "die.+x");
}

TEST(LimitOfAPhase, IsAnErrorWhereTheCaseSaysSo) {
  const RunOfCase run(small_die, {"--threads", "1", "--set", "phases.fill.time_limit=\"10 ms\"", "--set",
                                  "phases.fill.at_limit=\"error\""});
  const Json r = expect_stopped(run);
  expect_in(r.at("exit_reason"), {"phase fill", "time limit", "0.01 s", "at_limit"});
  EXPECT_NEAR(r.at("simulated_time_s").get<double>(), 0.01, 5e-6);
}

TEST(LimitOfAPhase, EndsItOtherwiseAndTellsWhatIsMissing) {
  const RunOfCase run(small_die, {"--threads", "1", "--set", "phases.fill.time_limit=\"10 ms\""});
  ASSERT_EQ(run.exit(), 0) << run.outcome().err;
  const Json r = run.result();
  EXPECT_EQ(r.at("phases")[0].at("ended_by"), "time_limit");
  std::string all;  // a warning about something else may stand beside it
  for (const auto& warning : r.at("warnings")) all += warning.get<std::string>() + "\n";
  expect_in(all, {"source rain", "phase fill", "time_limit"});
  expect_in(run.outcome().err, {"warning: source rain"});
}

/// A bed from a dump with one parcel that has this velocity along x.
RunOfCase run_with_speed(const std::string& speed) {
  static TemporaryFolder beds;
  const std::string dump =
      beds.file("bed.dump",
                "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                "ITEM: ATOMS id type x y z vx vy vz radius\n1 1 0.001 0.001 0.001 0 0 0 0.00025\n"
                "2 1 0.002 0.002 0.002 " +
                    speed + " 0 0 0.00025\n");
  return RunOfCase(die_with("[sources.bed]\nkind = \"file\"\npath = \"" + dump +
                            "\"\n\n[[phases]]\nname = \"fly\"\nsources = [\"bed\"]\nuntil = \"time\"\n"
                            "duration = \"1 ms\"\n\n"));
}

TEST(Runaway, NamesTheParcelThatMovesTooFarInAStep) {
  const Json r = expect_stopped(run_with_speed("100"));
  expect_in(r.at("exit_reason"),
            {"half its radius", "parcel 1", "t = ", "(0.00", "velocity (100", "time.fraction"});
  EXPECT_EQ(r.at("ledger").at("present"), 2);
}

TEST(Runaway, NamesTheParcelWhoseNumbersAreNone) {
  // Its square is no number any more.
  const Json r = expect_stopped(run_with_speed("1e200"));
  expect_in(r.at("exit_reason"), {"not a finite number", "parcel 1", "t = ", "1e+200"});
}

TEST(Runaway, IsSeenEvenIfTheLastStepMadeIt) {
  // Two parcels in one place have no direction to push each other; no further step would look at them.
  static TemporaryFolder beds;
  const std::string dump =
      beds.file("bed.dump",
                "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                "ITEM: ATOMS id x y z radius\n1 0.001 0.001 0.001 0.00025\n2 0.001 0.001 0.001 0.00025\n");
  const Json r = expect_stopped(
      RunOfCase(die_with("[sources.bed]\nkind = \"file\"\npath = \"" + dump +
                         "\"\n\n[[phases]]\nname = \"fly\"\nsources = [\"bed\"]\nuntil = \"time\"\n"
                         "duration = \"1 ns\"\n\n")));
  EXPECT_EQ(r.at("steps"), 1);
  EXPECT_TRUE(r.at("phases").empty()) << "nothing is measured on it";
  expect_in(r.at("exit_reason"), {"not a finite number", "parcel 0", "t = ", "velocity (", "time.fraction"});
}

}  // namespace
