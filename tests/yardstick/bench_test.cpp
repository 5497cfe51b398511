// SPDX-License-Identifier: Apache-2.0
// `pulvis bench` from its command line to its rows. How fast anything was is not judged.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include "tests/run/program.hpp"
#include "yardstick/bench.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

TEST(Bench, TimesEachSizeWithEachNumberOfThreads) {
  const TemporaryFolder folder;
  const std::string file = folder / "bench.json";
  const Outcome done =
      call({"bench", "--sizes", "4e3,1e3", "--threads", "1,2", "--steps", "20", "--json", file});
  ASSERT_EQ(done.exit, 0) << done.err;
  EXPECT_EQ(lines_of(done.out).size(), 1 + 4 + 1u) << done.out;
  EXPECT_TRUE(says(done.err, "hertz: a bed settles")) << "progress: " << done.err;
  const Json json = json_of(file), &rows = json.at("rows");
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_GT(json.at("peak_bytes"), 1e6);
  std::size_t k = 0;
  for (const std::size_t parcels : {1000u, 4000u})
    for (const int threads : {1, 2}) {
      const Json& row = rows[k++];
      EXPECT_EQ(row.at("law"), "hertz");
      EXPECT_EQ(row.at("parcels"), parcels) << "sizes ascend";
      EXPECT_EQ(row.at("threads"), threads);
      EXPECT_EQ(row.at("threads_used"), 1) << "a thread is worth waking for 5000 parcels";
      EXPECT_EQ(row.at("steps"), 20);
      EXPECT_EQ(row.at("speed_up_over_one_thread").is_null(), false);
      EXPECT_GT(row.at("seconds"), 0.0);
      // A bed that lies: each parcel bears some and is borne by some.
      EXPECT_GT(row.at("contacts_per_parcel"), 1.5);
      EXPECT_LT(row.at("contacts_per_parcel"), 4.0);
      EXPECT_GT(row.at("near_pairs_per_parcel"), row.at("contacts_per_parcel"));
      EXPECT_GT(row.at("bytes_per_parcel"), 200.0);
      EXPECT_GT(row.at("time_table_s").at("pairs"), 0.0);
    }
}

TEST(Bench, TimeOfOneThreadLeavesOutThoseThatSpin) {
  const auto of_program = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const double own_before = yardstick::seconds_of_this_thread(), all_before = of_program();
  std::atomic<bool> spin = true;
  std::thread other([&] {
    while (spin) {
    }
  });
  while (of_program() - all_before < 0.2) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  spin = false;
  other.join();
  EXPECT_LT(yardstick::seconds_of_this_thread() - own_before, 0.1);
}

TEST(Bench, CanHaveAnotherLawTheLedgerOfEnergyAndLookAtEachStep) {
  const TemporaryFolder folder;
  const std::string file = folder / "bench.json";
  const Outcome done = call({"bench", "--sizes", "1000", "--laws", "sjkr", "--threads", "1", "--steps", "20",
                             "--energy", "--look-every", "1", "--json", file});
  ASSERT_EQ(done.exit, 0) << done.err;
  const Json row = json_of(file).at("rows").at(0);
  EXPECT_EQ(row.at("law"), "sjkr");
  EXPECT_GT(row.at("time_table_s").at("energy_ledger"), 0.0);
  EXPECT_EQ(json_of(file).at("energy_ledger"), true);
  EXPECT_EQ(json_of(file).at("look_every"), 1);
}

TEST(Bench, RefusesWhatItCannotTime) {
  const auto refused = [](const std::vector<std::string>& options, const std::string& words) {
    std::vector<std::string> all{"bench"};
    all.insert(all.end(), options.begin(), options.end());
    const Outcome done = call(all);
    EXPECT_EQ(done.exit, 2) << done.out << done.err;
    EXPECT_TRUE(says(done.err, words)) << done.err;
    EXPECT_EQ(done.out, "");
  };
  refused({"--sizes", "10"}, "--sizes");
  refused({"--sizes", "many"}, "--sizes");
  refused({"--threads", "0"}, "--threads");
  refused({"--steps", "0"}, "--steps");
  refused({"--look-every", "-1"}, "--look-every");
  refused({"--laws", "hertz,putty"}, "there is no bed with the law \"putty\"; laws are:\n  hertz");
  refused({"--fast"}, "--fast");
  refused({"--sizes", "1e4,1e9"}, "998560000 parcels needs about 998560 MB of memory");
}

TEST(Bench, SaysBeforeItBeginsThatItsFileCannotBeWritten) {
  const TemporaryFolder folder;
  const Outcome done = call({"bench", "--sizes", "1000", "--json", folder / "nowhere/bench.json"});
  EXPECT_EQ(done.exit, 6) << done.err;
  EXPECT_EQ(done.out, "");
}

}  // namespace
