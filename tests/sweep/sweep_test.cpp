// SPDX-License-Identifier: Apache-2.0
// `pulvis sweep` from its command line to its tables.
#include <gtest/gtest.h>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

/// Five parcels thrown into the die, and a place for sweeps of them.
struct Place {
  TemporaryFolder folder;
  std::string file = folder.file("die.toml", thrown(R"(["0 m/s", "0 m/s", "0 m/s"])"));
  std::string out = folder / "sweep";

  Outcome sweep(std::vector<std::string> options, const std::string& folder_to_stand_in = "") const {
    options.insert(options.begin(), {"sweep", file, "--out", out});
    Surroundings surroundings;
    surroundings.folder = folder_to_stand_in;
    return call(options, surroundings);
  }
  std::string in(const std::string& name) const { return out + "/" + name; }
};

TEST(Sweep, LeavesWhatEachRunWouldLeaveByItselfAndATableOfAll) {
  const Place place;
  const Outcome swept = place.sweep({"--vary", "materials.glass.friction=0.2,0.6", "--seeds", "2", "--set",
                                     "phases.fly.duration=\"10 ms\""});
  ASSERT_EQ(swept.exit, 0) << swept.err;
  EXPECT_TRUE(has(swept.err, "4 of 4 runs complete")) << swept.err;
  EXPECT_TRUE(has(swept.out, place.in("comparison/comparison.html"))) << swept.out << swept.err;
  EXPECT_TRUE(has(text_of(place.in("comparison/comparison.html")), "die-friction-0.6-seed-2"));
  const auto lines = lines_of(text_of(place.in("sweep.csv")));
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_TRUE(lines[0].starts_with("run,case,materials.glass.friction,seed,state,parcels,wall_time_s,"))
      << lines[0];
  EXPECT_TRUE(has(lines[0], "fill_mass_kg"));
  EXPECT_TRUE(lines[4].starts_with("die-friction-0.6-seed-2," + place.file + ",0.6,2,complete,5,"))
      << lines[4];
  const auto record = json_of(place.in("sweep.json"));
  for (const auto& run : record.at("runs")) {
    const std::string name = run.at("name");
    EXPECT_TRUE(has(swept.out, name)) << swept.out;
    EXPECT_TRUE(fs::exists(place.in(name + ".log")));
    const std::string friction = run.at("varied").at("materials.glass.friction"),
                      seed = run.at("varied").at("seed");
    const std::string alone = place.folder / ("alone-" + name);
    ASSERT_EQ(
        call({"run", place.file, "--out", alone, "--threads", "2", "--set", "phases.fly.duration=\"10 ms\"",
              "--set", "materials.glass.friction=" + friction, "--set", "seed=" + seed})
            .exit,
        0);
    EXPECT_EQ(json_of(place.in(name) + "/result.json")["state_hash"],
              json_of(alone + "/result.json")["state_hash"]);
  }
}

TEST(Sweep, TakesSeveralCasesInAnyPlaceAmongTheOptions) {
  const Place place;
  const std::string other = place.folder.file("other.toml", "extends = \"die.toml\"\nseed = 9\n");
  const Outcome swept =
      call({"sweep", "--threads", "1", place.file, other, "--vary", "seed=5,6", "--out", place.out});
  ASSERT_EQ(swept.exit, 0) << swept.err;
  for (const char* name : {"die-seed-5", "die-seed-6", "other-seed-5", "other-seed-6"})
    EXPECT_TRUE(fs::exists(place.in(name))) << name;
}

TEST(Sweep, KeepsWhatIsCompleteWhenGivenAgainFromElsewhere) {
  const Place place;
  ASSERT_EQ(place.sweep({"--seeds", "2"}).exit, 0);
  const auto written = fs::last_write_time(place.in("die-seed-1/result.json"));
  const std::string before = text_of(place.in("sweep.csv"));
  const Outcome again = place.sweep({"--seeds", "2", "--resume"}, place.folder.path().string());
  EXPECT_EQ(again.exit, 0) << again.err;
  EXPECT_EQ(fs::last_write_time(place.in("die-seed-1/result.json")), written);
  EXPECT_EQ(text_of(place.in("sweep.csv")), before);
}

