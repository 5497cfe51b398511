// SPDX-License-Identifier: Apache-2.0
#include "report/judgement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "report/judgement_parts.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

std::vector<std::pair<std::string, std::string>> in_words(const JudgementRules& r) {
  return {
      {"very uniform, fairly uniform, uneven, very uneven",
       fmt::format("standard deviation of the porosity between cells over 1 - mean porosity, below {}, {}, "
                   "{}, or more",
                   percent(r.very_uniform), percent(r.fairly_uniform), percent(r.uneven))},
      {"as dense as", fmt::format("densities (1 - porosity, below the surface) differ by less than {}",
                                  percent(r.same_density))},
      {"not compared", fmt::format("a part has less than {} of the volume", percent(r.enough_powder))},
      {"mass in the die changed", "by more than " + percent(r.same_mass) + " in the phase"},
      {"stayed as it was", fmt::format("density changed by less than {} in the phase", percent(r.changed))},
      {"lower third, upper third", "of the layers of cells without those at the floor and at the surface"},
      {"density from lower to upper third worth mending", "more than " + percent(r.worth_mending)},
      {"tilted", fmt::format("more than {:.2g} degrees", r.tilted * 180.0 / std::numbers::pi)},
      {"still moves", fmt::format("translational energy per parcel above {:.1g} m g d", r.moving)},
      {"only so many parcels across",
       fmt::format("fewer than {:.3g} mean diameters in the narrowest side", r.few_parcels)},
      {"overlaps", fmt::format("largest overlap above {} of the radius", percent(r.soft))},
      {"more mass would fill it", fmt::format("fill ratio below {}", percent(r.not_full))},
  };
}

}  // namespace

std::string percent(double share, int digits) { return number_text(100.0 * share, digits) + " %"; }

double change_in(const RunData& run, std::size_t k) {
  const double before = run.phases[k - 1].measure("porosity_mean"),
               after = run.phases[k].measure("porosity_mean");
  return density_ratio(after, before) - 1.0;
}

double mass_change_in(const RunData& run, std::size_t k) {
  const double ratio = run.phases[k].measure("fill_mass") / run.phases[k - 1].measure("fill_mass");
  return std::isfinite(ratio) ? ratio - 1.0 : 0.0;
}

void judge_changes(const RunData& run, const JudgementRules& rules, Judgement& j) {
  for (std::size_t k = 1; k < run.phases.size(); ++k) {
    const double change = change_in(run, k);
    if (!std::isfinite(change)) continue;
    const PhaseData &before = run.phases[k - 1], &after = run.phases[k];
    if (const double more = mass_change_in(run, k); std::abs(more) > rules.same_mass) {
      j.changes.push_back(fmt::format(
          "In \"{}\" the mass in the die changed by {:+.3g} %; densities before and after are not compared.",
          after.name, 100.0 * more));
      continue;
    }
    std::string text =
        std::abs(change) < rules.changed
            ? fmt::format("In \"{}\" the density stayed as it was ({:+.2g} %)", after.name, 100.0 * change)
            : fmt::format("In \"{}\" the powder became {} by {} (porosity {:.4g} to {:.4g})", after.name,
                          change > 0.0 ? "denser" : "looser", percent(std::abs(change)),
                          before.measure("porosity_mean"), after.measure("porosity_mean"));
    const double fall =
        after.measure("free_surface_height_mean") - before.measure("free_surface_height_mean");
    if (std::isfinite(fall) && fall != 0.0)
      text += fmt::format("; the surface {} by {}", fall < 0.0 ? "fell" : "rose",
                          value_text(std::abs(fall), "m", 2));
    const double scatter = after.measure("porosity_std") / before.measure("porosity_std");
    if (std::isfinite(scatter))
      text += fmt::format("; the scatter between cells changed by {}", percent_more(scatter));
    j.changes.push_back(text + ".");
  }
}

Judgement judge(const RunData& run, const JudgementRules& rules) {
  Judgement j;
  const PhaseData* last = run.last();
  if (!last) return j;
  judge_uniformity(*last, rules, j);
  judge_changes(run, rules, j);
  advise(run, *last, rules, j);
  j.rules = in_words(rules);
  return j;
}

}  // namespace pulvis::report
