// SPDX-License-Identifier: Apache-2.0
#include "case/overrides.hpp"

#include <gtest/gtest.h>

#include "tests/case/sample_case.hpp"

namespace pulvis {
namespace {

using namespace tests;

Case with_set(const std::string& key, const std::string& value) {
  return read_case_text(full_case, "die.toml", {{key, value}});
}

TEST(Overrides, ReplaceValuesWithAndWithoutInnerQuotes) {
  EXPECT_EQ(with_set("powders.mo.coarse_graining", "30").powders[0].coarse_graining, 30.0);
  EXPECT_EQ(with_set("materials.steel.young_modulus", "200 GPa").materials[1].young_modulus, 200e9);
  EXPECT_EQ(with_set("materials.steel.young_modulus", "\"200 GPa\"").materials[1].young_modulus, 200e9);
  EXPECT_EQ(with_set("contact.normal", "hertz").contact.normal, "hertz");
  EXPECT_EQ(with_set("output.picture", "true").output.picture, true);
  EXPECT_EQ(with_set("title", "1979").title, "1979");
  EXPECT_EQ(with_set("gravity.acceleration", R"(["0 m/s^2", "0 m/s^2", "1 m/s^2"])").body_force.gravity.z,
            1.0);
  EXPECT_EQ(with_set("gravity.acceleration[2]", "1 m/s^2").body_force.gravity.z, 1.0);
}

TEST(Overrides, AddKeysAndTablesThatTheFileDoesNotHave) {
  EXPECT_EQ(with_set("materials.steel.surface_energy", "1e-4 J/m^2").materials[1].surface_energy, 1e-4);
  const Case read =
      read_case_text(minimal_case, "die.toml", {{"time.step", "2 us"}, {"powders.mo.size.diameter", "5 um"}});
  EXPECT_EQ(read.time.step, 2e-6);
  EXPECT_EQ(read.powders[0].size.diameter, 5e-6);
}

TEST(Overrides, AddressPhasesByNameAndByIndex) {
  EXPECT_EQ(with_set("phases.shake.cycles", "8").phases[2].cycles, 8.0);
  EXPECT_EQ(with_set("phases[2].cycles", "8").phases[2].cycles, 8.0);
  EXPECT_EQ(with_set("pairs[0].restitution", "0.7").pairs[0].restitution, 0.7);
}

TEST(Overrides, LetTheLastOneHold) {
  const Case read = read_case_text(full_case, "die.toml", {{"seed", "2"}, {"seed", "3"}});
  EXPECT_EQ(read.seed, 3u);
}

TEST(Overrides, AreCheckedLikeTheFile) {
  const std::string text = messages_of(full_case, {{"powders.mo.coarse_graining", "0.5"}});
  EXPECT_EQ(text,
            "--set powders.mo.coarse_graining: error: powders.mo.coarse_graining is out of range: 0.5\n"
            "     | powders.mo.coarse_graining=0.5\n"
            "     |                            ^^^ expected at least 1\n");
  const auto expect = [](const std::string& key, const std::string& value, const std::string& part) {
    const std::string all = messages_of(full_case, {{key, value}});
    EXPECT_NE(all.find("--set " + key + ": error: "), std::string::npos) << all;
    EXPECT_NE(all.find(part), std::string::npos) << all;
  };
  expect("powders.mo.coarse_grainin", "5", "did you mean \"coarse_graining\"?");
  expect("tim.step", "1 us", "unknown key tim");
  expect("materials.stel.density", "1 g/cm^3", "did you mean \"steel\"?");
  expect("phases.shak.cycles", "5", "did you mean \"shake\"?");
  expect("phases[3].cycles", "5", "phases has no element 3");
  expect("seed.x", "5", "seed is a whole number");
  expect("seed[0]", "5", "seed is a whole number");
  expect("title", "[1, 2]", "title is a list");
  expect("motions.shaking.amplitude", "1 mm", "is given beside peak_acceleration");
  expect("materials.steel.density", "", "does not start with a number");
  expect("materials.steel.density", "1\nseed = 4", "is not a density");
  for (const char* key :
       {"", ".", "a..b", "a[", "a[x]", "a[1", "[1]", "a[1]b", "a[-1]", "a[99999999999999999999999]"})
    expect(key, "1", "this addresses no key");
}

TEST(Overrides, PointIntoListsAndInlineTables) {
  const std::vector<Problem> problems =
      problems_of(full_case, {{"powders.mo.size", R"({ kind = "single", diameter = "5 uk" })"}});
  ASSERT_EQ(problems.size(), 1u);
  const std::string line = problems[0].source_line;
  EXPECT_EQ(line.substr(static_cast<std::size_t>(problems[0].column) - 1,
                        static_cast<std::size_t>(problems[0].length)),
            "\"5 uk\"");
}

}  // namespace
}  // namespace pulvis
