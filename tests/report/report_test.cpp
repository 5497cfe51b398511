// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "report/csv_table.hpp"
#include "report/report.hpp"
#include "tests/output/failures.hpp"
#include "tests/output/scratch_folder.hpp"
#include "tests/report/sample_run.hpp"
#include "tests/run/program.hpp"

using namespace pulvis;
using namespace pulvis::test;

namespace {

/// The page of a sample run.
std::string page_of(const ScratchFolder& scratch, const SampleRun& run = {}) {
  write_sample_run(scratch.file("run"), run);
  report::write_report(scratch.file("run"), "");
  return content_of(scratch.file("run/report.html"));
}

std::size_t count(const std::string& text, const std::string& words) {
  std::size_t found = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++found;
  return found;
}

#define EXPECT_SAYS(page, words) EXPECT_NE((page).find(words), std::string::npos) << (words)

TEST(Report, HasItsSectionsInOrder) {
  const ScratchFolder scratch;
  const std::string page = page_of(scratch);
  std::size_t at = 0;
  for (const char* heading : {"<h1>", "The case</h2>", "What came out</h2>", "Results</h2>", "Pictures</h2>",
                              "Where it is dense and where loose</h2>", "The surface of the powder</h2>",
                              "Pressure on the walls</h2>", "Contacts</h2>", "Layers</h2>", "Over time</h2>",
                              "The run&quot;s own numbers</h2>"}) {
    std::string words = heading;
    if (const auto quote = words.find("&quot;"); quote != std::string::npos) words.replace(quote, 6, "'");
    const auto found = page.find(words, at);
    ASSERT_NE(found, std::string::npos) << words;
    at = found;
  }
}

TEST(Report, HasTheNumbersOfTheRunAndEscapesItsText) {
  const ScratchFolder scratch;
  const std::string page = page_of(scratch);
  EXPECT_SAYS(page, "A die for &lt;tests&gt; &amp; nothing else");
  EXPECT_SAYS(page, "<td class=\"number\">0.48</td>");
  EXPECT_SAYS(page, "<td>mass in the die</td>");
  EXPECT_SAYS(page, "<td class=\"number\">3078</td>");
  EXPECT_SAYS(page, "f49844773404c8df");
  EXPECT_SAYS(page, "rayleigh of powder");
  EXPECT_SAYS(page, "pairs 77 %, near lists 23 %<");
  EXPECT_SAYS(page, "3078 inserted, 3078 present, 0 removed, 0 escaped");
  EXPECT_SAYS(page, "a warning of the run");
}

TEST(Report, PutsTheCaseIntoWordsWithWhatWasSetOverIt) {
  const ScratchFolder scratch;
  SampleRun run;
  run.surface_energy = 7e-4;
  const std::string page = page_of(scratch, run);
  EXPECT_SAYS(page, "box of 8 mm x 6 mm x 8 mm inside");
  EXPECT_SAYS(page, "grains of 4.6 um");
  EXPECT_SAYS(page, "surface energy 700 uJ/m^2");
  EXPECT_SAYS(page,
              "Coarse graining of molybdenum: a parcel is 100 times larger than a grain (460 um for 4.6 um)");
  EXPECT_SAYS(page, "keeps the pull-off force");
  EXPECT_SAYS(page, "There is no air");
  EXPECT_SAYS(page, "for 2 cycles; moved by shaking");
}

TEST(Report, ListsAssumedValuesButNotThoseThatWereSet) {
  const ScratchFolder scratch;
  const std::string page = page_of(scratch);
  EXPECT_SAYS(page, "<td>materials.steel.friction</td><td>0.3</td><td>polished die</td>");
  EXPECT_EQ(count(page, "<td>materials.molybdenum.surface_energy</td>"), 0u);
  EXPECT_EQ(count(page, "<td>materials.molybdenum.density</td>"), 0u);
}

TEST(Report, LeavesEachFigureWithItsDataAndItsScript) {
  const ScratchFolder scratch;
  const std::string page = page_of(scratch);
  for (const char* name :
       {"porosity-cuts", "porosity-phases", "porosity-profiles", "porosity-histogram", "surface-height",
        "surface-profiles", "wall-pressure", "coordination", "contact-forces", "layers", "time-series"}) {
    for (const char* kind : {".svg", ".csv", ".gnuplot"})
      EXPECT_TRUE(scratch.has(std::string("run/report/") + name + kind)) << name << kind;
    EXPECT_SAYS(page, std::string("report/") + name + ".csv");
  }
  EXPECT_EQ(count(page, "src=\"data:image/svg+xml"), 11u);
  EXPECT_EQ(count(page, "src=\"data:image/png"), 5u);
}

TEST(Report, FigureDataAreTheMeasuresOfTheRun) {
  const ScratchFolder scratch;
  page_of(scratch);
  const std::string cuts = content_of(scratch.file("run/report/porosity-cuts.csv"));
  // The cell without a value is in no cut; the third of its row is in two: 6 + 5 and more.
  EXPECT_EQ(cuts.find("nan"), std::string::npos);
  const std::string layers = content_of(scratch.file("run/report/layers.csv"));
  EXPECT_SAYS(layers, "\"density\",\"fill\",\"density (g/cm^3)\",5.3,\"height (mm)\",1\n");
  EXPECT_SAYS(layers, "\"vertical stress (Pa)\",300,");
  const std::string contacts = content_of(scratch.file("run/report/coordination.csv"));
  EXPECT_SAYS(contacts, fmt::format("\"fill\",2.5,{}", 1500.0 / 3078.0));
}

// Of the box's sides, u runs along y on -x, but along z on -y; the pressures of the sample count k = 0..3 with u first.
TEST(Report, UnfoldsTheWallsOfABoxAsTheyStand) {
  const ScratchFolder scratch;
  page_of(scratch);
  const auto walls = *report::CsvTable::read(scratch.file("run/report/wall-pressure.csv"));
  const auto x = walls.numbers("x"), y = walls.numbers("y"), pressure = walls.numbers("pressure (Pa)");
  const auto at = [&](double across, double up) {
    for (std::size_t k = 0; k < walls.rows(); ++k)
      if (std::abs(x[k] - across) < 1e-9 && std::abs(y[k] - up) < 1e-9) return pressure[k];
    return -1.0;
  };
  EXPECT_EQ(at(-4.5, 1.5), 100.0);   // -x: y = 1.5, low
  EXPECT_EQ(at(-1.5, -7.5), 100.0);  // -y: x = -1.5, high
  EXPECT_EQ(at(1.5, 4.5), 200.0);    // +y: x = 1.5, low
  EXPECT_EQ(at(1.5, -1.5), 100.0);   // floor
  EXPECT_EQ(at(0.0, 0.0), 5.0);      // the shoe, by itself
}

TEST(Report, CutsThroughPowderEvenIfTheDieIsNearlyEmpty) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"), {.layers_of_powder = 1, .pictures = false});
  report::write_report(scratch.file("run"), "");
  EXPECT_SAYS(content_of(scratch.file("run/report/porosity-cuts.csv")),
              "\"height at 1.33 mm: second axis (mm)");
}

