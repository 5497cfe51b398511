// SPDX-License-Identifier: Apache-2.0
#include "case/reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "tests/case/sample_case.hpp"

namespace pulvis {
namespace {

using namespace tests;

TEST(CaseReader, ReadsAMinimalCaseIntoSiUnits) {
  const Case read = read_case_text(minimal_case, "die.toml");
  EXPECT_EQ(read.domain.max, (Vec3{2e-3, 2e-3, 8e-3}));
  ASSERT_EQ(read.materials.size(), 1u);
  EXPECT_EQ(read.materials[0].name, "molybdenum");
  EXPECT_EQ(read.materials[0].density, 10200.0);
  EXPECT_EQ(read.materials[0].young_modulus, 317e9);
  EXPECT_EQ(read.materials[0].poisson_ratio, 0.31);
  ASSERT_EQ(read.powders.size(), 1u);
  EXPECT_EQ(read.powders[0].size.diameter, 4.6e-6);
  EXPECT_EQ(read.powders[0].size.smallest, 4.6e-6);
  EXPECT_EQ(read.powders[0].size.largest, 4.6e-6);
  EXPECT_EQ(read.sources[0].target.count, 100u);
  EXPECT_FALSE(read.sources[0].target.mass);
  EXPECT_EQ(read.phases[0].duration, 0.1);
  EXPECT_EQ(read.phases[0].sources, std::vector<std::size_t>{0});
  EXPECT_EQ(read.text, minimal_case);
  EXPECT_EQ(read.file, "die.toml");
}

TEST(CaseReader, GivesWhatIsNotStatedItsDefault) {
  const Case read = read_case_text(minimal_case, "die.toml");
  EXPECT_EQ(read.seed, 1u);
  EXPECT_EQ(read.body_force.gravity, (Vec3{0, 0, -9.81}));
  EXPECT_TRUE(read.domain.escape_is_error);
  EXPECT_FALSE(read.domain.periodic[0]);
  EXPECT_EQ(read.materials[0].surface_energy, 0.0);
  EXPECT_EQ(read.mixing, Mixing::geometric_mean);
  EXPECT_EQ(read.powders[0].coarse_graining, 1.0);
  EXPECT_FALSE(read.powders[0].simulated_modulus);
  EXPECT_EQ(read.contact.normal, "hertz");
  EXPECT_EQ(read.contact.damping, "restitution");
  EXPECT_EQ(read.contact.rolling, "none");
  EXPECT_EQ(read.time.fraction, 0.2);
  EXPECT_FALSE(read.measures.die);
  EXPECT_EQ(read.measures.cell_diameters, 3.0);
  EXPECT_TRUE(read.output.picture);
}

TEST(CaseReader, ReadsMaterialsPowdersAndContactOfAFullCase) {
  const Case read = read_case_text(full_case, "/cases/die/die.toml");
  EXPECT_EQ(read.title, "a die, filled and shaken");
  EXPECT_EQ(read.seed, 7u);
  EXPECT_TRUE(read.domain.periodic[0] && read.domain.periodic[1] && !read.domain.periodic[2]);
  EXPECT_FALSE(read.domain.escape_is_error);
  EXPECT_EQ(read.body_force.gravity, (Vec3{0, 1, -9.81}));
  ASSERT_EQ(read.materials.size(), 2u);  // in the order of the file
  EXPECT_EQ(read.materials[1].name, "steel");
  EXPECT_EQ(read.materials[0].surface_energy, 1e-4);
  EXPECT_EQ(read.materials[0].friction, 0.4);
  EXPECT_EQ(read.materials[0].rolling_friction, 0.05);
  EXPECT_EQ(read.mixing, Mixing::smaller);
  ASSERT_EQ(read.pairs.size(), 1u);
  EXPECT_EQ(read.pairs[0].first, 1u);
  EXPECT_EQ(read.pairs[0].second, 0u);
  EXPECT_EQ(read.pairs[0].friction, 0.3);
  EXPECT_FALSE(read.pairs[0].restitution);
  EXPECT_EQ(read.pairs[0].work_of_adhesion, 2e-4);
  EXPECT_EQ(read.powders[0].coarse_graining, 20.0);
  EXPECT_EQ(read.powders[0].simulated_modulus, 50e6);
  EXPECT_EQ(read.powders[0].keep, Powder::Keep::sticking_speed);
  const SizeDistribution& table = read.powders[0].size;
  EXPECT_EQ(table.kind, SizeDistribution::Kind::table);
  EXPECT_TRUE(table.by_mass);
  EXPECT_EQ(table.diameters, (std::vector<double>{3e-6, 5e-6, 7e-6}));
  EXPECT_EQ(table.shares, (std::vector<double>{1, 3, 1.5}));
  EXPECT_EQ(table.smallest, 3e-6);
  EXPECT_EQ(table.largest, 7e-6);
  EXPECT_EQ(read.powders[1].size.kind, SizeDistribution::Kind::lognormal);
  EXPECT_EQ(read.powders[1].size.geometric_deviation, 1.3);
  EXPECT_EQ(read.contact.normal, "jkr");
  EXPECT_EQ(read.contact.rolling, "elastic_plastic");
  EXPECT_EQ(read.contact.friction_limit, "total");
}

TEST(CaseReader, ReadsWallsAndMotionsOfAFullCase) {
  const Case read = read_case_text(full_case, "/cases/die/die.toml");
  ASSERT_EQ(read.walls.size(), 3u);
  EXPECT_EQ(read.walls[0].shape, Wall::Shape::plane);
  EXPECT_EQ(read.walls[0].normal, (Vec3{0, 0, 1}));
  EXPECT_TRUE(read.walls[0].motions.empty());
  EXPECT_EQ(read.walls[1].shape, Wall::Shape::box);
  EXPECT_EQ(read.walls[1].material, 1u);
  EXPECT_EQ(read.walls[1].region.max, (Vec3{2e-3, 2e-3, 4e-3}));
  EXPECT_EQ(read.walls[1].open, std::vector<std::string>{"+z"});
  EXPECT_EQ(read.walls[1].motions, std::vector<std::size_t>{0});
  EXPECT_EQ(read.walls[2].region.shape, Region::Shape::cylinder);
  EXPECT_EQ(read.walls[2].region.axis, (Vec3{0, 0, 1}));
  EXPECT_EQ(read.walls[2].region.radius, 1e-3);
  ASSERT_EQ(read.motions.size(), 1u);
  const double angular = 2 * std::numbers::pi * 10;
  const auto& sine = std::get<motions::Sine>(read.motions[0].motion.kind);
  EXPECT_DOUBLE_EQ(sine.wave.amplitude, 15 / (angular * angular));
  EXPECT_EQ(sine.wave.phase, 0.25);
  EXPECT_DOUBLE_EQ(sine.direction.x, 0.6);
  EXPECT_DOUBLE_EQ(sine.direction.z, 0.8);
}

TEST(CaseReader, ReadsSourcesPhasesAndChoicesOfAFullCase) {
  const Case read = read_case_text(full_case, "/cases/die/die.toml");
  ASSERT_EQ(read.sources.size(), 3u);
  EXPECT_EQ(read.sources[0].kind, Source::Kind::rain);
  EXPECT_EQ(read.sources[0].mass_rate, 2e-3);
  EXPECT_EQ(read.sources[0].target.mass, 20e-6);
  EXPECT_FALSE(read.sources[0].sieve_pitch || read.sources[0].sieve_opening);
  EXPECT_EQ(read.sources[0].velocity.z, -0.2);
  EXPECT_EQ(read.sources[1].powder, 1u);
  EXPECT_EQ(read.sources[1].target.count, 1000u);
  EXPECT_EQ(read.sources[1].region.shape, Region::Shape::cylinder);
  EXPECT_EQ(read.sources[2].path, "/cases/die/beds/old.dump");
  ASSERT_EQ(read.phases.size(), 3u);
  EXPECT_EQ(read.phases[0].until, Phase::Until::inserted);
  EXPECT_EQ(read.phases[0].time_limit, 60.0);
  EXPECT_TRUE(read.phases[0].limit_is_error);
  EXPECT_EQ(read.phases[1].kinetic_energy, 1e-15);
  EXPECT_EQ(read.phases[1].at_least, 10e-3);
  EXPECT_FALSE(read.phases[1].limit_is_error);
  EXPECT_EQ(read.phases[2].cycles, 5.0);
  EXPECT_EQ(read.phases[2].motions, std::vector<std::size_t>{0});
  EXPECT_EQ(read.time.step, 1e-6);
  EXPECT_EQ(read.time.characteristic_speed, 0.5);
  EXPECT_EQ(read.measures.die, 1u);
  EXPECT_EQ(read.measures.cell_diameters, 3.5);
  EXPECT_EQ(read.output.interval, 20e-3);
  EXPECT_FALSE(read.output.picture);
}

TEST(CaseReader, ReadsARainOutOfACylinderThroughASieve) {
  const std::string box =
      R"({ shape = "box", min = ["0 mm", "0 mm", "6 mm"], max = ["2 mm", "2 mm", "7 mm"] })";
  const std::string tube =
      R"({ shape = "cylinder", base = ["1 mm", "1 mm", "6 mm"], radius = "1 mm", height = "1 mm" })";
  const std::string sieve = "sieve_pitch = \"0.8 mm\"\nsieve_opening = \"500 um\"";
  const Case read = read_case_text(with(full_case, box, tube + "\n" + sieve), "die.toml");
  EXPECT_EQ(read.sources[0].region.shape, Region::Shape::cylinder);
  EXPECT_EQ(read.sources[0].region.radius, 1e-3);
  EXPECT_EQ(read.sources[0].sieve_pitch, 0.8e-3);
  EXPECT_EQ(read.sources[0].sieve_opening, 0.5e-3);
}

TEST(CaseReader, MeasuresTheOnlyWallWithAnInsideByDefault) {
  std::string text = minimal_case;
  text += R"([walls.floor]
shape = "plane"
material = "molybdenum"
point = ["0 m", "0 m", "0 m"]
[walls.die]
shape = "box"
min = ["0 mm", "0 mm", "0 mm"]
max = ["1 mm", "1 mm", "1 mm"]
material = "molybdenum"
)";
  EXPECT_EQ(read_case_text(text, "die.toml").measures.die, 1u);
  text += R"([measures.region]
min = ["0 mm", "0 mm", "0 mm"]
max = ["1 mm", "1 mm", "1 mm"]
)";
  const Case read = read_case_text(text, "die.toml");
  EXPECT_FALSE(read.measures.die);
  ASSERT_TRUE(read.measures.region);
  EXPECT_EQ(read.measures.region->max.x, 1e-3);
}

