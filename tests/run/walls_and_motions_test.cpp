// SPDX-License-Identifier: Apache-2.0
// Dies from STL files, shoes and motions as a user meets them: what runs, what is refused and with which words.
#include <gtest/gtest.h>

#include <array>

#include "tests/run/small_die.hpp"

using namespace pulvis::tests;

namespace {

const std::string box_die = R"(shape = "box"
min = ["0 mm", "0 mm", "0 mm"]
max = ["3 mm", "3 mm", "4 mm"]
open = ["+z"]
)";
const std::string mesh_die = "shape = \"mesh\"\npath = \"die.stl\"\nunit = \"mm\"\n";
const std::string region = R"(
[measures]
region = { min = ["0 mm", "0 mm", "0 mm"], max = ["3 mm", "3 mm", "4 mm"] }
)";

/// The small die with a wall from die.stl instead of its box.
std::string with_mesh() { return with(small_die, box_die, mesh_die) + region; }

/// Text STL of the faces of a box without its top, in mm; `left_out` facets are missing.
std::string open_box(double scale = 1.0, std::size_t left_out = 0) {
  using Point = std::array<double, 3>;
  const std::array<Point, 8> p{
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 4}, {3, 0, 4}, {3, 3, 4}, {0, 3, 4}}};
  const int faces[5][4] = {{0, 1, 2, 3}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::string text = "solid die\n";
  std::size_t facet = 0;
  for (const auto& f : faces)
    for (const auto& t : {std::array{f[0], f[1], f[2]}, std::array{f[0], f[2], f[3]}}) {
      if (facet++ < left_out) continue;
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int k : t) {
        const Point& q = p[static_cast<std::size_t>(k)];
        text += fmt::format("vertex {} {} {}\n", scale * q[0], scale * q[1], scale * q[2]);
      }
      text += "endloop\nendfacet\n";
    }
  return text + "endsolid die\n";
}

struct Said {
  Outcome check, run;
};

/// What check and run say about a case beside its mesh.
Said said(const std::string& text, const std::string& stl = open_box()) {
  TemporaryFolder folder;
  const std::string file = folder.file("case.toml", text);
  if (!stl.empty()) folder.file("die.stl", stl);
  return {call({"check", file}), call({"run", file, "--out", folder / "out"})};
}

void expect_refused(const std::string& text, int exit, const std::vector<std::string>& parts,
                    const std::string& stl = open_box()) {
  const Said s = said(text, stl);
  EXPECT_EQ(s.check.exit, exit) << s.check.err;
  EXPECT_EQ(s.run.exit, exit) << s.run.err;
  for (const std::string& part : parts)
    EXPECT_TRUE(has(s.check.err, part)) << "no \"" << part << "\" in\n" << s.check.err;
}

TEST(DieFromAnStlFile, FillsAsTheBoxDoesThatItIs) {
  TemporaryFolder folder;
  folder.file("die.stl", open_box());
  const std::string calm = "phases.measure.duration=\"0.04 s\"";  // four times as long to come to rest
  const Outcome mesh =
      call({"run", folder.file("mesh.toml", with_mesh()), "--out", folder / "mesh", "--set", calm});
  const Outcome box =
      call({"run", folder.file("box.toml", small_die), "--out", folder / "box", "--set", calm});
  ASSERT_EQ(mesh.exit, 0) << mesh.err;
  ASSERT_EQ(box.exit, 0) << box.err;
  const Json a = json_of(folder / "mesh/result.json"), b = json_of(folder / "box/result.json");
  EXPECT_EQ(a["ledger"], b["ledger"]);
  const auto porosity = [](const Json& j) { return j["measures"]["porosity_mean"]["value"].get<double>(); };
  EXPECT_NEAR(porosity(a), porosity(b), 0.05) << "roundings part the ways of single parcels, not of the bed";
  const auto force = [](const Json& j) {
    return j["phases"].back()["walls"]["die"]["force_N"][2].get<double>();
  };
  const double weight = -9.81 * a["ledger_mass"]["present"].get<double>();
  EXPECT_NEAR(force(a), weight, 5e-3 * -weight) << "the bed still trembles a little";
  EXPECT_NEAR(force(b), weight, 5e-3 * -weight);
  EXPECT_TRUE(vtk_reads_all_of(folder / "mesh"));
  EXPECT_GT(lines_of(text_of(folder / "mesh/wall-forces.csv")).size(), 3u);
  EXPECT_GT(lines_of(text_of(folder / "mesh/wall-pressure/after-settle.csv")).size(), 3u);
}

