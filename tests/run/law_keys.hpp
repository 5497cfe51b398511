// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "case/overrides.hpp"
#include "engine/laws/catalogue.hpp"

// Every part of the catalogue of laws as keys of a case.
namespace pulvis::tests {

using Keys = std::vector<Override>;

/// The numbers a part needs besides the materials', as written in a case.
inline Keys numbers_of(const std::string& part) {
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

/// The kind of part that a case names so: "normal", "cohesion"...
inline std::vector<std::pair<std::string, const laws::PartEntry*>> parts_of_catalogue() {
  const laws::Catalogue& all = laws::catalogue();
  std::vector<std::pair<std::string, const laws::PartEntry*>> parts;
  const auto add = [&](const char* kind, const auto& list) {
    for (const auto& entry : list) parts.emplace_back(kind, &entry);
  };
  add("normal", all.normal), add("cohesion", all.cohesion), add("damping", all.damping);
  add("sliding", all.sliding), add("rolling", all.rolling), add("twisting", all.twisting);
  return parts;
}

/// A case with this part, on Hertz where it is not the normal law, with all the numbers it needs.
inline Keys with_part(const std::string& kind, const std::string& part) {
  Keys keys;
  if (kind != "normal") keys.push_back({"contact.normal", "\"hertz\""});
  keys.push_back({"contact." + kind, "\"" + part + "\""});
  for (const Override& o : numbers_of(part)) keys.push_back(o);
  if (kind == "twisting" && part != "none") keys.push_back({"contact.twisting_friction", "0.1"});
  return keys;
}

}  // namespace pulvis::tests
