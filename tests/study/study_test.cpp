// SPDX-License-Identifier: Apache-2.0
// `pulvis study` from its command line to its results.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;
namespace fs = std::filesystem;

namespace {

struct Place {
  TemporaryFolder folder;
  std::string out = folder / "study";

  Outcome study(std::vector<std::string> options) const {
    options.insert(options.begin(), "study");
    options.insert(options.end(), {"--out", out});
    return call(options);
  }
};

TEST(Study, OfCollisionsKeepsEveryLimitAndLeavesRowsPointsAndFigures) {
  const Place place;
  const Outcome done = place.study({"collision", "--quick"});
  ASSERT_EQ(done.exit, 0) << done.out << done.err;
  const Json study = json_of(place.out + "/study.json");
  EXPECT_EQ(study.at("study"), "collision");
  EXPECT_EQ(study.at("passed"), true);
  std::size_t judged = 0;
  for (const Json& row : study.at("rows")) {
    EXPECT_EQ(row.at("passed"), true) << row;
    judged += row.at("limit").is_number();
    for (const char* key : {"quantity", "source", "value", "reference", "deviation"})
      EXPECT_TRUE(row.contains(key));
  }
  EXPECT_GT(judged, 100u);
  for (const Json& point : study.at("points"))
    EXPECT_TRUE(fs::exists(place.out + "/points/" + point.at("name").get<std::string>() + "/result.json"));
  EXPECT_TRUE(fs::exists(place.out + "/restitution-soft.csv"));
  EXPECT_TRUE(has(text_of(place.out + "/study.html"), "Collisions of coarse-grained parcels"));
}

TEST(Study, ComputesOnlyWhatIsMissingWhenGivenAgain) {
  const Place place;
  ASSERT_EQ(place.study({"collision", "--quick"}).exit, 0);
  const std::string kept = place.out + "/points/jkr-none-soft-stress/result.json",
                    lost = place.out + "/points/hertz-none-soft-stress";
  const auto written = fs::last_write_time(kept);
  const std::string before = text_of(place.out + "/study.json");
  fs::remove_all(lost);
  fs::remove(place.out + "/study.json");
  EXPECT_EQ(place.study({"collision", "--quick"}).exit, 0);
  EXPECT_EQ(fs::last_write_time(kept), written);
  EXPECT_TRUE(fs::exists(lost + "/result.json"));
  EXPECT_EQ(text_of(place.out + "/study.json"), before);
}

TEST(Study, SaysWhatIsWrongBeforeItComputesAnything) {
  const Place place;
  const Outcome unknown = place.study({"collisions"});
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_TRUE(has(unknown.err, "there is no study \"collisions\"; studies are:")) << unknown.err;
  EXPECT_TRUE(has(unknown.err, "\n  collision  ")) << unknown.err;
  EXPECT_EQ(place.study({"collision", "case.toml"}).exit, 2) << "it takes no case";
  EXPECT_EQ(place.study({"collision", "--set", "seed=1"}).exit, 2);
  EXPECT_EQ(place.study({"collision", "--factors", "0.5,2"}).exit, 2) << "below 1";
  EXPECT_FALSE(fs::exists(place.out));
}

TEST(Study, RefusesAFolderOfAnotherStudyOrOtherThings) {
  const Place place;
  ASSERT_EQ(place.study({"collision", "--quick"}).exit, 0);
  const Outcome other = place.study({"collision", "--quick", "--factors", "1,3"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_TRUE(has(other.err, "holds the study collision of other points")) << other.err;
  fs::remove(place.out + "/points.json");
  EXPECT_EQ(place.study({"collision", "--quick"}).exit, 2) << "a folder with other things in it";
}

TEST(Study, NamesThePointThatFailedAndEndsWithItsExitCode) {
  const Place place;
  ASSERT_EQ(place.study({"collision", "--quick"}).exit, 0);
  const std::string point = place.out + "/points/hertz-none-soft-stress";
  fs::remove_all(point);
  write_text(point, "in the way");
  const Outcome failed = place.study({"collision", "--quick"});
  EXPECT_EQ(failed.exit, 6) << failed.err;
  EXPECT_TRUE(has(failed.err, "hertz-none-soft-stress failed with exit code 6")) << failed.err;
}

TEST(Study, RunsACaseAtSeveralFactorsAndExtrapolatesItsMeasuresWithAnError) {
  const Place place;
  const std::string file = place.folder.file("die.toml", small_die);
  const std::vector<std::string> command{"converge", file, "--factors", "10,8", "--seeds", "2"};
  const Outcome done = place.study(command);
  ASSERT_EQ(done.exit, 0) << done.err;
  const Json study = json_of(place.out + "/study.json");
  EXPECT_EQ(study.at("points").size(), 4u);
  bool seen = false;
  for (const Json& row : study.at("rows")) {
    EXPECT_TRUE(row.at("limit").is_null()) << row;
    if (!row.at("quantity").get<std::string>().starts_with("fill_mass ")) continue;
    seen = true;
    EXPECT_NEAR(row.at("value").get<double>(), 24e-6, 24e-6 * 0.1);
    // Two factors: the straight line through their means, whose value for grains (factor 1) stands on the row.
    double fine = 0.0, coarse = 0.0;
    for (const Json& point : study.at("points"))
      (point.at("settings").at("factor") == 8.0 ? fine : coarse) +=
          0.5 * point.at("result").at("measures").at("fill_mass").at("value").get<double>();
    EXPECT_NEAR(row.at("value").get<double>(), fine - 7.0 * (coarse - fine) / 2.0, 1e-9 * fine);
  }
  EXPECT_TRUE(seen) << done.out;
  for (const Json& row : study.at("rows"))
    EXPECT_FALSE(row.at("quantity").get<std::string>().starts_with("fill_count")) << "a number of parcels";
  EXPECT_TRUE(fs::exists(place.out + "/converge-fill-mass.csv"));
  place.folder.file("die.toml", with(small_die, "friction = 0.4", "friction = 0.5"));
  EXPECT_EQ(place.study(command).exit, 2) << "it is another case now";
}

TEST(Study, OfACaseSaysWhatIsWrongWithItAtAnyFactorBeforeItRuns) {
  const Place place;
  const std::string file = place.folder.file("die.toml", small_die);
  EXPECT_EQ(place.study({"converge", "--factors", "10,8"}).exit, 2) << "no case";
  EXPECT_EQ(place.study({"converge", file}).exit, 2) << "no factors";
  EXPECT_EQ(place.study({"converge", file, "--factors", "10"}).exit, 2) << "one factor";
  const Outcome coarse = place.study({"converge", file, "--factors", "10,20"});
  EXPECT_EQ(coarse.exit, 3) << coarse.err;
  EXPECT_TRUE(has(coarse.err, "3 parcels")) << coarse.err;
  EXPECT_FALSE(fs::exists(place.out));
}

TEST(Study, StopsOnRequestAndGoesOnFromCheckpointsToTheSameResult) {
  const Place place, straight;
  const std::string file = place.folder.file("die.toml", small_die);
  const std::vector<std::string> command{"converge", file, "--factors", "10,8",
                                         "--seeds",  "2",  "--jobs",    "1"};
  std::vector<std::string> arguments = command;
  arguments.insert(arguments.begin(), "study");
  arguments.insert(arguments.end(), {"--out", place.out});
  Process process(arguments);
  const std::string first = place.out + "/points/factor-8-seed-1/run/checkpoints";
  for (int k = 0; k < 4000 && !fs::exists(first); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  process.signal(SIGTERM);
  const auto stopped = process.wait(60.0);
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->exit, 75) << stopped->err;
  EXPECT_TRUE(has(stopped->err, "points are not complete; the same command goes on")) << stopped->err;
  EXPECT_FALSE(fs::exists(place.out + "/study.json"));
  EXPECT_EQ(place.study(command).exit, 0);
  EXPECT_EQ(straight.study(command).exit, 0);
  EXPECT_EQ(json_of(place.out + "/study.json").at("rows"), json_of(straight.out + "/study.json").at("rows"));
}

}  // namespace