TEST(DieFromAnStlFile, IsDescribedByCheck) {
  const Said s = said(with_mesh());
  EXPECT_EQ(s.check.exit, 0) << s.check.err;
  EXPECT_TRUE(has(s.check.out, "die.stl: 3 x 3 x 4 mm, 10 triangles")) << s.check.out;
}

TEST(DieFromAnStlFile, WithAHoleIsWarnedOfWithCountAndPlace) {
  const Said s = said(with_mesh(), open_box(1.0, 1));
  EXPECT_EQ(s.check.exit, 0) << s.check.err;
  for (const char* part : {"die.stl", "hole", "open edges", "mm"})
    EXPECT_TRUE(has(s.check.err, part)) << "no " << part << " in\n" << s.check.err;
}

TEST(DieFromAnStlFile, InAnotherUnitIsRefused) {
  expect_refused(with_mesh(), 3, {"walls.die", "unit"}, open_box(1e-3));
  expect_refused(with(with_mesh(), "unit = \"mm\"", "unit = \"m\""), 3, {"walls.die", "unit"});
  expect_refused(with(with_mesh(), "unit = \"mm\"\n", ""), 3, {"walls.die.unit is missing"});
}

TEST(DieFromAnStlFile, ThatIsNoneIsRefusedWithItsName) {
  expect_refused(with_mesh(), 4, {"die.stl"}, "");
  expect_refused(with_mesh(), 4, {"die.stl"}, "solid die\nendsolid die\n");
  expect_refused(with_mesh(), 4, {"die.stl"}, open_box().substr(0, 400));
  expect_refused(with_mesh(), 4, {"die.stl"}, with(open_box(), "vertex 3 0 0", "vertex nan 0 0"));
  expect_refused(with_mesh(), 4, {"die.stl"}, std::string(84, '\0'));
}

TEST(Bodies, ThatCutIntoEachOtherAreRefused) {
  const std::string shoe = R"([walls.shoe]
shape = "box"
min = ["1 mm", "1 mm", "2.5 mm"]
max = ["3.8 mm", "2 mm", "4.1 mm"]
open = ["-z", "+z"]
material = "steel"

[motions.shaking])";
  const std::string text = with(small_die, "[motions.shaking]", shoe) + "[measures]\ndie = \"die\"\n";
  expect_refused(with(text, "coarse_graining = 10", "coarse_graining = 4"), 3,
                 {"case.toml:45", "die and shoe cut into each other at", "fill"}, "");
}

TEST(Bodies, ThatMoveIntoEachOtherAreRefused) {
  const std::string ram = R"([walls.ram]
shape = "box"
min = ["-0.9 mm", "1 mm", "1 mm"]
max = ["-0.2 mm", "2 mm", "2 mm"]
material = "steel"
motion = "push"

[motions.push]
kind = "translation"
velocity = ["50 mm/s", "0 mm/s", "0 mm/s"]

[motions.shaking])";
  std::string text = with(small_die, "[motions.shaking]", ram) + "[measures]\ndie = \"die\"\n";
  text = with(text, "motions = [\"shaking\"]", "motions = [\"shaking\", \"push\"]");
  expect_refused(with(text, "coarse_graining = 10", "coarse_graining = 4"), 3,
                 {"die and ram cut into each other", "after the phase"}, "");
}

TEST(Bodies, OfSeveralWallsMoveAsOne) {
  const std::string lid = R"([walls.lid]
shape = "rectangle"
corner = ["0 mm", "0 mm", "4 mm"]
along = ["1 mm", "0 mm", "0 mm"]
across = ["0 mm", "3 mm", "0 mm"]
material = "steel"
body = "tool"

[motions.shaking])";
  std::string text = with(small_die, "[motions.shaking]", lid);
  text = with(text, "motion = \"shaking\"\n", "motion = \"shaking\"\nbody = \"tool\"\n");
  expect_refused(text, 3, {"walls.lid", "\"tool\"", "different motions"}, "");
  expect_refused(with(text, "across = [\"0 mm\", \"3 mm\"", "across = [\"1 mm\", \"3 mm\""), 3,
                 {"right angles"}, "");
}

TEST(Bodies, ThatBearAWallsNameMoveAsThatWallDoes) {
  const std::string rim = R"([walls.rim]
shape = "rectangle"
corner = ["3 mm", "0 mm", "4 mm"]
along = ["0.9 mm", "0 mm", "0 mm"]
across = ["0 mm", "3 mm", "0 mm"]
material = "steel"
body = "die"

[motions.shaking])";
  expect_refused(with(small_die, "[motions.shaking]", rim), 3, {"\"die\"", "different motions"}, "");
  expect_refused(with(small_die, "motion = \"shaking\"\n", "motion = \"shaking\"\nbody = \"a,b\"\n"), 3,
                 {"walls.die.body is no name"}, "");
  // Such a name as the wall's own, which is its body's where none is given.
  const std::string long_name(65, 'k');
  expect_refused(with(small_die, "[walls.die]", "[walls." + long_name + "]"), 3, {" is no name"}, "");
}

