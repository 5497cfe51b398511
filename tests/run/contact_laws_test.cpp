// SPDX-License-Identifier: Apache-2.0
// Every contact law from its keys to the engine, and what is said where a law cannot be used.
#include <gtest/gtest.h>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"
#include "engine/laws/catalogue.hpp"
#include "run/assemble.hpp"
#include "tests/run/small_die.hpp"

using namespace pulvis;
using namespace pulvis::tests;

namespace {

using Keys = std::vector<Override>;

/// The numbers a part needs besides the materials', as written in a case.
Keys numbers_of(const std::string& part) {
  if (part == "hooke") return {{"contact.characteristic_speed", "\"0.1 m/s\""}};
  if (part == "luding")
    return {{"contact.normal_stiffness", "\"10 N/m\""},
            {"contact.plastic_ratio", "5"},
            {"contact.adhesion_ratio", "0.5"},
            {"contact.plasticity_depth", "0.05"}};
  if (part == "edinburgh") return {{"contact.unloading_ratio", "5"}, {"contact.constant_pull", "\"1 nN\""}};
  if (part.starts_with("sjkr")) return {{"contact.cohesion_energy_density", "\"5 kJ/m^3\""}};
  if (part.starts_with("capillary"))
    return {{"contact.surface_tension", "\"72 mN/m\""},
            {"contact.liquid_content", "1e-3"},
            {"contact.contact_angle", "\"10 deg\""},
            {"contact.liquid_viscosity", "\"1 mPa s\""}};
  if (part == "hamaker")
    return {{"contact.hamaker_constant", "\"1e-19 J\""},
            {"contact.shortest_gap", "\"0.4 nm\""},
            {"contact.longest_gap", "\"40 nm\""}};
  return {};
}

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
