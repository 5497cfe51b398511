// SPDX-License-Identifier: Apache-2.0
// A case that extends another: what merges, what replaces, what falls away, and where what is wrong is said to be.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>

#include "tests/case/sample_case.hpp"
#include "tests/output/scratch_folder.hpp"

namespace pulvis {
namespace {

using namespace tests;
namespace fs = std::filesystem;

/// A folder of case files of its own for each test.
class Extension : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    test::put(path(name), text);
    return path(name);
  }
  std::string path(const std::string& name) const { return folder_.file(name); }

  /// A case that extends base.toml, which is the minimal case.
  Case extended(const std::string& text, const std::vector<Override>& overrides = {}) const {
    file("base.toml", minimal_case);
    return read_case(file("die.toml", "extends = \"base.toml\"\n" + text), overrides);
  }

  static std::string fault_of(const std::string& file, Exit* exit = nullptr) {
    try {
      read_case(file);
    } catch (const Failure& failure) {
      if (exit != nullptr) *exit = failure.code();
      return failure.what();
    }
    return "";
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  const test::ScratchFolder folder_;
};

std::string meaning(const Case& c, const std::string& key) {
  for (const ResolvedKey& k : c.keys)
    if (k.key == key) return k.meaning;
  return "not there";
}

std::string origin(const Case& c, const std::string& key) {
  for (const ResolvedKey& k : c.keys)
    if (k.key == key) return k.origin;
  return "not there";
}

void expect_same_keys(const Case& one, const Case& other) {
  ASSERT_EQ(one.keys.size(), other.keys.size());
  for (std::size_t k = 0; k < one.keys.size(); ++k) {
    EXPECT_EQ(one.keys[k].key, other.keys[k].key);
    EXPECT_EQ(one.keys[k].meaning, other.keys[k].meaning) << one.keys[k].key;
  }
}

TEST_F(Extension, OfNothingButTheBaseIsTheBase) {
  const Case c = extended("");
  expect_same_keys(c, read_case_text(minimal_case, "base.toml"));
  EXPECT_EQ(c.file, path("die.toml"));
  EXPECT_EQ(c.bases, std::vector<std::string>{path("base.toml")});
}

TEST_F(Extension, MergesTablesKeyByKeyAndReplacesValuesAndLists) {
  const Case c = extended(R"(
[domain]
max = ["3 mm", "3 mm", "9 mm"]
[materials.molybdenum]
friction = 0.6
[materials.steel]
density = "7.8 g/cm^3"
young_modulus = "210 GPa"
poisson_ratio = 0.3
restitution = 0.5
friction = 0.3
[[phases]]
name = "fill"
sources = ["bed"]
until = "time"
duration = "10 ms"
[[phases]]
name = "rest"
until = "time"
duration = "20 ms"
)");
  EXPECT_EQ(c.domain.min.x, 0.0);
  EXPECT_EQ(c.domain.max.x, 3e-3);
  ASSERT_EQ(c.materials.size(), 2u);
  EXPECT_EQ(c.materials[0].name, "molybdenum");  // in the order of the base
  EXPECT_EQ(c.materials[0].friction, 0.6);
  EXPECT_EQ(c.materials[0].density, 10200.0);
  EXPECT_EQ(c.materials[1].name, "steel");
  ASSERT_EQ(c.phases.size(), 2u);  // as a whole
  EXPECT_EQ(c.phases[0].name, "fill");
}

TEST_F(Extension, SaysInWhichFileEachKeyStands) {
  const Case c = extended("seed = 9\n[materials.molybdenum]\nfriction = 0.6\n", {{"domain.escape", "count"}});
  EXPECT_EQ(origin(c, "seed"), path("die.toml") + ":2");
  EXPECT_EQ(origin(c, "materials.molybdenum.friction"), path("die.toml") + ":4");
  EXPECT_EQ(origin(c, "materials.molybdenum.density"), path("base.toml") + ":6");
  EXPECT_EQ(origin(c, "domain.escape"), "--set domain.escape");
  EXPECT_EQ(origin(c, "gravity.acceleration"), "default");
  EXPECT_EQ(place_of(c, "powders.mo"), path("base.toml") + ":12");
}

TEST_F(Extension, OverridesComeLast) {
  const Case c = extended("[materials.molybdenum]\nfriction = 0.6\n",
                          {{"materials.molybdenum.friction", "0.7"}, {"phases.settle.duration", "1 s"}});
  EXPECT_EQ(c.materials[0].friction, 0.7);
  EXPECT_EQ(c.phases[0].duration, 1.0);
}

TEST_F(Extension, MayGoOnOverSeveralFilesInSeveralFolders) {
  file("common/powder.toml", minimal_case);
  file("common/die.toml", "extends = \"powder.toml\"\nseed = 2\ntitle = \"die\"\n[time]\nfraction = 0.3\n");
  const Case c = read_case(file("cases/mine/case.toml", "extends = \"../../common/die.toml\"\nseed = 3\n"));
  EXPECT_EQ(c.seed, 3u);
  EXPECT_EQ(c.title, "die");
  EXPECT_EQ(c.time.fraction, 0.3);
  EXPECT_EQ(c.bases, (std::vector<std::string>{path("common/die.toml"), path("common/powder.toml")}));
}

TEST_F(Extension, WhatHasNoMeaningAnyMoreBesideItFallsAway) {
  const Case c = extended(R"(
[powders.mo.size]
kind = "uniform"
smallest = "3 um"
largest = "8 um"
[time]
step = "1 us"
)");
  EXPECT_EQ(c.powders[0].size.kind, SizeDistribution::Kind::uniform);
  EXPECT_EQ(c.powders[0].size.largest, 8e-6);
  EXPECT_EQ(meaning(c, "powders.mo.size.diameter"), "not there");

  // Of two that exclude each other, in both directions.
  file("step.toml", "extends = \"base.toml\"\n[time]\nstep = \"1 us\"\n");
  const Case back = read_case(file("fraction.toml", "extends = \"step.toml\"\n[time]\nfraction = 0.1\n"));
  EXPECT_FALSE(back.time.step.has_value());
  EXPECT_EQ(back.time.fraction, 0.1);
}

TEST_F(Extension, WhatIsGivenTwiceInTheExtensionItselfIsStillAnError) {
  file("base.toml", minimal_case);
  const std::string fault =
      fault_of(file("die.toml", "extends = \"base.toml\"\n[time]\nstep = \"1 us\"\nfraction = 0.1\n"));
  EXPECT_TRUE(has(fault, path("die.toml") + ":4:1: error: time.fraction is given beside step")) << fault;
}

TEST_F(Extension, ErrorsNameTheFileAndLineWhereTheKeyStands) {
  file("base.toml", with(minimal_case, "density = \"10.2 g/cm^3\"", "density = \"10.2 g\"\ncolour = 3"));
  const std::string fault =
      fault_of(file("die.toml", "extends = \"base.toml\"\nsede = 3\n[time]\nfraction = 7\n"));
  EXPECT_TRUE(has(fault, path("die.toml") + ":2:1: error: unknown key sede")) << fault;
  EXPECT_TRUE(has(fault, path("die.toml") + ":4:12: error: time.fraction")) << fault;
  EXPECT_TRUE(has(fault, path("base.toml") + ":6:11: error: materials.molybdenum.density")) << fault;
  EXPECT_TRUE(has(fault, path("base.toml") + ":7:1: error: unknown key materials.molybdenum.colour"))
      << fault;
  EXPECT_TRUE(has(fault, "   7 | colour = 3")) << fault;

  file("base.toml", "[domain\n");
  EXPECT_TRUE(has(fault_of(path("die.toml")), path("base.toml") + ":1:")) << fault_of(path("die.toml"));
}

TEST_F(Extension, OfABaseThatIsIncompleteAloneMayBeComplete) {
  const std::string whole = minimal_case;
  const std::size_t cut = whole.find("[sources.bed]");
  const std::string base = file("base.toml", whole.substr(0, cut));
  Exit exit = Exit::ok;
  EXPECT_TRUE(has(fault_of(base, &exit), "sources is missing"));
  EXPECT_EQ(exit, Exit::bad_case);
  EXPECT_EQ(read_case(file("die.toml", "extends = \"base.toml\"\n" + whole.substr(cut))).sources.size(), 1u);
}

TEST_F(Extension, OfABaseWithAWrongValueMayPutItRight) {
  file("base.toml", with(minimal_case, "friction = 0.4", "friction = -1"));
  EXPECT_TRUE(has(fault_of(path("base.toml")), "friction"));
  EXPECT_EQ(read_case(file("die.toml", "extends = \"base.toml\"\nmaterials.molybdenum.friction = 0.2\n"))
                .materials[0]
                .friction,
            0.2);
}

TEST_F(Extension, OfAnEmptyBaseIsTheCaseItself) {
  for (const char* empty : {"", "\n\n# nothing here\n", "\xEF\xBB\xBF"}) {
    file("base.toml", empty);
    const Case c = read_case(file("die.toml", std::string("extends = \"base.toml\"\n") + minimal_case));
    expect_same_keys(c, read_case_text(minimal_case, "die.toml"));
  }
}

TEST_F(Extension, OfItselfOrInACircleIsRefusedWithTheChain) {
  file("a.toml", "extends = \"sub/b.toml\"\n");
  file("sub/b.toml", "seed = 1\nextends = \"../c.toml\"\n");
  file("c.toml", "extends = \"./sub/../sub/b.toml\"\n");
  Exit exit = Exit::ok;
  const std::string fault = fault_of(path("a.toml"), &exit);
  EXPECT_EQ(exit, Exit::bad_case);
  EXPECT_TRUE(has(fault, path("c.toml") + ":1:11: error: files extend each other in a circle: " +
                             path("sub/b.toml") + " -> " + path("c.toml") + " -> " + path("sub/b.toml")))
      << fault;
  EXPECT_TRUE(has(fault_of(file("self.toml", "extends = \"self.toml\"\n")), "in a circle"));
  fs::create_symlink(path("d.toml"), path("link.toml"));
  EXPECT_TRUE(has(fault_of(file("d.toml", "extends = \"link.toml\"\n")), "in a circle"));
}

TEST_F(Extension, OfAFileThatCannotBeReadSaysWhoWantedIt) {
  Exit exit = Exit::ok;
  const std::string missing = fault_of(file("die.toml", "seed = 1\nextends = \"nothing.toml\"\n"), &exit);
  EXPECT_EQ(exit, Exit::bad_input);
  EXPECT_TRUE(has(missing, path("nothing.toml") + ": cannot read the case file: there is no such file"))
      << missing;
  EXPECT_TRUE(has(missing, path("die.toml") + ":2 extends it")) << missing;
  const std::string folder = fault_of(file("die.toml", "extends = \".\"\n"), &exit);
  EXPECT_EQ(exit, Exit::bad_input);
  EXPECT_TRUE(has(folder, "it is a folder")) << folder;
}

TEST_F(Extension, OfWhatIsNoPathIsRefused) {
  for (const char* value : {"3", "true", "[\"base.toml\"]", "{ file = \"base.toml\" }", "\"\""}) {
    Exit exit = Exit::ok;
    const std::string fault = fault_of(file("die.toml", std::string("extends = ") + value + "\n"), &exit);
    EXPECT_EQ(exit, Exit::bad_case) << value;
    EXPECT_TRUE(has(fault, "die.toml:1:11: error: extends is ")) << fault;
  }
}

TEST_F(Extension, CannotBeSetOnTheCommandLine) {
  file("base.toml", minimal_case);
  for (const Override& o : {Override{"extends", "base.toml"}, Override{"extends.file", "base.toml"}}) {
    try {
      read_case(path("base.toml"), {o});
      ADD_FAILURE() << o.key;
    } catch (const CaseError& error) {
      EXPECT_TRUE(has(error.what(), "extends is no key for --set")) << error.what();
    }
  }
}

TEST_F(Extension, PathsAreSeenFromTheFileThatGivesThem) {
  const std::string meshes = R"(
[walls.shoe]
shape = "mesh"
path = "shoe.stl"
unit = "mm"
material = "molybdenum"
)";
  file("common/base.toml", std::string(minimal_case) + meshes);
  const std::string own = with(with(meshes, "shoe.stl", "../other.stl"), "walls.shoe", "walls.other");
  const Case c = read_case(file("mine/die.toml", "extends = \"../common/base.toml\"\n" + own));
  ASSERT_EQ(c.walls.size(), 2u);
  EXPECT_EQ(c.walls[0].path, path("common/shoe.stl"));
  EXPECT_EQ(c.walls[1].path, path("other.stl"));
  const Case changed =
      read_case(file("mine/third.toml", "extends = \"die.toml\"\nwalls.shoe.path = \"new.stl\"\n"));
  EXPECT_EQ(changed.walls[0].path, path("mine/new.stl"));
  const Case set = read_case(path("mine/die.toml"), {{"walls.shoe.path", "set.stl"}});
  EXPECT_EQ(set.walls[0].path, path("mine/set.stl"));
  // The text that goes into the run folder means the same wherever it lies.
  EXPECT_EQ(read_case_text(c.text, path("elsewhere/case.toml")).walls[0].path, path("common/shoe.stl"));
}

