// SPDX-License-Identifier: Apache-2.0
#include "case/keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "case/checker.hpp"
#include "case/overrides.hpp"
#include "case/reader.hpp"
#include "case/setting_reader.hpp"
#include "case/toml_source.hpp"

namespace pulvis {
namespace {

using namespace case_file;

TEST(KeyTable, DeclaresEachKeyOnceAndBelowItsTable) {
  std::set<std::string> tables{""}, seen;
  for (const Key& key : all_keys()) {
    EXPECT_TRUE(seen.insert(key.pattern).second) << key.pattern << " is declared twice";
    EXPECT_TRUE(tables.contains(parent_pattern(key.pattern))) << key.pattern << " stands in no table";
    if (is_table(key.kind)) tables.insert(element_pattern(key));
    EXPECT_FALSE(key.help.empty()) << key.pattern;
    EXPECT_EQ(key.example.empty(), is_table(key.kind)) << key.pattern;
  }
}

TEST(KeyTable, NamesOnlyWhatItDeclares) {
  for (const Key& key : all_keys()) {
    const auto beside = [&](const std::string& leaf) {
      const auto& keys = keys_in(parent_pattern(key.pattern));
      const auto found =
          std::find_if(keys.begin(), keys.end(), [&](const Key* k) { return leaf_of(k->pattern) == leaf; });
      return found == keys.end() ? nullptr : *found;
    };
    if (!key.partner.empty()) {
      ASSERT_NE(beside(key.partner), nullptr) << key.pattern;
      EXPECT_EQ(beside(key.partner)->partner, leaf_of(key.pattern));
    }
    if (!key.only_when.key.empty()) {
      const Key* state = beside(key.only_when.key);
      ASSERT_NE(state, nullptr) << key.pattern;
      EXPECT_TRUE(state->only_when.key.empty()) << key.pattern << ": conditions do not nest";
      for (const std::string& value : key.only_when.values)
        EXPECT_NE(std::find(state->choices.begin(), state->choices.end(), value), state->choices.end())
            << key.pattern;
    }
    const bool refers = key.kind == KeyKind::name || key.kind == KeyKind::names;
    EXPECT_EQ(refers, !key.refers_to.empty()) << key.pattern;
    const bool optional = key.presence == Presence::optional;
    EXPECT_TRUE(optional || key.standard.empty()) << key.pattern;
  }
}

TEST(KeyTable, GivesExamplesAndDefaultsThatFitTheirDeclaration) {
  KnownNames names;
  names.of_table["materials"] = {"molybdenum", "steel"};
  names.of_table["powders"] = {"mo"};
  names.of_table["walls"] = {"die", "gate"};
  names.of_table["motions"] = {"shaking"};
  names.of_table["sources"] = {"rain"};
  for (const Key& key : all_keys()) {
    for (const std::string& toml : {key.example, key.standard}) {
      if (toml.empty()) continue;
      ProblemList problems("table", "");
      const auto parsed = parse_toml("value = " + toml);
      ASSERT_TRUE(std::holds_alternative<Value>(parsed)) << key.pattern;
      Setting setting;
      setting.key = &key;
      setting.path = key.pattern;
      SettingReader(names, problems).read(std::get<Value>(parsed).entries.front().value, setting);
      EXPECT_TRUE(setting.valid) << key.pattern << " = " << toml;
    }
  }
}

TEST(Explain, KnowsEveryKeyOfTheTable) {
  for (const Key& key : all_keys()) {
    const std::string text = explain(key.pattern);
    EXPECT_EQ(text.find(key.pattern + "\n"), 0u) << text;
    EXPECT_NE(text.find(key.help), std::string::npos) << text;
  }
}

TEST(Explain, TakesPathsAsTheyStandInACase) {
  EXPECT_EQ(explain("materials.steel.density"), explain("materials.*.density"));
  EXPECT_EQ(explain("materials.density"), explain("materials.*.density"));
  EXPECT_EQ(explain("phases[2].cycles"), explain("phases[].cycles"));
  EXPECT_EQ(explain("phases.shake.cycles"), explain("phases[].cycles"));
  EXPECT_EQ(explain("young_modulus"), explain("materials.*.young_modulus"));
  EXPECT_EQ(explain("materials.steel"), explain("materials"));
  EXPECT_NE(explain("friction").find("pairs[].friction"), std::string::npos);
  EXPECT_NE(explain("materials").find("density"), std::string::npos);
  EXPECT_NE(explain("motions.*.amplitude").find("required, this or peak_acceleration"), std::string::npos);
}

TEST(Explain, NamesTheNearestKeyForAnUnknownOne) {
  const auto message = [](const std::string& key) -> std::string {
    try {
      return "found: " + explain(key);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::usage);
      return failure.what();
    }
  };
  EXPECT_NE(message("youngs_modulus").find("did you mean \"young_modulus\"?"), std::string::npos)
      << message("youngs_modulus");
  EXPECT_NE(message("materials.desity").find("did you mean \"materials.density\"?"), std::string::npos);
  EXPECT_NE(message("wals").find("did you mean \"walls\"?"), std::string::npos);
  EXPECT_NE(message("").find("the tables are"), std::string::npos);
  EXPECT_NE(message(std::string(100000, '.')).find("there is no key"), std::string::npos);
  EXPECT_NE(message("quite.different").find("the tables are"), std::string::npos);
}

TEST(Nearest, ForgivesSmallErrorsOnly) {
  EXPECT_EQ(nearest("desnity", {"density", "friction"}), "density");
  EXPECT_EQ(nearest("Density", {"density"}), "density");
  EXPECT_EQ(nearest("young-modulus", {"young_modulus"}), "young_modulus");
  EXPECT_EQ(nearest("mass", {"density", "friction"}), std::nullopt);
  EXPECT_EQ(nearest("ab", {"cd"}), std::nullopt);
}

}  // namespace
}  // namespace pulvis
