// SPDX-License-Identifier: Apache-2.0
#include "run/procedure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/failure.hpp"
#include "measures/fill.hpp"
#include "run/assemble.hpp"
#include "run/body_pull.hpp"
#include "run/measuring.hpp"
#include "run/species.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_questions = 100;  // for criteria that must look at every parcel

std::uint64_t steps_for(double seconds, double dt) {
  constexpr double endless = 1e15;  // no run takes as many steps
  return static_cast<std::uint64_t>(std::llround(std::clamp(seconds / dt, 1.0, endless)));
}

/// Translational energy of all parcels, J. Spin about a contact's normal meets no resistance, so rotation may
/// never die out; it does not move powder.
double translational_energy(const Simulation& simulation) {
  return measures::energies(look_at(simulation).bodies, simulation.field().gravity).translational;
}

}  // namespace

Procedure::Procedure(const Case& c, Simulation& simulation) : case_(c), simulation_(simulation) {
  const Powder& powder = c.powders.front();
  const double d50 = SizeSampler(parcel_sizes(powder)).median_by_mass();
  const double mass = c.materials[powder.material].density * sphere_volume(0.5 * d50);
  const double g = std::max(norm(strongest_pull(c)), 1e-3);
  default_rest_energy_ = 1e-3 * mass * g * d50;
  time_to_fall_ = std::sqrt(2.0 * d50 / g);
  for (const Source& source : c.sources) expected_parcels_.push_back(expected_parcels(c, source));
  if (simulation_.state().step == 0 && !finished()) begin_phase();
}

double Procedure::phase_start() const {
  return static_cast<double>(simulation_.state().progress.phase_start) * simulation_.model().dt;
}

std::uint64_t Procedure::steps_in_phase() const {
  return simulation_.state().step - simulation_.state().progress.phase_start;
}

void Procedure::begin_phase() {
  simulation_.state().progress.phase_start = simulation_.state().step;
  const Walls& walls = simulation_.model().walls;
  for (std::size_t b = 0; b < walls.bodies.size(); ++b) {
    const auto belongs = [&](std::size_t w) { return case_.walls[w].body == walls.bodies[b].name; };
    simulation_.set_absent(b, std::any_of(phase().without.begin(), phase().without.end(), belongs));
  }
  for (const std::size_t s : phase().sources) simulation_.open_source(s);
  for (const std::size_t m : phase().motions) simulation_.start_motion(m);
}

void Procedure::end_phase() {
  for (const std::size_t s : phase().sources) simulation_.close_source(s);
  for (const std::size_t m : phase().motions) simulation_.stop_motion(m);
}

void Procedure::next_phase() {
  end_phase();
  ++simulation_.state().progress.phase;
  if (!finished()) begin_phase();
}

std::optional<std::uint64_t> Procedure::planned_steps(const Phase& p) const {
  const double dt = simulation_.model().dt;
  if (p.until == Phase::Until::time) return steps_for(p.duration, dt);
  if (p.until == Phase::Until::cycles)
    return steps_for(length_of_cycles(simulation_.model().motions[p.motions.front()], p.cycles).value(), dt);
  if (p.until == Phase::Until::motions) {
    double longest = 0.0;
    for (const std::size_t m : p.motions)
      longest = std::max(longest, duration(simulation_.model().motions[m]).value());
    return steps_for(longest + 0.5 * dt, dt);  // not before they have come to rest
  }
  return {};
}

bool Procedure::may_end_after_next_step() const {
  const Phase& p = phase();
  const std::uint64_t next = steps_in_phase() + 1;
  const double dt = simulation_.model().dt;
  if (p.time_limit > 0.0 && next >= steps_for(p.time_limit, dt)) return true;
  if (const auto planned = planned_steps(p)) return next >= *planned;
  if (static_cast<double>(next) * dt < p.at_least) return false;
  if (p.until != Phase::Until::inserted) return next % steps_between_questions == 0;
  return simulation_.a_source_is_due() || std::all_of(p.sources.begin(), p.sources.end(), [&](std::size_t s) {
           return simulation_.state().sources[s].done;
         });
}