TEST_F(Extension, TextForTheRunFolderMeansTheSameCaseByItself) {
  file("full.toml", full_case);
  const Case c =
      read_case(file("die.toml",
                     "extends = \"full.toml\"\ntitle = \"a \\\"quoted\\\" \\\\ \\u007f title\\n\"\n"
                     "[materials.molybdenum]\nfriction = 0.123456789012345\n"));
  const Case again = read_case_text(c.text, "case.toml");
  EXPECT_TRUE(again.bases.empty());
  expect_same_keys(c, again);
  EXPECT_EQ(again.title, "a \"quoted\" \\ \x7f title\n");
  EXPECT_TRUE(has(c.text, "full.toml")) << c.text;
}

TEST_F(Extension, TextOfACaseThatExtendsNothingIsItsOwn) {
  EXPECT_EQ(read_case(file("die.toml", full_case)).text, full_case);
}

TEST_F(Extension, SurvivesRandomEditsOfBothFiles) {
  std::mt19937 random(20250116);  // fixed, so that a failure can be repeated
  const std::string alphabet = "[]{}\"'=.,#\\\n\t /0123456789eaxz_-+:%\x01\x7f\xff\xc2\xb5";
  const std::string over =
      "extends = \"base.toml\"\nseed = 4\n[time]\nfraction = 0.2\n[materials.molybdenum]\nfriction = 0.1\n";
  const auto edited = [&](std::string text) {
    const std::size_t at = random() % text.size();
    if (random() % 3 == 0) return text.erase(at, 1 + random() % 12);
    if (random() % 2 == 0) return text.insert(at, 1, alphabet[random() % alphabet.size()]);
    return text.insert(random() % text.size(), text.substr(at, random() % 40));
  };
  int read = 0;
  for (int i = 0; i < 1500; ++i) {
    const bool of_base = random() % 2 == 0;
    file("base.toml", of_base ? edited(full_case) : std::string(full_case));
    const std::string die = file("die.toml", of_base ? over : edited(over));
    try {
      const Case c = read_case(die);
      if (!c.bases.empty()) expect_same_keys(c, read_case_text(c.text, "case.toml"));
      ++read;
    } catch (const Failure& failure) {
      EXPECT_TRUE(failure.code() == Exit::bad_case || failure.code() == Exit::bad_input) << failure.what();
      EXPECT_FALSE(std::string(failure.what()).empty());
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(read, 30);  // else the edits would test nothing but refusals
}

TEST_F(Extension, AnswersLargeFilesInTime) {
  const auto started = std::chrono::steady_clock::now();
  std::string tables;
  for (int i = 0; i < 60000; ++i) tables += "[materials.m" + std::to_string(i) + "]\n";
  file("base.toml", tables);
  EXPECT_FALSE(fault_of(file("die.toml", "extends = \"base.toml\"\n" + tables)).empty());
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(30));
}

}  // namespace
}  // namespace pulvis