TEST(Cycles, AreCountedFromTheStartOfTheMotion) {
  TemporaryFolder folder;
  const std::string late = with(small_die, "phase = \"-90 deg\"", "phase = \"-90 deg\"\nstart = \"5 ms\"");
  const Outcome run = call({"run", folder.file("case.toml", late), "--out", folder / "out"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const Json shake = json_of(folder / "out/result.json")["phases"][2];
  EXPECT_NEAR(shake["end_s"].get<double>() - shake["start_s"].get<double>(), 0.025, 1e-5);
  const std::string early = with(small_die, "phase = \"-90 deg\"", "phase = \"-90 deg\"\nend = \"15 ms\"");
  expect_refused(early, 3, {"waits for 2 cycles", "ends before"}, "");
}

TEST(Motions, ThatCannotBeMadeAreRefused) {
  const std::string sine = "kind = \"sine\"\nfrequency = \"100 Hz\"";
  const auto expect = [&](const std::string& instead, const std::vector<std::string>& parts) {
    std::string text = small_die;
    const std::size_t from = text.find("[motions.shaking]"), to = text.find("\n\n", from);
    text.replace(from, to - from, "[motions.shaking]\n" + instead);
    expect_refused(text, 3, parts, "");
  };
  expect("kind = \"path\"\ntimes = [\"0 s\", \"1 s\"]\nx = [\"0 mm\"]", {"motions.shaking.x has 1 elements"});
  expect("kind = \"path\"\ntimes = [\"1 s\", \"0 s\"]\nx = [\"0 mm\", \"1 mm\"]", {"is not ascending"});
  expect("kind = \"path\"\ntimes = [\"0 s\", \"1 s\"]", {"a path without places"});
  expect("kind = \"translation\"\nvelocity = [\"1 mm/s\", \"0 m/s\", \"0 m/s\"]", {"waits for cycles"});
  expect("kind = \"rotation\"\nrate = \"0 Hz\"\npoint = [\"0 m\", \"0 m\", \"0 m\"]", {"waits for cycles"});
  expect(
      "kind = \"sines\"\namplitudes = [\"1 um\", \"1 um\"]\nfrequencies = [\"100 Hz\", \"141.42135623 Hz\"]",
      {"waits for cycles"});
  expect("kind = \"modulated_square\"\nfrequency = \"100 Hz\"\namplitude = \"1 um\"\nrise_time = \"9 ms\"",
         {"motions.shaking"});
  expect("kind = \"sine\"\nfrequency = \"100 Hz\"\namplitude = \"100 mm\"", {"5 % of the smallest radius"});
}

TEST(WallThatAppearsInPowder, StopsTheRunWithItsName) {
  const std::string slide = R"([walls.slide]
shape = "rectangle"
corner = ["0 mm", "0 mm", "0.3 mm"]
along = ["3 mm", "0 mm", "0 mm"]
across = ["0 mm", "3 mm", "0 mm"]
material = "steel"

[motions.shaking])";
  std::string text = with(small_die, "[motions.shaking]", slide) + "[measures]\ndie = \"die\"\n";
  text = with(text, "name = \"fill\"\n", "name = \"fill\"\nwithout = \"slide\"\n");
  const Said s = said(text, "");
  EXPECT_EQ(s.check.exit, 0) << s.check.err;
  EXPECT_EQ(s.run.exit, 5) << s.run.err;
  EXPECT_TRUE(has(s.run.err, "slide appears where powder is")) << s.run.err;
}

TEST(PlaneJustOutsideTheDomain, BearsPowderAllTheSame) {
  const std::string plane = "shape = \"plane\"\npoint = [\"0 mm\", \"0 mm\", \"-2.1 mm\"]\n";
  const std::string text = with(small_die, box_die, plane) + region;
  TemporaryFolder folder;
  const Outcome run =
      call({"run",
            folder.file("case.toml", with(text, "max = [\"4 mm\", \"4 mm\", \"12 mm\"]",
                                          "max = [\"4 mm\", \"4 mm\", \"12 mm\"]\nescape = \"count\"")),
            "--out", folder / "out"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const Json result = json_of(folder / "out/result.json");
  EXPECT_LT(result["phases"].back()["walls"]["die"]["force_N"][2].get<double>(), 0.0);
}

TEST(SlideGate, HoldsPowderUntilItIsTakenAway) {
  const std::string gate = R"([walls.gate]
shape = "rectangle"
corner = ["0 mm", "0 mm", "1.5 mm"]
along = ["3 mm", "0 mm", "0 mm"]
across = ["0 mm", "3 mm", "0 mm"]
material = "steel"

[motions.shaking])";
  std::string text = with(small_die, "[motions.shaking]", gate) + "[measures]\ndie = \"die\"\n";
  text = with(text, "name = \"settle\"\n", "name = \"settle\"\nwithout = \"gate\"\n");
  text = with(text, "name = \"shake\"\n", "name = \"shake\"\nwithout = \"gate\"\n");
  text = with(text, "name = \"measure\"\n", "name = \"measure\"\nwithout = \"gate\"\n");
  TemporaryFolder folder;
  const Outcome run = call({"run", folder.file("case.toml", text), "--out", folder / "out"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const Json result = json_of(folder / "out/result.json");
  EXPECT_LT(result["phases"][0]["walls"]["gate"]["force_N"][2].get<double>(), 0.0) << "it carries powder";
  EXPECT_EQ(result["phases"][1]["walls"]["gate"]["force_N"][2].get<double>(), 0.0);
  EXPECT_EQ(result["ledger"]["escaped"], 0);
}

TEST(RotatingFrame, PressesPowderOnTheFarWall) {
  // The axis lies 100 mm above; at 3.5 turns a second the centrifugal acceleration is 48 m/s^2, downwards.
  const std::string text = with(small_die, "[materials.glass]", R"([rotating_frame]
rate = "3.5 Hz"
axis = [0, 1, 0]
point = ["0 mm", "0 mm", "100 mm"]

[gravity]
acceleration = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]

[materials.glass])");
  TemporaryFolder folder;
  const Outcome run = call({"run", folder.file("case.toml", text), "--out", folder / "out"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const Json result = json_of(folder / "out/result.json");
  const double mass = result["ledger_mass"]["present"].get<double>(), turn = 2 * 3.14159265358979 * 3.5;
  const double force = result["phases"].back()["walls"]["die"]["force_N"][2].get<double>();
  EXPECT_NEAR(-force / (mass * turn * turn * 0.0985), 1.0, 0.02) << "the bed lies about 1.5 mm deep";
}

TEST(GravityTable, MustBeComplete) {
  const std::string gravity = "[gravity]\ntimes = [\"0 s\", \"1 s\"]\nfactors = [1]\n\n[materials.glass]";
  expect_refused(with(small_die, "[materials.glass]", gravity), 3, {"gravity.factors has 1 elements"}, "");
  expect_refused(with(small_die, "[materials.glass]", "[gravity]\ntimes = [\"0 s\"]\n\n[materials.glass]"), 3,
                 {"gravity.times stands alone"}, "");
  expect_refused(with(small_die, "[materials.glass]", "[gravity]\nfactors = [1]\n\n[materials.glass]"), 3,
                 {"needs gravity.times"}, "");
}

TEST(ExampleCases, OfStlAndShoeRunInAQuickForm) {
  // Larger parcels and a shorter way: the same road in seconds. The shoe's parcels are not as large as those in the step: of
  // parcels a quarter as wide as the die one is caught between shoe and die in every second run (by the seed), and no law holds that.
  TemporaryFolder folder;
  const std::string cases = source_folder() + "/cases/die-filling/";
  const Outcome step = call({"run", cases + "stl-step.toml", "--out", folder / "step", "--set",
                             "powders.molybdenum.coarse_graining=220", "--set", "phases.shake.cycles=1"});
  EXPECT_EQ(step.exit, 0) << step.err;
  const Json in_step = json_of(folder / "step/result.json");
  EXPECT_EQ(in_step["ledger"]["escaped"], 0);
  EXPECT_GT(in_step["measures"]["wall_pressure_max"]["value"].get<double>(), 0.0);
  const Outcome shoe =
      call({"run", cases + "shoe.toml", "--out", folder / "shoe", "--set",
            "powders.molybdenum.coarse_graining=150", "--set", "motions.pass.speed=0.3 m/s"});
  EXPECT_EQ(shoe.exit, 0) << shoe.err;
  const Json in_shoe = json_of(folder / "shoe/result.json");
  EXPECT_GT(in_shoe["measures"]["fill_mass"]["value"].get<double>(), 0.3e-3);
}

}  // namespace
