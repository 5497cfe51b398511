// SPDX-License-Identifier: Apache-2.0
#include "case/problems.hpp"

#include <gtest/gtest.h>

#include "tests/case/sample_case.hpp"

namespace pulvis {
namespace {

using namespace tests;

// Every wrong edit of a sample: where it is reported and what the message holds.
struct Wrong {
  const char* part;         ///< of the full case
  const char* replacement;  ///< that makes it wrong
  const char* at;           ///< text of the changed case whose start is the place; "" for none in the file
  std::vector<std::string> says;
};

void expect_reported(const Wrong& wrong) {
  const std::string text = with(full_case, wrong.part, wrong.replacement);
  const std::string all = messages_of(text);
  const std::string place = "die.toml:" + place_in(text, wrong.at) + ": error: ";
  EXPECT_NE(all.find(place), std::string::npos) << "expected at " << place << "\n" << all;
  for (const std::string& part : wrong.says)
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  EXPECT_EQ(problems_of(text).size(), 1u) << all;
}

TEST(CaseProblems, PointsAtTheValueLikeACompiler) {
  const std::string text = with(minimal_case, "317 GPa", "70 GP");
  EXPECT_EQ(
      messages_of(text),
      "die.toml:7:17: error: materials.molybdenum.young_modulus is not a pressure: unknown unit \"GP\"\n"
      "   7 | young_modulus = \"70 GP\"\n"
      "     |                 ^^^^^^^ expected e.g. \"70 GPa\"\n");
}

TEST(CaseProblems, ReportsQuantitiesThatAreNone) {
  expect_reported({"\"317 GPa\"", "317", "317", {"has no unit", "expected e.g. \"317 GPa\""}});
  expect_reported(
      {"\"317 GPa\"", "\"317\"", "\"317\"", {"\"317\" has no unit", "expected e.g. \"317 GPa\""}});
  expect_reported({"\"317 GPa\"", "\"4.6 um\"", "\"4.6 um\"", {"is not a pressure: \"4.6 um\" is a length"}});
  expect_reported({"\"317 GPa\"", "[1]", "[1]", {"is a list", "expected a pressure with its unit"}});
  expect_reported({"\"317 GPa\"", "nan", "nan", {"is no finite number"}});
  expect_reported({"\"-9.81 m/s²\"",
                   "-9.81",
                   "-9.81",
                   {"gravity.acceleration is not an acceleration: -9.81 has no unit"}});
}

TEST(CaseProblems, ReportsNumbersThatAreNoneOrNotFinite) {
  expect_reported({"poisson_ratio = 0.31",
                   "poisson_ratio = \"0.31\"",
                   "\"0.31\"",
                   {"is text: \"0.31\"", "expected a number"}});
  expect_reported({"poisson_ratio = 0.31", "poisson_ratio = inf", "inf", {"no finite number"}});
  expect_reported({"shares = [1, 3, 1.5]", "shares = [1, nan, 1.5]", "nan", {"no finite number"}});
  expect_reported({"count = 1e3", "count = 1.5", "1.5\n\n[sources.old]", {"expected a whole number"}});
  expect_reported({"seed = 7", "seed = -7", "-7", {"seed is out of range: -7", "expected at least 0"}});
  expect_reported({"picture = false", "picture = \"no\"", "\"no\"", {"expected true or false"}});
  expect_reported(
      {"title = \"a die, filled and shaken\"", "title = 1979-05-27", "1979", {"title is a date"}});
}

TEST(CaseProblems, ReportsValuesOutOfRange) {
  expect_reported({"poisson_ratio = 0.31",
                   "poisson_ratio = 0.5",
                   "0.5\nsurface",
                   {"out of range: 0.5", "greater than -1 and less than 0.5"}});
  expect_reported({"restitution = 0.6",
                   "restitution = 0",
                   "0\nfriction",
                   {"out of range", "greater than 0 and at most 1"}});
  expect_reported({"friction = 0.2", "friction = -0.2", "-0.2\n\n[mixing]", {"at least 0"}});
  expect_reported({"coarse_graining = 20\n", "coarse_graining = 0.5\n", "0.5\nsimulated", {"at least 1"}});
  expect_reported({"\"50 MPa\"", "\"0 MPa\"", "\"0 MPa\"", {"expected greater than 0 Pa"}});
}

TEST(CaseProblems, ReportsUnknownKeysWithTheNearest) {
  expect_reported({"young_modulus = \"210",
                   "surface_enrgy = \"1 J/m^2\"\nyoung_modulus = \"210",
                   "surface_enrgy",
                   {"unknown key materials.steel.surface_enrgy", "did you mean \"surface_energy\"?"}});
  expect_reported(
      {"[output]", "[autput]\n[output]", "autput", {"unknown key autput", "did you mean \"output\"?"}});
  expect_reported({"step = \"1 us\"",
                   "step = \"1 us\"\ncycles = 3",
                   "cycles = 3",
                   {"unknown key time.cycles", "this is a key of \"phases[]\""}});
}

TEST(CaseProblems, ReportsMissingKeysAtTheirTable) {
  expect_reported({"density = \"7.8 g/cm^3\"\n",
                   "",
                   "steel]",
                   {"materials.steel.density is missing", "density = \"10.2 g/cm^3\""}});
  expect_reported({"name = \"settle\"\n", "", "[[phases]]\nuntil = \"rest\"", {"phases[1].name is missing"}});
  expect_reported(
      {"time_limit = \"2 s\"\n", "", "[[phases]]\nname = \"settle\"", {"phases[1].time_limit is missing"}});
  expect_reported({"mass = \"20 mg\"\n",
                   "",
                   "rain]\nkind",
                   {"sources.rain.count is missing, and so is mass", "exactly one"}});
}

TEST(CaseProblems, ReportsKeysThatExcludeEachOther) {
  expect_reported(
      {"peak_acceleration",
       "amplitude = \"1 mm\"\npeak_acceleration",
       "peak_acceleration",
       {"motions.shaking.peak_acceleration is given beside amplitude", "only one of them can hold"}});
  expect_reported({"count = 1e3",
                   "count = 1e3\nmass = \"1 mg\"",
                   "mass = \"1 mg\"",
                   {"sources.pack.mass is given beside count"}});
  expect_reported({"step = \"1 us\"",
                   "step = \"1 us\"\nfraction = 0.1",
                   "fraction = 0.1",
                   {"time.fraction is given beside step"}});
}

TEST(CaseProblems, ReportsKeysWithoutMeaningWhereTheyStand) {
  expect_reported({"cycles = 5",
                   "cycles = 5\nduration = \"1 s\"",
                   "duration",
                   {"no meaning where until is \"cycles\"", "it counts where until is \"time\""}});
  expect_reported({"point = ",
                   "radius = \"1 mm\"\npoint = ",
                   "radius",
                   {"walls.floor.radius", "\"cylinder\", \"cone\" or \"sphere\""}});
}

TEST(CaseProblems, ReportsNamesOfNothingWithTheNearest) {
  expect_reported({"material = \"molybdenum\"\ncoarse_graining = 20\n",
                   "material = \"molybdenium\"\ncoarse_graining = 20\n",
                   "\"molybdenium\"",
                   {"there is no \"molybdenium\" in [materials]", "did you mean \"molybdenum\"?"}});
  expect_reported({"motion = \"shaking\"",
                   "motion = \"dancing\"",
                   "\"dancing\"",
                   {"in [motions]", "expected \"shaking\""}});
  expect_reported(
      {"motions = [\"shaking\"]", "motions = [\"shakin\"]", "\"shakin\"", {"did you mean \"shaking\"?"}});
  expect_reported({"normal = \"jkr\"",
                   "normal = \"jrk\"",
                   "\"jrk\"",
                   {"contact.normal cannot be \"jrk\"", "did you mean \"jkr\"?"}});
}

TEST(CaseProblems, ReportsListsOfWrongLengthAndDuplicates) {
  expect_reported({"[0, 0, 2]", "[0, 2]", "[0, 2]", {"walls.tube.axis has 2 elements", "expected 3"}});
  expect_reported({"[3, 0, 4]", "[0, 0, 0]", "[0, 0, 0]", {"has no direction"}});
  expect_reported({"[\"x\", \"y\"]", "[\"x\", \"x\"]", "\"x\"]", {"names \"x\" twice"}});
  expect_reported(
      {"name = \"shake\"", "name = \"fill\"", "\"fill\"\nmotions", {"there is a phase \"fill\" before"}});
  expect_reported({"[powders.mo]\n",
                   "[[pairs]]\nmaterials = [\"molybdenum\", \"steel\"]\n[powders.mo]\n",
                   "[\"molybdenum\", \"steel\"]\n[powders",
                   {"names a pair for the second time"}});
}

TEST(CaseProblems, ReportsWhatDoesNotFitTogether) {
  expect_reported({"max = [\"3 mm\", \"3 mm\", \"9 mm\"]",
                   "max = [\"3 mm\", \"-1 mm\", \"9 mm\"]",
                   "\"-1 mm\", \"9 mm\"",
                   {"domain.max is not above domain.min along y"}});
  expect_reported({"\"2 mm\", \"7 mm\"]",
                   "\"2 mm\", \"17 mm\"]",
                   "\"17 mm\"",
                   {"outside the domain along z", "at most 9 mm"}});
  expect_reported(
      {"smallest = \"2 um\"", "smallest = \"9 um\"", "\"8 um\"", {"is not above", "smallest < largest"}});
  expect_reported({"diameter = \"4 um\"", "diameter = \"1 um\"", "\"1 um\"", {"not between the cut-offs"}});
  expect_reported({"\"5 um\", \"7 um\"", "\"5 um\", \"4 um\"", "\"4 um\"]", {"is not ascending"}});
  expect_reported({"[1, 3, 1.5]", "[1, 3]", "[1, 3]", {"one share for each diameter"}});
  expect_reported(
      {"open = [\"+z\"]", "open = [\"top\"]", "\"top\"]\nmaterial", {"a box has no side \"top\""}});
  expect_reported(
      {"die = \"die\"", "die = \"floor\"", "\"floor\"", {"is a plane, whose inside is not known"}});
  expect_reported({"die = \"die\"\n", "", "measures]", {"measures.die is missing", "\"die\" or \"tube\""}});
  expect_reported({"powder = \"fine\"\n", "", "pack]\nkind", {"more than one powder"}});
  expect_reported({"motions = [\"shaking\"]\n", "", "\"cycles\"", {"waits for cycles and has no motion"}});
  expect_reported({"motion = \"shaking\"\n", "", "\"shaking\"]", {"no wall has the motion"}});
  expect_reported({"[\"rain\", \"pack\", \"old\"]",
                   "[\"rain\", \"pack\"]",
                   "old]",
                   {"sources.old is opened by no phase"}});
  expect_reported({"at_least = \"10 ms\"", "at_least = \"10 s\"", "\"10 s\"", {"is not below"}});
  expect_reported({"max = [\"2 mm\", \"2 mm\", \"4 mm\"]",
                   "max = [\"0.4 mm\", \"2 mm\", \"4 mm\"]",
                   "die]\nshape",
                   {"walls.die is only 2.5 parcels wide along x"}});
}

TEST(CaseProblems, ReportsTablesThatAreNone) {
  const auto expect = [](const std::string& text, const std::string& part) {
    const std::string all = messages_of(text);
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  };
  expect_reported({"[output]\n", "[[output]]\n", "[[output]]", {"output is a list", "expected a table"}});
  expect("mixing = 3\n", "die.toml:1:10: error: mixing is a whole number");
  expect("materials = 3\n", "die.toml:1:13: error: materials is a whole number");
  expect("phases = {}\n", "die.toml:1:10: error: phases is a table");
  expect("phases = [1]\n", "die.toml:1:11: error: phases[0] is a whole number");
  expect("[materials.\"a b\"]\n", "is no name");
  expect("[materials]\n", "die.toml:1:2: error: materials is empty");
}

TEST(CaseProblems, ReportsSievesThatAreNone) {
  const char* rate = "mass_rate = \"2 g/s\"\n";
  expect_reported({rate,
                   "mass_rate = \"2 g/s\"\nsieve_pitch = \"1 mm\"\n",
                   "\"1 mm\"\nvelocity",
                   {"sources.rain.sieve_opening is missing", "both sieve_pitch and sieve_opening"}});
  expect_reported({rate,
                   "mass_rate = \"2 g/s\"\nsieve_opening = \"1 mm\"\n",
                   "\"1 mm\"\nvelocity",
                   {"sources.rain.sieve_pitch is missing"}});
  expect_reported({rate,
                   "mass_rate = \"2 g/s\"\nsieve_pitch = \"1 mm\"\nsieve_opening = \"1.2 mm\"\n",
                   "\"1.2 mm\"\nvelocity",
                   {"sources.rain.sieve_opening is wider than the pitch", "at most 1 mm"}});
  expect_reported({rate,
                   "mass_rate = \"2 g/s\"\nsieve_pitch = \"1 g\"\nsieve_opening = \"1.2 mm\"\n",
                   "\"1 g\"\nsieve",
                   {"sources.rain.sieve_pitch is not a length"}});
}

TEST(CaseProblems, ReportsAllProblemsOfAFileInOneGo) {
  std::string text = minimal_case;
  text = with(text, "\"317 GPa\"", "\"317 GP\"");
  text = with(text, "restitution = 0.5", "restitution = 5");
  text = with(text, "material = \"molybdenum\"", "material = \"iron\"");
  text = with(text, "duration = \"0.1 s\"", "durtion = \"0.1 s\"");
  text = with(text, "\"8 mm\"", "\"-8 mm\"");
  const std::vector<Problem> problems = problems_of(text);
  std::vector<int> lines;
  for (const Problem& problem : problems) lines.push_back(problem.line);
  EXPECT_EQ(lines, (std::vector<int>{3, 7, 9, 13, 21, 25})) << messages_of(text);  // 21: duration is missing
}

TEST(CaseProblems, HasTheExitCodeOfABadCase) {
  try {
    read_case_text("", "die.toml");
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    EXPECT_NE(std::string(failure.what()).find("die.toml:1:1: error: domain is missing"), std::string::npos)
        << failure.what();
  }
}

TEST(CaseProblems, ReportsSyntaxErrorsWithTheLineWhereTheyOpen) {
  const auto first = [](const std::string& text) { return messages_of(text); };
  EXPECT_NE(first("a = \"x\nb = 1\n").find("die.toml:1:5: error: this string is not closed"),
            std::string::npos);
  EXPECT_NE(first("# c\na = \"\"\"x\nb = 1\n").find("die.toml:2:5: error: this string is not closed"),
            std::string::npos);
  const std::string bracket = first("a = [1, 2\nb = 3\n");
  EXPECT_NE(bracket.find("die.toml:2:1: error: syntax error"), std::string::npos) << bracket;
  EXPECT_NE(bracket.find("the bracket opened at line 1, column 5"), std::string::npos) << bracket;
  EXPECT_NE(first("a = 1\na = 2\n").find("die.toml:2:"), std::string::npos);
  EXPECT_NE(first("a = 70 GPa\n").find("stand in quotes"), std::string::npos);
  EXPECT_NE(first("[a]\nb = 1\n[a]\n").find("die.toml:3:"), std::string::npos);
}

TEST(CaseProblems, ShowsOnlyTheNeighbourhoodInALongLine) {
  Problem problem{"die.toml", 1, 3000, 5, "wrong", "", std::string(6000, 'x')};
  const std::string text = format_problem(problem);
  EXPECT_LT(text.size(), 400u);
  problem.source_line = "\ta\x1b[31m";
  problem.column = 2;
  problem.length = 100;
  EXPECT_EQ(format_problem(problem), "die.toml:1:2: error: wrong\n   1 | \ta?[31m\n     | \t^^^^^^\n");
}

}  // namespace
}  // namespace pulvis
