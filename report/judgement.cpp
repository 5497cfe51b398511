// SPDX-License-Identifier: Apache-2.0
#include "report/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string percent(double share, int digits = 2) { return number_text(100.0 * share, digits) + " %"; }

/// Mean porosity of a stretch of a profile, weighted by volume; NaN if there is none.
struct Stretch {
  double porosity = none, volume = 0.0;
};
template <class Inside>
Stretch stretch_of(const PorosityProfile& p, const Inside& inside) {
  double sum = 0.0, volume = 0.0;
  for (std::size_t k = 0; k < p.position.size(); ++k)
    if (std::isfinite(p.porosity[k]) && p.volume[k] > 0.0 && inside(k)) {
      sum += p.porosity[k] * p.volume[k];
      volume += p.volume[k];
    }
  return {volume > 0.0 ? sum / volume : none, volume};
}

/// The density of one part over that of another, from their porosities.
double density_ratio(double porosity, double other) { return (1.0 - porosity) / (1.0 - other); }

std::string compared(const std::string& one, const std::string& other, double ratio,
                     const JudgementRules& rules) {
  const double more = ratio - 1.0;
  if (std::abs(more) < rules.same_density)
    return fmt::format("{} and {} are equally dense (difference {}).", one, other, percent(std::abs(more)));
  return fmt::format("{} is {} {} than {}.", one, percent(std::abs(more)), more > 0.0 ? "denser" : "looser",
                     other);
}

/// A comparison of two parts, if both hold enough powder.
struct Difference {
  std::string sentence;
  double ratio = none;  ///< of the densities
};

Difference thirds(const MeasuresFile& m, const JudgementRules& rules) {
  const PorosityProfile* p = m.profile("third");
  if (!p || p->position.size() < 3) return {};
  std::size_t last = 0;
  bool any = false;
  for (std::size_t k = 0; k < p->position.size(); ++k)
    if (std::isfinite(p->porosity[k]) && p->volume[k] > 0.0) last = k, any = true;
  if (!any || last < 2) return {};
  const std::size_t third = (last + 1) / 3;
  const Stretch low = stretch_of(*p, [&](std::size_t k) { return k < third; });
  const Stretch high = stretch_of(*p, [&](std::size_t k) { return k > last - third && k <= last; });
  const double all = stretch_of(*p, [](std::size_t) { return true; }).volume;
  if (!(std::min(low.volume, high.volume) >= rules.enough_powder * all)) return {};
  const double ratio = density_ratio(low.porosity, high.porosity);
  return {compared("The lower third of the powder", "the upper third", ratio, rules), ratio};
}

Difference halves(const MeasuresFile& m, const std::string& one, const std::string& other,
                  const std::string& words, const std::string& other_words, const JudgementRules& rules) {
  const Part *a = m.part(one), *b = m.part(other);
  if (!a || !b || !std::isfinite(a->porosity) || !std::isfinite(b->porosity)) return {};
  if (!(std::min(a->volume, b->volume) >= rules.enough_powder * (a->volume + b->volume)))
    return {
        fmt::format("{} and {} are not compared: one of them holds hardly any powder.", words, other_words),
        none};
  const double ratio = density_ratio(a->porosity, b->porosity);
  return {compared(words, other_words, ratio, rules), ratio};
}

/// Slices at both ends of an axis against those between.
Difference beside_walls(const MeasuresFile& m, const std::string& axis, const JudgementRules& rules) {
  const PorosityProfile* p = m.profile(axis);
  if (!p || p->position.size() < 5) return {};
  const std::size_t last = p->position.size() - 1;
  const Stretch rim = stretch_of(*p, [&](std::size_t k) { return k == 0 || k == last; });
  const Stretch middle = stretch_of(*p, [&](std::size_t k) { return k > 1 && k + 1 < last; });
  if (!std::isfinite(rim.porosity) || !std::isfinite(middle.porosity)) return {};
  const double ratio = density_ratio(rim.porosity, middle.porosity);
  const double width = p->position[1] - p->position[0];
  return {compared(fmt::format("Beside the walls across the {} axis (the outermost {})", axis,
                               value_text(width, "m", 2)),
                   "the middle", ratio, rules),
          ratio};
}

/// How many parcels a cell holds: with few of them, part of the scatter is chance.
std::string chance_words(const PhaseData& phase, double porosity) {
  if (!phase.detail || !phase.detail->porosity || !(phase.detail->mean_diameter > 0.0)) return "";
  const auto& edge = phase.detail->porosity->spacing;
  const double parcel = std::numbers::pi / 6.0 * std::pow(phase.detail->mean_diameter, 3.0);
  return fmt::format(" A cell holds about {:.2g} parcels, so part of that scatter is chance.",
                     edge[0] * edge[1] * edge[2] * (1.0 - porosity) / parcel);
}

