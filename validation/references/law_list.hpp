// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/laws/catalogue.hpp"

namespace pulvis::validation {

inline std::string name_of(const laws::Law& law) {
  std::string name;
  for (const laws::PartEntry* part : law.parts()) name += std::string(part->name) + " ";
  return name;
}

/// Every choice that changes a formula in at least two ways.
inline const laws::Choices choices_to_test[] = {
    {},
    {true, false, true, laws::CohesionLimit::with, true, true, 1.0},
    {false, true, false, laws::CohesionLimit::without, false, false, 2.0},
    {true, true, true, laws::CohesionLimit::shifted, true, true, 2.0},
};

/// Every part at least once: each normal law with each dashpot, each cohesion on the normal laws it belongs to,
/// and each sliding law with each rolling and twisting law.
inline const std::vector<laws::Law>& laws_to_test() {
  static const std::vector<laws::Law> list = [] {
    const laws::Catalogue& all = laws::catalogue();
    std::vector<laws::Law> found;
    for (const auto& normal : all.normal)
      for (const auto& damping : all.damping)
        found.push_back(laws::find_law(normal.name, damping.name, "total_spring", "elastic_plastic"));
    for (const auto& cohesion : all.cohesion)
      for (const char* normal : {"hertz", "hooke"})
        found.push_back(
            laws::find_law(normal, "restitution", "total_spring", "elastic_plastic", cohesion.name));
    for (const auto& sliding : all.sliding)
      for (const auto& rolling : all.rolling)
        for (const auto& twisting : all.twisting)
          for (const char* normal : {"hertz", "jkr"})
            found.push_back(
                laws::find_law(normal, "restitution", sliding.name, rolling.name, "none", twisting.name));
    found.push_back(laws::find_law("edinburgh", "restitution", "rescaled_spring", "elastic_plastic_viscous",
                                   "none", "elastic_plastic"));
    return found;
  }();
  return list;
}

}  // namespace pulvis::validation
