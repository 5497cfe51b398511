// SPDX-License-Identifier: Apache-2.0
// Every contact law from its keys to the engine, and what is said where a law cannot be used.
#include <gtest/gtest.h>

#include "case/keys.hpp"
#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "engine/laws/catalogue.hpp"
#include "run/assemble.hpp"
#include "run/pair_law.hpp"
#include "tests/run/law_keys.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

Assembly assembled(Keys keys) { return assemble(read_case_text(small_die, "case.toml", keys)); }

Keys law(const std::string& normal, const std::string& cohesion) {
  Keys keys = {{"contact.normal", "\"" + normal + "\""}, {"contact.cohesion", "\"" + cohesion + "\""}};
  for (const std::string& part : {normal, cohesion})
    for (const Override& o : numbers_of(part)) keys.push_back(o);
  return keys;
}

std::string refusal(const Keys& keys) {
  try {
    assembled(keys);
  } catch (const Failure& f) {
    return f.what();
  }
  return "accepted";
}

TEST(ContactLaws, OfTheCatalogueAreThoseOfTheCase) {
  for (const auto& normal : laws::catalogue().normal)
    EXPECT_NO_THROW(assembled(law(std::string(normal.name), "none"))) << normal.name;
  for (const auto& cohesion : laws::catalogue().cohesion)
    EXPECT_NO_THROW(assembled(law("hertz", std::string(cohesion.name)))) << cohesion.name;
  for (const auto& sliding : laws::catalogue().sliding)
    EXPECT_NO_THROW(assembled({{"contact.sliding", "\"" + std::string(sliding.name) + "\""}}));
  for (const auto& rolling : laws::catalogue().rolling)
    EXPECT_NO_THROW(assembled({{"contact.rolling", "\"" + std::string(rolling.name) + "\""}}));
  EXPECT_NO_THROW(
      assembled({{"contact.twisting", "\"elastic_plastic\""}, {"contact.twisting_friction", "0.1"}}));
}

TEST(ContactLaws, WithoutANumberTheyNeedAreRefusedWithItsKey) {
  EXPECT_NE(refusal({{"contact.cohesion", "\"sjkr\""}, {"contact.normal", "\"hertz\""}})
                .find("cohesion_energy_density"),
            std::string::npos);
  EXPECT_NE(refusal({{"contact.normal", "\"hooke\""}}).find("characteristic_speed"), std::string::npos);
  EXPECT_NE(refusal({{"contact.normal", "\"luding\""}}).find("plastic_ratio"), std::string::npos);
}

/// The same with one number set anew.
Keys with_number(Keys keys, const std::string& key, const std::string& value) {
  std::erase_if(keys, [&](const Override& o) { return o.key == key; });
  keys.push_back({key, value});
  return keys;
}

std::string written(double value, const std::string& unit) {
  return unit == "-" ? fmt::format("{:.6g}", value) : fmt::format("\"{:.6g} {}\"", value, unit);
}

/// Where a case gives a property of the law; empty for what follows from Young's moduli.
std::string key_of(const std::string& parameter) {
  if (parameter == "friction" || parameter == "rolling_friction" || parameter == "restitution")
    return "materials.glass." + parameter;
  if (parameter == "work_of_adhesion") return "materials.glass.surface_energy";
  if (parameter == "effective_modulus") return "materials.glass.young_modulus";
  return "contact." + parameter;
}