void judge_uniformity(const PhaseData& phase, const JudgementRules& rules, Judgement& j) {
  const double mean = phase.measure("porosity_mean"), scatter = phase.measure("porosity_std");
  if (std::isfinite(mean) && std::isfinite(scatter) && mean < 1.0) {
    const double relative = scatter / (1.0 - mean);
    const char* word = relative < rules.very_uniform     ? "very uniform"
                       : relative < rules.fairly_uniform ? "fairly uniform"
                       : relative < rules.uneven         ? "uneven"
                                                         : "very uneven";
    j.uniformity.push_back(fmt::format(
        "The powder is {}: its porosity is {:.4g} on average, and its density scatters by {} of the mean "
        "from cell to cell.{}",
        word, mean, percent(relative), chance_words(phase, mean)));
  }
  const auto add = [&](const Difference& d) {
    if (!d.sentence.empty()) j.uniformity.push_back(d.sentence);
  };
  if (phase.detail) {
    const MeasuresFile& m = *phase.detail;
    const Difference by_height = thirds(m, rules);
    add(by_height.sentence.empty()
            ? halves(m, "lower half", "upper half", "The lower half", "the upper half", rules)
            : by_height);
    add(halves(m, "first lower half", "first upper half", "The half at low values of the first axis",
               "the half at high values", rules));
    add(halves(m, "second lower half", "second upper half", "The half at low values of the second axis",
               "the half at high values", rules));
    add(beside_walls(m, "first", rules));
    add(beside_walls(m, "second", rules));
  }
  const double tilt = phase.measure("free_surface_tilt"), rough = phase.measure("free_surface_roughness");
  if (std::isfinite(tilt))
    j.uniformity.push_back(
        fmt::format("The surface is {} ({:.2g} degrees){}.", tilt > rules.tilted ? "tilted" : "level",
                    tilt * 180.0 / std::numbers::pi,
                    std::isfinite(rough) ? ", its roughness " + value_text(rough, "m", 2) : ""));
}

void judge_parts(const PhaseData& phase, Judgement& j) {
  if (!phase.detail) return;
  constexpr std::size_t halves_of_the_die = 6;  // the case's own parts come after them
  const auto& parts = phase.detail->parts;
  for (std::size_t k = std::min(halves_of_the_die, parts.size()); k < parts.size(); ++k) {
    const double mean = phase.measure("porosity_mean");
    if (std::isfinite(parts[k].porosity) && std::isfinite(mean))
      j.uniformity.push_back(fmt::format(
          "The part \"{}\" has a porosity of {:.4g}: {} in density against the whole.", parts[k].name,
          parts[k].porosity, percent_more(density_ratio(parts[k].porosity, mean))));
  }
}

bool has_motion(const RunData& run, const std::string& phase) {
  if (!run.the_case) return false;
  for (const Phase& p : run.the_case->phases)
    if (p.name == phase) return !p.motions.empty();
  return false;
}

/// How much the density changed in a phase, as a share; NaN if it is not known.
double change_in(const RunData& run, std::size_t k) {
  const double before = run.phases[k - 1].measure("porosity_mean"),
               after = run.phases[k].measure("porosity_mean");
  return density_ratio(after, before) - 1.0;
}

void judge_changes(const RunData& run, const JudgementRules& rules, Judgement& j) {
  for (std::size_t k = 1; k < run.phases.size(); ++k) {
    const double change = change_in(run, k);
    if (!std::isfinite(change)) continue;
    const PhaseData &before = run.phases[k - 1], &after = run.phases[k];
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
    if (!std::isfinite(change)) return;
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

void advise(const RunData& run, const PhaseData& phase, const JudgementRules& rules, Judgement& j) {
  if (!run.ended)
    j.to_try.push_back("The run has not ended: let it go on (pulvis run ... --resume) before judging.");
  const double diameter = parcel_diameter(run, phase);
  const double count = phase.measure("fill_count"), mass = phase.measure("fill_mass");
  const double moving = phase.measure("kinetic_energy_translational") / count;
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

std::vector<std::pair<std::string, std::string>> in_words(const JudgementRules& r) {
  return {
      {"very uniform, fairly uniform, uneven, very uneven",
       fmt::format("standard deviation of the porosity between cells over 1 - mean porosity, below {}, {}, "
                   "{}, or more",
                   percent(r.very_uniform), percent(r.fairly_uniform), percent(r.uneven))},
      {"equally dense", fmt::format("densities (1 - porosity, below the surface) differ by less than {}",
                                    percent(r.same_density))},
      {"not compared", fmt::format("a part has less than {} of the volume", percent(r.enough_powder))},
      {"stayed as it was", fmt::format("density changed by less than {} in the phase", percent(r.changed))},
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

Judgement judge(const RunData& run, const JudgementRules& rules) {
  Judgement j;
  const PhaseData* last = run.last();
  if (!last) return j;
  judge_uniformity(*last, rules, j);
  judge_parts(*last, j);
  judge_changes(run, rules, j);
  advise(run, *last, rules, j);
  j.rules = in_words(rules);
  return j;
}

}  // namespace pulvis::report
