// SPDX-License-Identifier: Apache-2.0
#include "run/pair_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "run/pair_law.hpp"

namespace pulvis {
namespace {

constexpr double most_resting_overlap = 0.01, most_impact_overlap = 0.05;  // over the radius
constexpr double least_restitution = 0.9;                                  // shown over asked for
constexpr double most_restitution_of_steps = 0.05;  // shown in coarse and in fine steps

void add_overlap_warnings(double speed, const PairForecast& p, std::vector<std::string>& warnings) {
  const std::string pair = p.first + " / " + p.second;
  if (!p.holds) {
    warnings.push_back(
        fmt::format("{}: cohesion exceeds stiffness at any overlap: parcels that touch are drawn into each "
                    "other without end; raise simulated_modulus or the stiffness, or lower cohesion",
                    pair));
    return;
  }
  if (p.own_overlap > most_resting_overlap)
    warnings.push_back(
        fmt::format("{}: cohesion is too strong for the stiffness: under it alone parcels rest {:.2f} % of "
                    "the radius in each other (above 1 %): raise simulated_modulus",
                    pair, 100 * p.own_overlap));
  else if (p.resting_overlap > most_resting_overlap)
    warnings.push_back(
        fmt::format("{}: expected overlap at rest is {:.2f} % of the radius (above 1 %): raise "
                    "simulated_modulus",
                    pair, 100 * p.resting_overlap));
  if (p.impact_overlap > most_impact_overlap)
    warnings.push_back(
        fmt::format("{}: impacts at {:.3g} m/s overlap by {:.1f} % of the radius (above 5 %): "
                    "raise simulated_modulus",
                    pair, speed, 100 * p.impact_overlap));
}

void add_restitution_warning(double speed, const PairForecast& p, std::vector<std::string>& warnings) {
  if (!p.holds || p.restitution_shown > least_restitution * p.restitution) return;
  const std::string shown =
      fmt::format("{} / {}: restitution {:.3g} is asked for, and collisions at {:.3g} m/s show {:.3g}",
                  p.first, p.second, p.restitution, speed, p.restitution_shown);
  if (p.undamped_restitution == 0.0)
    warnings.push_back(shown + ": even without damping they stick, and no rebound is reachable");
  else if (p.undamped_restitution < p.restitution)
    warnings.push_back(shown + fmt::format("; cohesion or yielding makes more than {:.3g} unreachable",
                                           p.undamped_restitution));
  else
    warnings.push_back(shown + ": cohesion or yielding takes the rest; ask for more to get it");
}

/// Too few time steps per contact to show what the law would.
void add_step_warning(double speed, const PairForecast& p, std::vector<std::string>& warnings) {
  if (!p.holds || std::fabs(p.restitution_in_steps - p.restitution_shown) <= most_restitution_of_steps)
    return;
  warnings.push_back(
      fmt::format("{} / {}: at this time step collisions at {:.3g} m/s show a restitution of {:.3g}, in fine "
                  "steps {:.3g}: "
                  "lower time.fraction or time.step",
                  p.first, p.second, speed, p.restitution_in_steps, p.restitution_shown));
}

/// Whether the case says itself how strongly a pair of materials coheres.
bool states_cohesion(const Case& c, const Species& a, const Species& b) {
  const PairOverride* own = find_override(c, a.material, b.material);
  if (own == nullptr) return false;
  const auto states = [&](std::string_view name) {
    if (name == "work_of_adhesion") return own->work_of_adhesion.has_value();
    return std::any_of(own->numbers.begin(), own->numbers.end(),
                       [&](const auto& number) { return number.first == name; });
  };
  const auto names = cohesion_numbers(c.contact);
  return std::any_of(names.begin(), names.end(), states);
}

/// Surface energy that the law ignores, and pairs that stay out of a cohesion the others have.
void add_missing_cohesion(const Case& c, const Assembly& a, const std::vector<PairForecast>& pairs,
                          std::vector<std::string>& warnings) {
  const bool knows =
      c.contact.normal == "jkr" || c.contact.normal == "edinburgh" || c.contact.cohesion == "dmt";
  const char* part = c.contact.cohesion == "none" ? "normal" : "cohesion";
  const auto coheres = [](const PairForecast& p) { return p.coheres; };
  const bool any = std::any_of(pairs.begin(), pairs.end(), coheres);
  for (std::size_t k = 0; k < a.pairs.size(); ++k) {
    const Species &first = a.species[a.pairs[k].first], &second = a.species[a.pairs[k].second];
    const std::string pair = first.name + " / " + second.name;
    if (!knows && a.pairs[k].real.work_of_adhesion > 0.0)
      warnings.push_back(fmt::format("{} has surface energy, but contact.{} = \"{}\" knows no such adhesion",
                                     pair, part,
                                     c.contact.cohesion == "none" ? c.contact.normal : c.contact.cohesion));
    if (any && !pairs[k].coheres && !states_cohesion(c, first, second))
      warnings.push_back(
          fmt::format("{} does not adhere although other pairs do; if that is meant, say so in [[pairs]] "
                      "with materials = "
                      "[\"{}\", \"{}\"]",
                      pair, c.materials[first.material].name, c.materials[second.material].name));
  }
}

}  // namespace

std::vector<std::string> pair_warnings(const Case& c, const Assembly& a,
                                       const std::vector<PairForecast>& pairs) {
  std::vector<std::string> warnings;
  for (const PairForecast& p : pairs) {
    add_overlap_warnings(a.time_step.characteristic_speed, p, warnings);
    add_restitution_warning(a.time_step.characteristic_speed, p, warnings);
    add_step_warning(a.time_step.characteristic_speed, p, warnings);
  }
  add_missing_cohesion(c, a, pairs, warnings);
  return warnings;
}

}  // namespace pulvis