TEST(ContactLaws, RefuseEveryParameterOutOfItsRange) {
  std::size_t refused = 0;
  for (const auto& [kind, part] : parts_of_catalogue())
    for (const laws::Parameter& p : part->parameters) {
      const std::string key = key_of(p.name);
      const Keys sound = with_part(kind, std::string(part->name));
      ASSERT_NO_THROW(assembled(sound)) << part->name;
      // The pull is negative in the law and positive in a case.
      const bool turned = std::string(p.name) == "constant_pull";
      const double low = turned ? 0.0 : p.lowest, high = turned ? -p.lowest : p.highest;
      for (const double value : {low > 0.0 ? 0.5 * low : -1.0, 30.0 * high}) {
        const std::string said = refusal(with_number(sound, key, written(value, p.unit)));
        const bool named = said.find(p.name) != std::string::npos || said.find(key) != std::string::npos;
        EXPECT_TRUE(named) << part->name << ": " << key << " = " << value << " " << p.unit << ": " << said;
        ++refused;
      }
    }
  EXPECT_GT(refused, 60u);
}

TEST(ContactLaws, WithoutANumberTheyNeedAreRefusedAllOfThem) {
  std::size_t needed = 0;
  for (const auto& [kind, part] : parts_of_catalogue()) {
    const Keys sound = with_part(kind, std::string(part->name));
    for (const laws::Parameter& p : part->parameters) {
      const std::string key = key_of(p.name);
      const auto* row = case_file::find_key("contact", p.name);
      if (row == nullptr || row->presence != case_file::Presence::required) continue;
      Keys bare = sound;
      ASSERT_EQ(std::erase_if(bare, [&](const Override& o) { return o.key == key; }), 1u) << key;
      EXPECT_NE(refusal(bare).find(key + " is missing"), std::string::npos) << part->name << ": " << key;
      ++needed;
    }
  }
  EXPECT_EQ(needed, 19u) << "luding 3, edinburgh 1, sjkr 3, bridges 8, hamaker 3, twisting 1";
}

TEST(ContactLaws, OfEdinburghHaveExponentsThatExist) {
  const Keys sound = law("edinburgh", "none");
  EXPECT_NO_THROW(assembled(with_number(sound, "contact.adhesion_exponent", "2")));
  EXPECT_NE(refusal(with_number(sound, "contact.loading_exponent", "1.2")).find("1 or 1.5"),
            std::string::npos);
  EXPECT_NE(refusal(with_number(sound, "contact.adhesion_exponent", "1.7")).find("1, 1.5 or 2"),
            std::string::npos);
}

/// The small die with a table [[pairs]] for beads at the wall.
std::string with_pair(const std::string& line) {
  return with(small_die, "[contact]",
              "[[pairs]]\nmaterials = [\"steel\", \"glass\"]\n" + line + "\n\n[contact]");
}

TEST(ContactLaws, LetAPairHaveItsOwnOfEveryNumber) {
  std::size_t found = 0;
  for (const auto& [kind, part] : parts_of_catalogue())
    for (const laws::Parameter& p : part->parameters) {
      const auto* row = case_file::find_key("contact", p.name);
      if (row == nullptr) continue;
      ++found;
      const Keys keys = with_part(kind, std::string(part->name));
      const auto pairs = [&](const std::string& text, const Keys& settings) {
        return assemble(read_case_text(text, "case.toml", settings)).pairs;
      };
      const auto all = pairs(small_die, with_number(keys, "contact." + std::string(p.name), row->example));
      const auto usual = pairs(small_die, keys);
      const auto own = pairs(with_pair(std::string(p.name) + " = " + row->example), keys);
      EXPECT_EQ(own[0].real.*p.value, usual[0].real.*p.value) << part->name << " " << p.name;
      EXPECT_EQ(own[1].real.*p.value, all[1].real.*p.value) << part->name << " " << p.name;
      EXPECT_EQ(own[1].simulated.*p.value, all[1].simulated.*p.value) << part->name << " " << p.name;
    }
  EXPECT_GT(found, 30u);
}

