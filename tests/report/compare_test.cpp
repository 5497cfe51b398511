// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "report/report.hpp"
#include "tests/output/failures.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/report/sample_run.hpp"
#include "tests/run/program.hpp"

using namespace pulvis;
using namespace pulvis::test;

namespace {

#define EXPECT_SAYS(page, words) EXPECT_NE((page).find(words), std::string::npos) << (words)

TEST(Compare, SetsMeasuresBesideEachOtherWithTheirDifferences) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"), {.porosity = 0.48});
  write_sample_run(scratch.file("b"), {.porosity = 0.504, .surface_energy = 1e-3});
  const tests::Outcome outcome =
      tests::call({"compare", scratch.file("a"), scratch.file("b"), "--out", scratch.file("out")});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const std::string page = content_of(scratch.file("out/comparison.html"));
  EXPECT_SAYS(page, "<td>mean porosity</td><td></td><td class=\"number\">0.48</td><td>0.504 (+5 %)</td>");
  EXPECT_SAYS(page, "<td>materials.molybdenum.surface_energy</td>");
  EXPECT_EQ(page.find("<td>materials.steel.friction</td>"), std::string::npos);
  EXPECT_EQ(page.find("Chance"), std::string::npos);
  for (const char* name :
       {"porosity-cuts", "porosity-profiles", "porosity-histogram", "surface-height", "surface-profiles",
        "wall-pressure", "coordination", "contact-forces", "layers", "time-series"})
    for (const char* kind : {".svg", ".csv", ".gnuplot"})
      EXPECT_TRUE(scratch.has(std::string("out/comparison/") + name + kind)) << name << kind;
}

TEST(Compare, DrawsTheMapsOfAllRunsInOneScale) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"), {.porosity = 0.40, .pictures = false});
  write_sample_run(scratch.file("b"), {.porosity = 0.60, .pictures = false});
  report::write_comparison({scratch.file("a"), scratch.file("b")}, scratch.file("out"));
  const std::string script = content_of(scratch.file("out/comparison/porosity-cuts.gnuplot"));
  const auto at = script.find("set cbrange [");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(script.find("set cbrange [", at + 1), std::string::npos);
  double low = 0.0, high = 0.0;
  ASSERT_EQ(std::sscanf(script.c_str() + at, "set cbrange [%lf:%lf]", &low, &high), 2);
  EXPECT_LT(low, 0.40);
  EXPECT_GT(high, 0.60);
}

/// Runs without pictures, by their names.
struct SampleRuns {
  ScratchFolder scratch;
  std::vector<std::string> folders;

  void add(const char* name, SampleRun run) {
    run.pictures = false;
    write_sample_run(scratch.file(name), run);
    folders.push_back(scratch.file(name));
  }
};

TEST(Compare, TellsChanceFromDifference) {
  SampleRuns runs;
  runs.add("weak-1", {.seed = 1, .porosity = 0.480});
  runs.add("weak-2", {.seed = 2, .porosity = 0.482});
  runs.add("weak-3", {.seed = 3, .porosity = 0.484});
  runs.add("strong-1", {.seed = 1, .porosity = 0.530, .surface_energy = 1e-3});
  runs.add("strong-2", {.seed = 2, .porosity = 0.532, .surface_energy = 1e-3});
  report::write_comparison(runs.folders, runs.scratch.file("out"));
  const std::string page = content_of(runs.scratch.file("out/comparison.html"));
  EXPECT_SAYS(page, "like weak-1: 3 runs (weak-1, weak-2, weak-3)");
  EXPECT_SAYS(page, "like strong-1: 2 runs (strong-1, strong-2)");
  EXPECT_SAYS(page, "0.482 ± 0.002");
  EXPECT_SAYS(page, "beyond the scatter of the seeds: +0.049");
  EXPECT_SAYS(page, "no difference");
}

TEST(Compare, CountsAsChanceOnlyCompleteRunsOfDifferentSeeds) {
  SampleRuns runs;
  runs.add("one", {.seed = 1, .porosity = 0.480});
  runs.add("again", {.seed = 1, .porosity = 0.480});
  runs.add("two", {.seed = 2, .porosity = 0.484});
  runs.add("stopped", {.seed = 3, .porosity = 0.600, .ended = false});
  runs.add("empty", {.seed = 4, .ended = false, .measures = false});
  auto nothing = tests::Json::parse(content_of(runs.scratch.file("empty/result.json")));
  nothing["phases"] = tests::Json::array();
  put(runs.scratch.file("empty/result.json"), nothing.dump());
  report::write_comparison(runs.folders, runs.scratch.file("out"));
  const std::string page = content_of(runs.scratch.file("out/comparison.html"));
  EXPECT_SAYS(
      page,
      "like one: 2 runs (one, two); left out: again repeats seed 1, stopped has not ended, empty has not "
      "ended");
  EXPECT_SAYS(page, "0.482 ± 0.0028");
}

TEST(Compare, RefusesRunsOfDifferentDies) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"));
  write_sample_run(scratch.file("b"), {.die = {0.008, 0.006, 0.009}});
  const std::string message = failure_of(Exit::usage, [&] {
    report::write_comparison({scratch.file("a"), scratch.file("b")}, scratch.file("out"));
  });
  EXPECT_SAYS(message, "different dies");
  EXPECT_SAYS(message, "9 mm");
  EXPECT_FALSE(scratch.has("out"));
}

TEST(Compare, WantsTwoRuns) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"));
  EXPECT_EQ(tests::call({"compare", scratch.file("a"), "--out", scratch.file("out")}).exit, 2);
}

TEST(Compare, TakesARunThatHasNotEndedAndSaysSo) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"));
  write_sample_run(scratch.file("b"), {.ended = false, .measures = false, .pictures = false});
  report::write_comparison({scratch.file("a"), scratch.file("b")}, scratch.file("out"));
  const std::string page = content_of(scratch.file("out/comparison.html"));
  EXPECT_SAYS(page, "b has not come to its end");
  EXPECT_SAYS(page, "b: Cut open at the end, coloured by speed: pictures/speed.png is missing.");
}

TEST(Compare, TellsFoldersOfOneNameApart) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("x/run"), {.pictures = false});
  write_sample_run(scratch.file("y/run"), {.pictures = false});
  report::write_comparison({scratch.file("x/run"), scratch.file("y/run")}, scratch.file("out"));
  const std::string page = content_of(scratch.file("out/comparison.html"));
  EXPECT_SAYS(page, scratch.file("x/run"));
  EXPECT_SAYS(page, scratch.file("y/run"));
}

TEST(Compare, ThatCannotBeWrittenIsAnError) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("a"), {.pictures = false});
  put(scratch.file("out"), "a file");
  EXPECT_EQ(tests::call({"compare", scratch.file("a"), scratch.file("a"), "--out", scratch.file("out")}).exit,
            6);
  EXPECT_EQ(content_of(scratch.file("out")), "a file");
}

}  // namespace