bool Procedure::criterion_met(const Phase& p) const {
  const std::uint64_t steps = steps_in_phase();
  if (const auto planned = planned_steps(p)) return steps >= *planned;
  const double seconds = static_cast<double>(steps) * simulation_.model().dt;
  if (seconds < p.at_least) return false;
  if (p.until == Phase::Until::inserted)
    return std::all_of(p.sources.begin(), p.sources.end(),
                       [&](std::size_t s) { return simulation_.state().sources[s].done; });
  if (steps % steps_between_questions != 0) return false;
  if (p.until == Phase::Until::mass) {
    const auto fill = fill_of_die(case_, simulation_);
    return fill && fill->mass >= p.mass;
  }
  if (p.at_least == 0.0 && seconds < time_to_fall_) return false;
  const double limit = p.kinetic_energy.value_or(default_rest_energy_);
  return translational_energy(simulation_) <= limit * static_cast<double>(simulation_.state().parcels.size());
}

std::optional<std::string> Procedure::ended() const {
  const Phase& p = phase();
  if (criterion_met(p)) {
    switch (p.until) {
      case Phase::Until::time:
        return "time";
      case Phase::Until::inserted:
        return "inserted";
      case Phase::Until::mass:
        return "mass";
      case Phase::Until::cycles:
        return "cycles";
      case Phase::Until::motions:
        return "motions";
      case Phase::Until::rest:
        return "rest";
    }
  }
  if (p.time_limit <= 0.0 || steps_in_phase() < steps_for(p.time_limit, simulation_.model().dt)) return {};
  if (p.limit_is_error)
    throw Failure(Exit::physics,
                  fmt::format("phase {} reached its time limit of {:g} s before its end\n  raise "
                              "time_limit, or set at_limit = \"end\" to go on",
                              p.name, p.time_limit));
  return "time_limit";
}

std::optional<double> Procedure::phase_share() const {
  if (finished()) return 1.0;
  const Phase& p = phase();
  const auto steps = static_cast<double>(steps_in_phase());
  if (const auto planned = planned_steps(p)) return std::min(1.0, steps / static_cast<double>(*planned));
  if (p.until == Phase::Until::inserted && !p.sources.empty()) {
    double share = 1.0;
    for (const std::size_t k : p.sources) {
      const Target& target = case_.sources[k].target;
      const SourceState& s = simulation_.state().sources[k];
      if (target.count && *target.count > 0)
        share = std::min(share, static_cast<double>(s.count) / static_cast<double>(*target.count));
      else if (target.mass && *target.mass > 0.0)
        share = std::min(share, s.mass / *target.mass);
    }
    return share;
  }
  const double expected = expected_length(p);
  if (expected > 0.0) return std::min(0.99, steps * simulation_.model().dt / expected);
  return {};
}

double Procedure::expected_length(const Phase& p) const {
  if (const auto planned = planned_steps(p)) return static_cast<double>(*planned) * simulation_.model().dt;
  double rain = 0.0;
  for (const std::size_t k : p.sources) {
    const SourceModel& source = simulation_.model().sources[k];
    if (source.kind != SourceModel::Kind::rain || source.rate <= 0.0) continue;
    const double mean_mass = source.density * sphere_volume(0.5) * source.sizes->mean_cube();
    const double mass =
        source.target_mass.value_or(mean_mass * static_cast<double>(source.target_count.value_or(0)));
    rain = std::max(rain, mass / source.rate);
  }
  if (rain > 0.0 && p.until == Phase::Until::inserted) return std::max(rain, p.at_least);
  constexpr double usual_share_of_limit = 0.3;  // limits are set with room to spare
  return std::max(usual_share_of_limit * p.time_limit, p.at_least);
}

double Procedure::share() const {
  // Work grows with time and with the number of parcels: while powder rains, as the square of the share.
  double total = 0.0, done = 0.0, parcels = 1.0;
  for (std::size_t k = 0; k < case_.phases.size(); ++k) {
    const Phase& p = case_.phases[k];
    double added = 0.0;
    for (const std::size_t s : p.sources) added += expected_parcels_[s];
    const double length = expected_length(p);
    const auto work = [&](double share) { return length * share * (parcels + 0.5 * added * share); };
    total += work(1.0);
    if (k < simulation_.state().progress.phase) done += work(1.0);
    if (k == simulation_.state().progress.phase) done += work(phase_share().value_or(0.0));
    parcels += added;
  }
  return total > 0.0 ? done / total : 0.0;
}

}  // namespace pulvis
