// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/laws/catalogue.hpp"

namespace pulvis::testing {

inline std::string name_of(const laws::Law& law) {
  std::string name;
  for (const laws::PartEntry* part :
       {static_cast<const laws::PartEntry*>(law.normal), static_cast<const laws::PartEntry*>(law.damping),
        static_cast<const laws::PartEntry*>(law.sliding), static_cast<const laws::PartEntry*>(law.rolling)})
    name += std::string(part->name) + " ";
  return name;
}

/// Every normal law with every dashpot, and every sliding with every rolling law.
inline const std::vector<laws::Law>& laws_to_test() {
  static const std::vector<laws::Law> list = [] {
    const laws::Catalogue& all = laws::catalogue();
    std::vector<laws::Law> laws;
    for (const auto& normal : all.normal)
      for (const auto& damping : all.damping)
        laws.push_back({&normal, &damping, &all.sliding.front(), &all.rolling.front()});
    for (const auto& sliding : all.sliding)
      for (const auto& rolling : all.rolling)
        for (const char* normal : {"hertz", "jkr"}) {
          laws::Law law = laws::find_law(normal, "restitution", sliding.name, rolling.name);
          laws.push_back(law);
        }
    return laws;
  }();
  return list;
}

}  // namespace pulvis::testing
