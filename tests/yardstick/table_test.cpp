// SPDX-License-Identifier: Apache-2.0
#include "yardstick/table.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace pulvis::yardstick {
namespace {

Row row(const char* law, std::size_t parcels, int threads, double seconds) {
  Row r;
  r.law = law;
  r.parcels = parcels;
  r.threads = r.threads_used = threads;
  r.steps = 10;
  r.seconds = seconds;
  r.contacts = 2 * parcels;
  r.near_pairs = 5 * parcels;
  r.rebuilds = 1;
  r.bytes = 600 * parcels;
  r.times.of[static_cast<std::size_t>(Task::pairs)] = 0.75 * seconds;
  r.times.of[static_cast<std::size_t>(Task::near_lists)] = 0.25 * seconds;
  return r;
}

const std::vector<Row> rows{row("hertz", 1000, 1, 0.002), row("hertz", 1000, 2, 0.001),
                            row("hertz", 4000, 1, 0.010), row("jkr", 4000, 1, 0.020),
                            row("jkr", 4000, 2, 0.016)};

TEST(BenchTable, GivesTimePerParticleStep) { EXPECT_DOUBLE_EQ(rows[0].per_particle_step(), 2e-7); }

TEST(BenchTable, SpeedUpIsOverOneThreadOfTheSameBed) {
  EXPECT_DOUBLE_EQ(*speed_up(rows, rows[1]), 2.0);
  EXPECT_DOUBLE_EQ(*speed_up(rows, rows[4]), 1.25);
  EXPECT_FALSE(speed_up({rows[1]}, rows[1])) << "one thread was not timed";
}

TEST(BenchTable, LargerBedsAreHeldAgainstTheSmallestOfTheSameLawAndThreads) {
  EXPECT_DOUBLE_EQ(over_smallest(rows, rows[2]), 1.25);
  EXPECT_DOUBLE_EQ(over_smallest(rows, rows[3]), 1.0) << "there is no smaller one";
}

TEST(BenchTable, HasALineForEachRowUnderItsHead) {
  EXPECT_EQ(table_head().size(), table_line(rows, rows[2]).size());
  const std::string line = table_line(rows, rows[1]);
  for (const char* cell :
       {"hertz", "1000", "100.0", "10.00", "2.00", "5.00", "0.1000", "600", "75.0", "25.0"})
    EXPECT_NE(line.find(cell), std::string::npos) << cell << " in " << line;
}

TEST(BenchTable, JsonHasTheSameInSi) {
  const auto json = to_json(rows);
  ASSERT_EQ(json.size(), rows.size());
  EXPECT_DOUBLE_EQ(json[1]["seconds_per_particle_step"].get<double>(), 1e-7);
  EXPECT_DOUBLE_EQ(json[1]["particle_steps_per_s"].get<double>(), 1e7);
  EXPECT_DOUBLE_EQ(json[1]["contacts_per_parcel"].get<double>(), 2.0);
  EXPECT_DOUBLE_EQ(json[1]["near_pairs_per_parcel"].get<double>(), 5.0);
  EXPECT_DOUBLE_EQ(json[1]["rebuilds_per_step"].get<double>(), 0.1);
  EXPECT_DOUBLE_EQ(json[1]["bytes_per_parcel"].get<double>(), 600.0);
  EXPECT_DOUBLE_EQ(json[1]["time_table_s"]["pairs"].get<double>(), 0.00075);
}

}  // namespace
}  // namespace pulvis::yardstick