TEST(Report, AsksNothingOfTheNetworkAndHoldsNoScript) {
  const ScratchFolder scratch;
  const std::string page = page_of(scratch);
  EXPECT_SAYS(page, "default-src 'none'; img-src data:; style-src 'unsafe-inline'");
  for (const char* words : {"<script", "<link", "src=\"http", "href=\"http", "url(", "@import", "<iframe"})
    EXPECT_EQ(page.find(words), std::string::npos) << words;
}

TEST(Report, OfARunThatHasNotEndedSaysSoFirst) {
  const ScratchFolder scratch;
  SampleRun run;
  run.ended = false;
  const std::string page = page_of(scratch, run);
  const auto notice = page.find("This run has not come to its end: the run has not ended, or it was killed");
  ASSERT_NE(notice, std::string::npos);
  EXPECT_LT(notice, page.find("<h2"));
  EXPECT_SAYS(page, "let it go on");
}

TEST(Report, OfAnOlderRunWithoutMeasuresNamesWhatIsMissing) {
  const ScratchFolder scratch;
  SampleRun run;
  run.measures = false;
  run.pictures = false;
  const std::string page = page_of(scratch, run);
  EXPECT_SAYS(page, "measures/after-shake.json");
  EXPECT_SAYS(page, "picture.png is missing");
  EXPECT_SAYS(page, "<td>mean porosity</td>");
  EXPECT_TRUE(scratch.has("run/report/wall-pressure.svg"));
  EXPECT_FALSE(scratch.has("run/report/porosity-cuts.svg"));
}

TEST(Report, OfAFolderWithOnlyALogWorks) {
  const ScratchFolder scratch;
  put(scratch.file("run/log.csv"), "step,time_s,kinetic_energy_J\n0,0,1\n1,1,2\n");
  report::write_report(scratch.file("run"), "");
  EXPECT_SAYS(content_of(scratch.file("run/report.html")), "there is no result.json");
}

TEST(Report, WithoutGnuplotIsAPageWithDataBesideIt) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  tests::Surroundings bare;
  bare.environment = {{"PATH", "/nowhere"}};
  const tests::Outcome outcome = tests::call({"report", scratch.file("run")}, bare);
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_SAYS(outcome.err, "gnuplot-nox");
  EXPECT_SAYS(content_of(scratch.file("run/report.html")), "Not drawn: Porosity in three cuts");
  EXPECT_TRUE(scratch.has("run/report/porosity-cuts.csv"));
  EXPECT_TRUE(scratch.has("run/report/porosity-cuts.gnuplot"));
  EXPECT_FALSE(scratch.has("run/report/porosity-cuts.svg"));
}

TEST(Report, GoesWhereItIsAskedTo) {
  const ScratchFolder scratch;
  write_sample_run(scratch.file("run"));
  const tests::Outcome outcome =
      tests::call({"report", scratch.file("run"), "--out", scratch.file("pages/mine.html")});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_SAYS(outcome.out, "mine.html");
  EXPECT_TRUE(scratch.has("pages/mine.html"));
  EXPECT_TRUE(scratch.has("pages/mine/layers.svg"));
  EXPECT_FALSE(scratch.has("run/report.html"));
}

TEST(Report, IsTheSameTwice) {
  const ScratchFolder scratch;
  const std::string first = page_of(scratch);
  report::write_report(scratch.file("run"), "");
  EXPECT_EQ(first, content_of(scratch.file("run/report.html")));
}

}  // namespace
