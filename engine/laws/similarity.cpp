// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "engine/laws/catalogue.hpp"
#include "engine/math/functions.hpp"

namespace pulvis::laws {
namespace {

/// alpha^power, exactly for whole powers of small whole numbers.
double grown(double alpha, double power_of_alpha) {
  double product = 1.0;
  for (; power_of_alpha >= 1.0; power_of_alpha -= 1.0) product *= alpha;
  return power_of_alpha == 0.0 ? product : product * power(alpha, power_of_alpha);
}

}  // namespace

MaterialPair Law::for_parcels(const MaterialPair& grains, double alpha, Similarity similarity) const {
  MaterialPair parcels = grains;
  if (similarity == Similarity::none) return parcels;
  for (const PartEntry* part : parts())
    for (const Parameter& p : part->parameters)
      parcels.*p.value = grains.*p.value * grown(alpha, p.growth(similarity));
  return parcels;
}

std::string Law::why_not(Similarity similarity) const {
  if (similarity != Similarity::bond) return {};
  for (const PartEntry* part : parts())
    for (const Parameter& p : part->parameters)
      if (!p.pull_off.has_rule())
        return "the pull-off force of \"" + std::string(part->name) + "\" is no power of its " + p.name;
  if (cohesion->acts && !cohesion->has_pull_off && normal->name != "hertz")
    return "\"" + std::string(cohesion->name) + "\" has a pull-off force with the normal law \"hertz\" only";
  return {};
}

}  // namespace pulvis::laws
