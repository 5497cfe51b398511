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

std::string compared(const std::string& one, const std::string& other, double ratio,
                     const JudgementRules& rules) {
  const double more = ratio - 1.0;
  if (std::abs(more) < rules.same_density)
    return fmt::format("{} is as dense as {} (difference {}).", one, other, percent(std::abs(more)));
  return fmt::format("{} is {} {} than {}.", one, percent(std::abs(more)), more > 0.0 ? "denser" : "looser",
                     other);
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
  return {compared(fmt::format("Beside the walls across the {} axis (the outermost {}) the powder", axis,
                               value_text(width, "m", 2)),
                   "in the middle", ratio, rules),
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

}  // namespace

Difference thirds(const MeasuresFile& m, const JudgementRules& rules) {
  const PorosityProfile* p = m.profile("third");
  if (!p || p->position.size() < 3) return {};
  std::size_t last = 0;
  bool any = false;
  for (std::size_t k = 0; k < p->position.size(); ++k)
    if (std::isfinite(p->porosity[k]) && p->volume[k] > 0.0) last = k, any = true;
  if (!any || last < 4) return {};
  // The layers at the floor and at the surface are loose for reasons of their own.
  const std::size_t third = (last - 1) / 3;
  const Stretch low = stretch_of(*p, [&](std::size_t k) { return k >= 1 && k <= third; });
  const Stretch high = stretch_of(*p, [&](std::size_t k) { return k >= last - third && k < last; });
  const double all = stretch_of(*p, [](std::size_t) { return true; }).volume;
  if (!(std::min(low.volume, high.volume) >= rules.enough_powder * all)) return {};
  const double ratio = density_ratio(low.porosity, high.porosity);
  return {compared("The lower third of the powder", "the upper third", ratio, rules), ratio};
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
  judge_parts(phase, j);
}

}  // namespace pulvis::report
