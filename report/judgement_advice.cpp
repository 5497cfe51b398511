// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "report/judgement_parts.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool has_motion(const RunData& run, const std::string& phase) {
  if (!run.the_case) return false;
  for (const Phase& p : run.the_case->phases)
    if (p.name == phase) return !p.motions.empty();
  return false;
}

double narrowest_side(const RunData& run) {
  const auto die = run.die();
  if (!die || die->size.empty()) return none;
  return *std::min_element(die->size.begin(), die->size.end());
}

/// Mean diameter of the parcels, m; NaN if it is not known.
double parcel_diameter(const RunData& run, const PhaseData& phase) {
  if (phase.detail && std::isfinite(phase.detail->mean_diameter)) return phase.detail->mean_diameter;
  if (!run.the_case || run.the_case->powders.empty()) return none;
  const Powder& p = run.the_case->powders.front();
  return p.size.diameter > 0.0 ? p.size.diameter * p.coarse_graining : none;
}

void advise_on_shaking(const RunData& run, const JudgementRules& rules, Judgement& j) {
  for (std::size_t k = run.phases.size(); k-- > 1;) {
    if (!has_motion(run, run.phases[k].name)) continue;
    const double change = change_in(run, k);
    if (!std::isfinite(change) || std::abs(mass_change_in(run, k)) > rules.same_mass) return;
    if (change > rules.changed)
      j.to_try.push_back(
          fmt::format("\"{}\" still made the powder denser ({:+.2g} %): longer shaking may go on with it "
                      "(cycles or duration).",
                      run.phases[k].name, 100.0 * change));
    else if (change < -rules.changed)
      j.to_try.push_back(
          fmt::format("\"{}\" loosened the powder ({:+.2g} %): try gentler or shorter shaking.",
                      run.phases[k].name, 100.0 * change));
    else
      j.to_try.push_back(
          fmt::format("\"{}\" changed the density by {:+.2g} % only: try a larger peak acceleration or "
                      "another direction; more of "
                      "the same is unlikely to do more.",
                      run.phases[k].name, 100.0 * change));
    return;
  }
}

}  // namespace

void advise(const RunData& run, const PhaseData& phase, const JudgementRules& rules, Judgement& j) {
  if (!run.ended)
    j.to_try.push_back("The run has not ended: let it go on (pulvis run ... --resume) before judging.");
  const double diameter = parcel_diameter(run, phase);
  // Of all parcels, as a phase until "rest" asks; one that ended so need not be told.
  const double count = phase.measure("fill_count"), mass = phase.measure("fill_mass");
  const double moving =
      phase.ended_by == "rest" ? none : phase.measure("kinetic_energy_translational") / run.parcels;
  const double still = rules.moving * mass / count * 9.81 * diameter;
  if (std::isfinite(moving) && std::isfinite(still) && moving > still)
    j.to_try.push_back(
        fmt::format("The powder still moves at the end ({:.2g} of m g d per parcel): add a phase until "
                    "\"rest\" before measuring.",
                    rules.moving * moving / still));
  advise_on_shaking(run, rules, j);
  const double by_height = phase.detail ? thirds(*phase.detail, rules).ratio - 1.0 : none;
  if (std::isfinite(by_height) && std::abs(by_height) > rules.worth_mending)
    j.to_try.push_back(
        fmt::format("Density changes by {} from the lower to the upper third: try another fall height or "
                    "rate of filling, or filling in several layers.",
                    percent(std::abs(by_height))));
  const double tilt = phase.measure("free_surface_tilt");
  if (std::isfinite(tilt) && tilt > rules.tilted)
    j.to_try.push_back("The surface is tilted: look at how the source or the shoe covers the die.");
  const double ratio = phase.measure("fill_ratio");
  if (std::isfinite(ratio) && ratio < rules.not_full)
    j.to_try.push_back(
        fmt::format("The powder fills {} of the die: more mass would fill it.", percent(ratio, 3)));
  const double across = narrowest_side(run) / diameter;
  if (std::isfinite(across) && across < rules.few_parcels)
    j.to_try.push_back(
        fmt::format("Only {:.2g} parcels fit across the narrowest side: the layers beside the walls count "
                    "for much. A smaller coarse_graining shows whether that matters.",
                    across));
  if (run.largest_overlap > rules.soft)
    j.to_try.push_back(
        fmt::format("Parcels overlapped by up to {} of their radius: a larger simulated_modulus would be "
                    "safer.",
                    percent(run.largest_overlap)));
  j.to_try.push_back(
      "One run says nothing of chance: repeat it with other seeds (--set seed=2, 3, ...) and set the runs "
      "side by side with pulvis compare.");
}

}  // namespace pulvis::report
