// SPDX-License-Identifier: Apache-2.0
// `pulvis law`: the table of numbers, the curves it writes, and what it says of pairs that are not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "case/reader.hpp"
#include "case/units.hpp"
#include "run/law_report.hpp"
#include "tests/run/law_keys.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

LawReport report_of(const std::string& text, const LawRequest& request = {},
                    const std::vector<Override>& overrides = {}) {
  const Case c = read_case_text(text, "case.toml", overrides);
  const Assembly a = assemble(c);
  return law_report(c, a, forecast(c, a), request);
}

/// The row of a table that begins with this name, its two values split off; empty if there is none.
std::vector<std::string> row_of(const std::string& text, const std::string& name) {
  for (const std::string& line : lines_of(text)) {
    const std::size_t at = line.find_first_not_of(' ');
    if (at == std::string::npos || line.compare(at, name.size(), name) != 0) continue;
    std::vector<std::string> values;
    for (std::size_t from = at + name.size(); from < line.size();) {
      const std::size_t start = line.find_first_not_of(' ', from);
      const std::size_t end = std::min(line.find("  ", start), line.size());
      if (start != std::string::npos) values.push_back(line.substr(start, end - start));
      from = end == line.size() ? end : end + 1;
      if (start == std::string::npos) break;
    }
    return values;
  }
  return {};
}

double number_of(const std::string& text) { return read_quantity(text).quantity.value().value; }

TEST(LawCommand, PrintsTheSameNumbersAsCheckForEveryPair) {
  const Case c = read_case_text(small_die, "case.toml");
  const Assembly a = assemble(c);
  const Forecast f = forecast(c, a);
  for (const PairForecast& p : f.pairs) {
    const std::string first = p.first == "beads" ? "glass" : p.first;
    const LawReport r = law_report(c, a, f, {{first, p.second}, {}});
    const auto expect = [&](const std::string& row, double real, double simulated) {
      const auto values = row_of(r.text, row);
      ASSERT_EQ(values.size(), 2u) << row << " in\n" << r.text;
      EXPECT_NEAR(number_of(values[0]), real, 1e-3 * real) << row;
      EXPECT_NEAR(number_of(values[1]), simulated, 1e-3 * simulated) << row;
    };
    expect("pull-off force", p.pull_off_real, p.pull_off);
    expect("over the weight (Bond number)", p.bond_real, p.bond);
    EXPECT_TRUE(has(row_of(r.text, "collisions stick, without damping")[1],
                    format_quantity(p.sticking_speed, dimension::speed, 3)));
  }
  const std::string all = report_of(small_die).text;
  EXPECT_TRUE(has(all, "beads / beads")) << all;
  EXPECT_TRUE(has(all, "beads / wall of steel")) << all;
}

TEST(LawCommand, WorksForEveryLawOfTheCatalogue) {
  for (const auto& [kind, part] : parts_of_catalogue()) {
    const LawReport r = report_of(small_die, {}, with_part(kind, std::string(part->name)));
    EXPECT_EQ(r.figures.size(), 4u) << part->name;
    EXPECT_FALSE(row_of(r.text, "restitution at").empty()) << part->name;
    EXPECT_FALSE(has(r.text, "nan")) << r.text;
    const bool attracts = kind == "cohesion" && part->name != "none";
    EXPECT_EQ(row_of(r.text, "pull-off force")[1] != "-",
              attracts || part->name == "jkr" || part->name == "luding" || part->name == "edinburgh")
        << part->name << "\n"
        << r.text;
  }
}

TEST(LawCommand, ShowsTheRestitutionAtTheSpeedsAskedFor) {
  const LawReport r = report_of(small_die, {{"glass", "steel"}, {0.5, 0.001}});
  EXPECT_TRUE(has(r.text, "restitution at 1 mm/s (0.4472 asked)")) << r.text;
  EXPECT_TRUE(has(r.text, "restitution at 500 mm/s (0.4472 asked)")) << r.text;
  EXPECT_LT(r.text.find("at 1 mm/s"), r.text.find("at 500 mm/s"));
  EXPECT_TRUE(has(row_of(r.text, "restitution at 1 mm/s (0.4472 asked)")[1], "sticks"));
  const double fast = number_of(row_of(r.text, "restitution at 500 mm/s (0.4472 asked)")[1]);
  EXPECT_NEAR(fast, 0.447, 0.01);
}

TEST(LawCommand, RepeatsTheWarningsOfCheckOnItsPairsOnly) {
  const std::vector<Override> soft = {{"powders.beads.simulated_modulus", "\"0.05 MPa\""}};
  const LawReport r = report_of(small_die, {{"glass", "steel"}, {}}, soft);
  ASSERT_FALSE(r.warnings.empty());
  for (const std::string& w : r.warnings) EXPECT_TRUE(w.starts_with("beads / wall of steel")) << w;
}