TEST(CaseReader, ReadsCarriageReturnsAndAByteOrderMark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char* c = minimal_case; *c != '\0'; ++c) text += *c == '\n' ? "\r\n" : std::string(1, *c);
  EXPECT_EQ(read_case_text(text, "die.toml").powders[0].size.diameter, 4.6e-6);
}

TEST(CaseReader, ReadsAFileAndSaysWhyItCannot) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "pulvis-case-reader-test";
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "die.toml";
  std::ofstream(file) << minimal_case;
  EXPECT_EQ(read_case(file.string()).materials[0].name, "molybdenum");
  for (const std::filesystem::path& wrong : {folder, folder / "nothing.toml"}) {
    try {
      read_case(wrong.string());
      FAIL() << wrong;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::bad_input) << failure.what();
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(CaseReader, TellsWhereEachValueComesFrom) {
  const auto keys = read_case_text(minimal_case, "die.toml", {{"powders.mo.coarse_graining", "50"}}).keys;
  const auto find = [&](const std::string& key) {
    const auto found =
        std::find_if(keys.begin(), keys.end(), [&](const ResolvedKey& k) { return k.key == key; });
    return found == keys.end() ? ResolvedKey{"missing", "", "", ""} : *found;
  };
  EXPECT_EQ(find("materials.molybdenum.density").value, "\"10.2 g/cm^3\"");
  EXPECT_EQ(find("materials.molybdenum.density").meaning, "10200");
  EXPECT_EQ(find("phases[0].until").meaning, "time");
  EXPECT_EQ(find("materials.molybdenum.density").origin, "die.toml:6");
  EXPECT_EQ(find("materials.molybdenum.surface_energy").origin, "default");
  EXPECT_EQ(find("powders.mo.coarse_graining").value, "50");
  EXPECT_EQ(find("powders.mo.coarse_graining").origin, "--set powders.mo.coarse_graining");
  EXPECT_EQ(find("powders.mo.size.diameter").origin, "die.toml:14");
  EXPECT_EQ(find("phases[0].until").value, "\"time\"");
  EXPECT_EQ(find("gravity.acceleration").origin, "default");
  EXPECT_EQ(find("measures.region.shape").key, "missing");  // no region is given, so it has no shape
}

}  // namespace
}  // namespace pulvis
