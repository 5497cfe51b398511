// SPDX-License-Identifier: Apache-2.0
#include "run/energy_lines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/units.hpp"
#include "run/run_summary.hpp"

namespace pulvis {

std::vector<EnergyLine> energy_lines(const EnergyBalance& b) {
  using Term = kernels::EnergyTerm;
  using enum EnergyLine::Kind;
  std::vector<EnergyLine> list{{"translational", "kinetic, translational", now, b.translational},
                               {"rotational", "kinetic, rotational", now, b.rotational}};
  if (b.has_potential) list.push_back({"potential", "potential", now, b.potential});
  const auto terms = [&](std::initializer_list<EnergyLine> lines) {
    for (const EnergyLine& line : lines) list.push_back(line);
  };
  terms({{"elastic", "elastic, normal", now, b[Term::elastic]},
         {"cohesive", "cohesive", now, b[Term::cohesive]},
         {"sliding_springs", "elastic, sliding", now, b[Term::sliding_spring]},
         {"rolling_springs", "elastic, rolling", now, b[Term::rolling_spring]},
         {"twisting_springs", "elastic, twisting", now, b[Term::twisting_spring]},
         {"normal_dashpots", "normal dashpots", lost, b[Term::normal_dashpot]},
         {"tangential_dashpots", "tangential dashpots", lost, b[Term::tangential_dashpot]},
         {"sliding_friction", "sliding friction", lost, b[Term::sliding]},
         {"rolling_friction", "rolling friction", lost, b[Term::rolling]},
         {"rolling_dashpots", "rolling dashpots", lost, b[Term::rolling_dashpot]},
         {"twisting_friction", "twisting friction", lost, b[Term::twisting]},
         {"twisting_dashpots", "twisting dashpots", lost, b[Term::twisting_dashpot]},
         {"viscous_friction", "friction of laws without a spring", lost, b[Term::unsplit_friction]},
         {"liquid", "viscous liquid", lost, b[Term::liquid]},
         {"touch", "adhesion, at touch", lost, b[Term::touch]},
         {"separation", "adhesion, at separation", lost, b[Term::separation]},
         {"forgotten_springs", "springs of contacts that ended", lost, b[Term::forgotten_springs]}});
  if (!b.splits_contacts)
    terms(
        {{"normal_not_split", "work against normal contact forces, not split", lost, b[Term::unsplit_normal]},
         {"cohesion_not_split", "work against cohesion, not split", lost, b[Term::unsplit_cohesion]}});
  terms({{"walls", "work of walls", brought_in, b[Term::walls]},
         {"sliding_stiffness", "change of sliding stiffness", brought_in, b[Term::sliding_stiffness]},
         {"rolling_stiffness", "change of rolling and twisting stiffness", brought_in,
          b[Term::rolling_stiffness]},
         {"changed_contacts", "contacts that changed otherwise than by their law", brought_in,
          b[Term::changed_contacts]}});
  if (!b.has_potential) list.push_back({"body_forces", "work of body forces", brought_in, b.body_forces});
  terms({{"start", "at the start", total, b.start},
         {"inserted", "inserted", total, b.inserted},
         {"removed", "taken out", total, b.removed},
         {"lost", "lost in all", total, b.lost()},
         {"put_through", "put through", total, b.put_through()},
         {"closing_error", "closing error", total, b.closing_error()}});
  return list;
}

void warn_of_energy(const EnergyBalance& balance, RunSummary& summary) {
  if (std::abs(balance.closing_share()) <= 0.01) return;
  add_warning(summary,
              fmt::format("the ledger of energy does not close: {:.2g} % of the energy put through is "
                          "unaccounted for; lower time.fraction",
                          100 * balance.closing_share()));
}

std::string energy_text(const EnergyBalance& b) {
  const auto joule = [](double value) { return format_quantity(value, dimension::energy); };
  std::string text = fmt::format("  energy: {} put through, closing error {:.2g} of it",
                                 joule(b.put_through()), b.closing_share());
  const auto list = [&](const char* words, EnergyLine::Kind kind) {
    std::string lines;
    for (const EnergyLine& line : energy_lines(b))
      if (line.kind == kind && line.value != 0.0)
        lines += fmt::format("{}{} {}", lines.empty() ? "" : "; ", line.words, joule(line.value));
    if (!lines.empty()) text += fmt::format("\n    {}: {}", words, lines);
  };
  list("now", EnergyLine::Kind::now);
  list("lost", EnergyLine::Kind::lost);
  list("brought in", EnergyLine::Kind::brought_in);
  return text;
}

}  // namespace pulvis