TEST(LawCommand, SaysWhereAContactCollapses) {
  const std::vector<Override> keys = {{"contact.normal", "\"hooke\""},
                                      {"contact.normal_stiffness", "\"1 N/m\""},
                                      {"contact.cohesion", "\"sjkr\""},
                                      {"contact.cohesion_energy_density", "\"1 GJ/m^3\""}};
  const LawReport r = report_of(small_die, {}, keys);
  EXPECT_EQ(row_of(r.text, "pull-off force"), (std::vector<std::string>{"collapses", "collapses"})) << r.text;
}

TEST(LawCommand, ProgramPrintsTheTableAndWritesCurves) {
  TemporaryFolder folder;
  folder.file("case.toml", small_die);
  const Outcome seen = call({"law", "case.toml", "--pair", "steel", "glass", "--speed", "0.1 m/s", "--out",
                             "curves", "--set", "materials.steel.restitution=0.4"},
                            {.folder = folder.path().string()});
  ASSERT_EQ(seen.exit, 0) << seen.err;
  EXPECT_EQ(seen.out,
            report_of(small_die, {{"steel", "glass"}, {0.1}}, {{"materials.steel.restitution", "0.4"}}).text);
  EXPECT_TRUE(has(text_of(folder / "curves/beads-wall-of-steel-grain.svg"), "<svg"));
  EXPECT_TRUE(has(text_of(folder / "curves/beads-wall-of-steel-parcel.svg"), "<svg"));
  // The lowest force of the curve is the pull-off force of the table.
  double lowest = 0.0, last = 1.0;
  for (const std::string& line : lines_of(text_of(folder / "curves/beads-wall-of-steel-parcel.csv"))) {
    if (!line.starts_with("\"coming back\"")) continue;
    last = std::stod(line.substr(line.rfind(',') + 1));
    lowest = std::min(lowest, last);
  }
  const double pull = number_of(row_of(seen.out, "pull-off force").at(1));
  EXPECT_NEAR(-lowest, pull, 2e-3 * pull);
  EXPECT_EQ(last, 0.0) << "it ends apart";
}

Outcome refused(const std::vector<std::string>& options, int exit) {
  TemporaryFolder folder;
  // A material that is neither a powder's nor a wall's.
  const std::string spare = with(small_die, "[powders.beads]",
                                 "[materials.brass]\ndensity = \"8 g/cm^3\"\nyoung_modulus = \"100 GPa\"\n"
                                 "poisson_ratio = 0.3\nrestitution = 0.5\nfriction = 0.3\n\n[powders.beads]");
  std::vector<std::string> arguments{"law", folder.file("case.toml", spare)};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome seen = call(arguments);
  EXPECT_EQ(seen.exit, exit) << seen.err;
  EXPECT_EQ(seen.out, "");
  return seen;
}

TEST(LawCommand, RefusesAMaterialThatIsNotThere) {
  const Outcome seen = refused({"--pair", "glass", "stel"}, 2);
  for (const char* part : {"\"stel\"", "glass", "steel", "brass", "beads"})
    EXPECT_TRUE(has(seen.err, part)) << seen.err;
}

TEST(LawCommand, RefusesAPairThatCannotMeet) {
  const Outcome walls = refused({"--pair", "steel", "steel"}, 2);
  EXPECT_TRUE(has(walls.err, "cannot meet")) << walls.err;
  EXPECT_TRUE(has(walls.err, "beads / wall of steel")) << walls.err;
  const Outcome spare = refused({"--pair", "glass", "brass"}, 2);
  EXPECT_TRUE(has(spare.err, "no powder and no wall of the case is of \"brass\"")) << spare.err;
}

TEST(LawCommand, RefusesHalfAPairAndWhatIsNoSpeed) {
  refused({"--pair", "glass"}, 2);
  for (const char* speed : {"0.1", "fast", "0 m/s", "-1 m/s", "3 mm"})
    EXPECT_TRUE(has(refused({"--speed", speed}, 2).err, "--speed")) << speed;
}

TEST(LawCommand, RefusesABadCaseAndAFolderThatCannotBe) {
  EXPECT_TRUE(has(refused({"--set", "contact.normal=\"hook\""}, 3).err, "contact.normal"));
  TemporaryFolder folder;
  const std::string file = folder.file("case.toml", small_die);
  EXPECT_EQ(call({"law", file, "--out", file + "/curves"}).exit, 6);
  EXPECT_EQ(call({"law", folder / "none.toml"}).exit, 4);
}

}  // namespace