TEST(ContactLaws, OfAPairTakeItsOwnSpeedBeforeTheStiffnessOfAll) {
  const Keys keys = {{"contact.normal", "\"hooke\""}, {"contact.normal_stiffness", "\"10 N/m\""}};
  const Assembly a =
      assemble(read_case_text(with_pair("characteristic_speed = \"0.3 m/s\""), "case.toml", keys));
  EXPECT_EQ(a.pairs[0].real.normal_stiffness, 10.0);
  EXPECT_EQ(a.pairs[1].real.normal_stiffness, 0.0);
  EXPECT_EQ(a.pairs[1].real.characteristic_speed, 0.3);
}

TEST(ContactLaws, RefuseANumberOfAPairThatTheLawDoesNotAskFor) {
  const std::string text = with_pair("hamaker_constant = \"1e-19 J\"");
  try {
    read_case_text(text, "case.toml");
    ADD_FAILURE() << "accepted";
  } catch (const Failure& f) {
    for (const char* part :
         {"pairs[0].hamaker_constant has no meaning", "contact.cohesion is \"none\"", "\"hamaker\""})
      EXPECT_TRUE(has(f.what(), part)) << part << " is not in\n" << f.what();
  }
}

TEST(ContactLaws, WithoutCohesionBetweenAPairLeaveItWithThePlainLaw) {
  const auto law_at_wall = [&](const Keys& keys, const std::string& line) {
    const Assembly a = assemble(read_case_text(with_pair(line), "case.toml", keys));
    EXPECT_EQ(a.model.classes.all()[a.model.classes.index(0, 0)].law.cohesion->name,
              named_law(read_case_text(small_die, "case.toml", keys).contact).cohesion->name);
    return a.model.classes.all()[a.model.classes.index(0, 1)].law;
  };
  EXPECT_EQ(law_at_wall(law("hertz", "capillary_soulie"), "surface_tension = \"0 N/m\"").cohesion->name,
            "none");
  EXPECT_EQ(law_at_wall(law("hertz", "hamaker"), "hamaker_constant = \"0 J\"").cohesion->name, "none");
  EXPECT_EQ(law_at_wall(law("hertz", "sjkr"), "cohesion_energy_density = \"0 Pa\"").cohesion->name, "none");
  EXPECT_EQ(law_at_wall(law("hertz", "dmt"), "work_of_adhesion = \"0 J/m^2\"").cohesion->name, "none");
  EXPECT_EQ(law_at_wall(law("jkr", "none"), "work_of_adhesion = \"0 J/m^2\"").normal->name, "hertz");
}

TEST(ContactLaws, ThatDoNotGoTogetherAreRefused) {
  EXPECT_NE(refusal(law("jkr", "sjkr")).find("adhesion of its own"), std::string::npos);
  Keys viscous = {{"contact.sliding", "\"viscous\""}, {"contact.damping", "\"none\""}};
  EXPECT_NE(refusal(viscous).find("viscous"), std::string::npos);
}

TEST(ContactLaws, OfParcelsAreThoseOfGrainsByStressSimilarity) {
  // small_die has coarse_graining = 10.
  const auto real_and_simulated = [](const Keys& keys) {
    const Assembly a = assembled(keys);
    return std::pair{a.pairs.front().real, a.pairs.front().simulated};
  };
  const auto [wet, wet_parcels] = real_and_simulated(law("hertz", "capillary_willett"));
  EXPECT_NEAR(wet.contact_angle, 0.17453292519943295, 1e-15);
  EXPECT_NEAR(wet_parcels.surface_tension, 10.0 * wet.surface_tension, 1e-15);
  EXPECT_NEAR(wet_parcels.liquid_viscosity, 10.0 * wet.liquid_viscosity, 1e-15);
  EXPECT_EQ(wet_parcels.liquid_content, wet.liquid_content);
  const auto [dry, dry_parcels] = real_and_simulated(law("hertz", "hamaker"));
  EXPECT_NEAR(dry_parcels.hamaker_constant, 1e3 * dry.hamaker_constant, 1e-30);
  EXPECT_NEAR(dry_parcels.shortest_gap, 10.0 * dry.shortest_gap, 1e-22);
}

}  // namespace
