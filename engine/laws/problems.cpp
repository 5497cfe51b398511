// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "engine/laws/catalogue.hpp"

// What is wrong with a choice of parts and numbers, for `pulvis check` and for the reader of cases.
namespace pulvis::laws {
namespace {

std::string short_number(double x) {
  std::string text = std::to_string(x);
  if (magnitude(x) < 1e-3 || magnitude(x) >= 1e6) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", x);
    text = buffer;
  }
  if (text.find('.') != std::string::npos && text.find('e') == std::string::npos)
    text.erase(text.find_last_not_of('0') + 1);
  if (!text.empty() && text.back() == '.') text.pop_back();
  return text;
}

void check_ranges(const PartEntry& part, const MaterialPair& material, std::vector<std::string>& found) {
  for (const Parameter& p : part.parameters) {
    const double value = material.*p.value;
    if (value >= p.lowest && value <= p.highest) continue;
    found.push_back(std::string(p.name) + " = " + short_number(value) + " " + p.unit + " is outside of " +
                    short_number(p.lowest) + " to " + short_number(p.highest) + " " + p.unit +
                    ", where the part \"" + std::string(part.name) + "\" is valid");
  }
}

}  // namespace

std::vector<std::string> Law::problems(const MaterialPair& m, const Choices& choices) const {
  std::vector<std::string> found;
  for (const PartEntry* part : parts()) check_ranges(*part, m, found);
  const std::string own(normal->name), law(cohesion->name);
  if (normal->adhesive && cohesion->acts)
    found.push_back("the normal law \"" + own + "\" has adhesion of its own and takes no cohesion \"" + law +
                    "\"; use hertz or hooke with it");
  if ((own == "hooke" || own == "luding") && m.normal_stiffness == 0.0 && m.characteristic_speed == 0.0)
    found.push_back("the normal law \"" + own + "\" needs normal_stiffness or characteristic_speed");
  if (cohesion->acts && !cohesion->has_pull_off && choices.cohesion_limit == CohesionLimit::shifted)
    found.push_back("the friction limit \"shifted\" needs a pull-off force, which \"" + law +
                    "\" does not have; use without or with");
  if ((own == "luding" || own == "edinburgh") && choices.cohesion_limit == CohesionLimit::shifted)
    found.push_back("the friction limit \"shifted\" needs a pull-off force, which \"" + own +
                    "\" does not have; use without or with");
  if (law == "dmt" && own != "hertz")
    found.push_back("the cohesion \"dmt\" belongs to the normal law \"hertz\"");
  if (law == "hamaker" && m.longest_gap <= m.shortest_gap)
    found.push_back("longest_gap must be above shortest_gap");
  if (sliding->name == "viscous" && (damping->name == "none" || !choices.tangential_damping))
    found.push_back("the sliding law \"viscous\" takes its dashpot from the damping, and there is none");
  if (own == "edinburgh" && choices.adhesion_exponent != 1.0 && choices.adhesion_exponent != 1.5 &&
      choices.adhesion_exponent != 2.0)
    found.push_back("adhesion_exponent must be 1, 1.5 or 2");
  return found;
}

}  // namespace pulvis::laws