TEST(Sweep, EndsTheOthersIfOneRunFailsAndSaysWhich) {
  const Place place;
  // The second leaves the domain through its top.
  const std::vector<std::string> options{
      "--vary",
      R"(sources.pack.velocity=["0 m/s","0 m/s","0 m/s"],["0 m/s","0 m/s","3 m/s"],["0 m/s","0 m/s","-0.1 m/s"])",
      "--jobs", "1"};
  const Outcome swept = place.sweep(options);
  EXPECT_EQ(swept.exit, 5) << swept.err;
  EXPECT_TRUE(has(swept.err, "2 of 3 runs complete, 1 failed")) << swept.err;
  EXPECT_TRUE(has(swept.err, "failed with exit code 5: pulvis: ")) << swept.err;
  const auto lines = lines_of(text_of(place.in("sweep.csv")));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(has(lines[1], ",complete,5,")) << lines[1];
  EXPECT_TRUE(has(lines[2], ",failed (5),,,")) << lines[2];
  EXPECT_TRUE(has(lines[3], ",complete,5,")) << lines[3];
  EXPECT_EQ(place.sweep(options).exit, 5) << "and says so again";
}

TEST(Sweep, GoesOnWithARunThatCouldNotBeginOnceItCan) {
  const Place place;
  fs::create_directories(place.out);
  // A file where the run's folder must be.
  ASSERT_EQ(place.sweep({"--seeds", "2"}).exit, 0);
  fs::remove_all(place.in("die-seed-2"));
  place.folder.file("sweep/die-seed-2", "in the way");
  const Outcome blocked = place.sweep({"--seeds", "2"});
  EXPECT_EQ(blocked.exit, 6) << blocked.err;
  EXPECT_TRUE(has(blocked.err, "die-seed-2 failed with exit code 6")) << blocked.err;
  fs::remove(place.in("die-seed-2"));
  EXPECT_EQ(place.sweep({"--seeds", "2"}).exit, 0);
}

TEST(Sweep, StartsNothingIfOneOfItsCasesIsWrong) {
  const Place place;
  const Outcome wrong = place.sweep({"--vary", "materials.glass.friction=0.2,-1"});
  EXPECT_EQ(wrong.exit, 3);
  EXPECT_TRUE(has(wrong.err, "--set materials.glass.friction: error:")) << wrong.err;
  EXPECT_TRUE(has(wrong.err, "of the run die-friction--1; nothing has been started")) << wrong.err;
  EXPECT_FALSE(fs::exists(place.out));
  EXPECT_EQ(place.sweep({"--vary", "materials.glas.friction=0.2"}).exit, 3);
  EXPECT_EQ(call({"sweep", place.folder / "nothing.toml", "--out", place.out}).exit, 4);
  EXPECT_EQ(place.sweep({"--vary", "materials.glass.friction"}).exit, 2);
  EXPECT_EQ(place.sweep({"--resume"}).exit, 2) << "there is none";
  EXPECT_FALSE(fs::exists(place.out));
}

TEST(Sweep, RefusesAFolderOfOtherRunsAndNamesThem) {
  const Place place;
  ASSERT_EQ(place.sweep({"--seeds", "2"}).exit, 0);
  const Outcome more = place.sweep({"--seeds", "3"});
  EXPECT_EQ(more.exit, 2);
  EXPECT_TRUE(has(more.err, "holds a sweep of other runs")) << more.err;
  EXPECT_TRUE(has(more.err, "\n  die-seed-3 is not in it")) << more.err;
  EXPECT_FALSE(has(more.err, "die-seed-2")) << more.err;
  const Outcome less = place.sweep({"--seeds", "1"});
  EXPECT_EQ(less.exit, 2);
  EXPECT_TRUE(has(less.err, "\n  die-seed-2 is in it, and not asked for now")) << less.err;
  const Outcome other = place.sweep({"--seeds", "2", "--set", "materials.glass.friction=0.1"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_TRUE(has(other.err, "\n  die-seed-1 is another there")) << other.err;
  // What does not change the course of a run may change.
  EXPECT_EQ(place.sweep({"--seeds", "2", "--set", "output.log_interval=\"1 ms\""}).exit, 0);
}

TEST(Sweep, RefusesAFolderOfOtherThings) {
  const Place place;
  fs::create_directories(place.out);
  place.folder.file("sweep/mine.txt", "mine");
  const Outcome refused = place.sweep({});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_TRUE(has(refused.err, "holds other things than a sweep")) << refused.err;
  place.folder.file("sweep/sweep.json", "{\"runs\": 3}");
  const Outcome damaged = place.sweep({});
  EXPECT_EQ(damaged.exit, 4);
  EXPECT_TRUE(has(damaged.err, "is no record of a sweep")) << damaged.err;
  EXPECT_EQ(text_of(place.in("mine.txt")), "mine");
}

}  // namespace
