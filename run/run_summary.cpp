// SPDX-License-Identifier: Apache-2.0
#include "run/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/units.hpp"
#include "output/progress.hpp"
#include "run/energy_lines.hpp"
#include "run/time_table.hpp"

namespace pulvis {

std::string text_of(const Escape& e) {
  return fmt::format("t = {:.6g} s, position ({:.5g}, {:.5g}, {:.5g}) m, speed {:.4g} m/s", e.time,
                     e.position.x, e.position.y, e.position.z, norm(e.velocity));
}

RunSummary not_ended(RunSummary summary) {
  summary.exit = Exit::unexpected;
  summary.reason = "the run has not ended, or it was killed";
  return summary;
}

void add_warning(RunSummary& summary, const std::string& text) {
  summary.warnings.push_back(text);
  fmt::print(stderr, "warning: {}\n", text);
}

void warn_of_overlap(double overlap, RunSummary& summary) {
  if (overlap <= 0.05) return;
  add_warning(summary,
              fmt::format("parcels overlapped each other or walls by up to {:.1f} % of their radius; "
                          "above 5 % a contact law of small overlaps is out of its range: raise "
                          "simulated_modulus",
                          100 * overlap));
}

void warn_of_escapes(const Case& c, const State& state, RunSummary& summary) {
  if (c.domain.escape_is_error || state.escapes.empty()) return;
  const Escape& first = state.escapes.front();
  add_warning(summary, fmt::format("{} parcel{} ({}) escaped; the first was parcel {} through {} at {}",
                                   state.ledger.escaped, state.ledger.escaped == 1 ? "" : "s",
                                   format_quantity(state.ledger.escaped_mass, dimension::mass), first.id,
                                   first.through, text_of(first)));
}

void print_summary(const Case& c, const std::string& folder, const RunSummary& summary,
                   const Simulation& simulation) {
  const TaskSeconds& times = simulation.times().seconds();
  fmt::print("{} after {} of simulated time ({} steps, {} parcels) in {}, {} particle-steps/s\n",
             summary.exit == Exit::ok ? "Completed" : "Ended",
             format_quantity(simulation.time(), dimension::time), simulation.state().step,
             simulation.state().parcels.size(), duration_text(times.total()),
             count_text(static_cast<double>(summary.particle_steps) / std::max(times.of_steps(), 1e-9)));
  for (const PhaseRecord& p : summary.phases) {
    fmt::print("  {:<12} {:>10} to {:>10}  ended by {}", p.name, format_quantity(p.start, dimension::time),
               format_quantity(p.end, dimension::time), p.ended_by);
    for (const Measure& m : p.measures)
      if (m.value && (m.name == "porosity_mean" || m.name == "coordination_mean"))
        fmt::print("  {} {:.4f}", m.name, *m.value);
      else if (m.value && m.name == "fill_mass")
        fmt::print("  {} {}", m.name, format_quantity(*m.value, dimension::mass));
    fmt::print("\n");
  }
  for (const Source& source : c.sources) {
    const auto k = static_cast<std::size_t>(&source - c.sources.data());
    const SourceState& state = simulation.state().sources[k];
    if (source.target.mass)
      fmt::print("  source {}: {} of {} asked for, difference {}\n", source.name,
                 format_quantity(state.mass, dimension::mass, 6),
                 format_quantity(*source.target.mass, dimension::mass, 6),
                 format_quantity(state.mass - *source.target.mass, dimension::mass));
  }
  const Ledger& l = simulation.state().ledger;
  fmt::print("  ledger: {} inserted = {} present + {} removed + {} escaped\n", l.inserted,
             simulation.state().parcels.size(), l.removed, l.escaped);
  if (const auto energy = simulation.energy()) fmt::print("{}\n", energy_text(*energy));
  fmt::print("{}", time_table(times));
  fmt::print("Results in {0}:\n  numbers   {0}/result.json, {0}/measures.csv, {0}/log.csv\n", folder);
  if (c.output.picture)
    fmt::print("  picture   {0}/picture.png{1}\n", folder,
               summary.phases.size() > 1 ? fmt::format(", {}/pictures/after-*.png", folder) : "");
  const bool die = c.measures.die || c.measures.region;
  fmt::print("  ParaView  {0}/parcels.pvd, {0}/walls.pvd{1}\n", folder,
             die ? fmt::format(", {0}/porosity.pvd, {0}/fields.pvd", folder) : "");
}

}  // namespace pulvis
