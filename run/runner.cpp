// SPDX-License-Identifier: Apache-2.0
#include "run/runner.hpp"

#include <fmt/format.h>

#include <cmath>
#include <csignal>

#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "run/stop_request.hpp"

namespace pulvis {
namespace {

constexpr std::uint64_t steps_between_looks = 16;  // whether to stop, to save, to show progress

double hundredth_of_longest_phase(const Case& c) {
  double longest = 0.0;
  for (const Phase& p : c.phases) {
    double length = std::max(p.duration, p.time_limit);
    if (p.until == Phase::Until::cycles)
      length = std::max(length, length_of_cycles(c.motions[p.motions.front()].motion, p.cycles).value());
    if (p.until == Phase::Until::motions)
      for (const std::size_t m : p.motions) length = std::max(length, duration(c.motions[m].motion).value());
    longest = std::max(longest, length);
  }
  return longest / 100.0;
}

double or_default(double interval, const Case& c) {
  return interval > 0.0 ? interval : hundredth_of_longest_phase(c);
}

Simulation simulation_of(const Case& c, Model&& model, State&& state, int threads, const TimeSheet& times) {
  require_fit(state, model);
  if (state.progress.phase > c.phases.size())
    throw Failure(Exit::bad_input, "the saved state is in a phase that the case does not have");
  return {std::move(model), std::move(state), threads, times};
}

}  // namespace

Runner::Runner(const Case& c, Model&& model, Checkpoint start, Results& results, Checkpoints& checkpoints,
               int threads, const TimeSheet& times)
    : case_(c),
      results_(results),
      checkpoints_(checkpoints),
      checkpoint_(std::move(start)),
      simulation_(simulation_of(c, std::move(model), std::move(checkpoint_.state), threads, times)),
      procedure_(c, simulation_),
      progress_(ProgressOptions::for_stderr()),
      loads_(c, simulation_, hundredth_of_longest_phase(c)),
      flows_(c, simulation_),
      frame_every_(every(c.output.interval)),
      log_every_(every(or_default(c.output.log_interval, c))),
      measure_every_(every(or_default(c.measures.interval, c))),
      saved_(seconds_now()) {
  if (checkpoint_.summary.resumes == 0) return;
  this->times().add(checkpoint_.times);
  loads_.go_on_from(std::move(checkpoint_.loads));
  flows_.go_on_from(std::move(checkpoint_.flows));
}

std::uint64_t Runner::every(double interval) const {
  return interval > 0.0
             ? static_cast<std::uint64_t>(std::max(1.0, std::round(interval / simulation_.model().dt)))
             : 0;
}

void Runner::warn(const std::string& text) {
  summary().warnings.push_back(text);
  progress_.message("warning: " + text);
}

void Runner::check_escapes() const {
  const auto& escapes = simulation_.state().escapes;
  if (escapes.empty() || !case_.domain.escape_is_error) return;
  const Escape& e = escapes.back();
  throw Failure(
      Exit::physics,
      fmt::format("parcel {} escaped through {} at {}\n  if parcels may be lost, set domain.escape = "
                  "\"count\"; else close the walls, enlarge [domain] or lower time.fraction",
                  e.id, e.through, text_of(e)));
}

std::vector<Measure> Runner::all_measures(const std::optional<DieSurvey>& die) const {
  std::vector<Measure> list = measures_of(simulation_, die);
  for (Measure& of_walls : wall_measures(case_, loads_, simulation_)) list.push_back(std::move(of_walls));
  return list;
}

void Runner::log_measures(const std::string& phase, std::vector<Measure> list) {
  for (const FlowSince& flow : flows_.since_last_line(simulation_))
    list.push_back({"flow_" + flow.surface, flow.rate, "kg/s", "since the line before"});
  results_.log_measures(simulation_.time(), phase, list);
}

void Runner::look(bool phase_ends, const std::string& phase) {
  const std::uint64_t step = simulation_.state().step;
  if (phase_ends || (log_every_ && step % log_every_ == 0)) results_.log(simulation_, phase);
  if (phase_ends) return;
  if (measure_every_ && step % measure_every_ == 0)
    log_measures(phase, all_measures(survey_die(case_, simulation_)));
  if (frame_every_ == 0 || step % frame_every_ != 0) return;
  const auto porosity = porosity_of_die(case_, simulation_);
  times().book(Task::measures);
  results_.frame(simulation_, loads_, porosity);
  times().book(Task::files);
}

void Runner::close_phase(const std::string& ended_by, bool run_ends) {
  const Phase& phase = procedure_.phase();
  const std::optional<DieSight> sight = look_into_die(case_, simulation_);
  const auto die = sight ? std::optional(survey_die(case_, simulation_, *sight)) : std::nullopt;
  const std::vector<Measure> list = all_measures(die);
  const double time = simulation_.time();
  summary().phases.push_back(
      {phase.name, procedure_.phase_start(), time, ended_by, list, wall_forces(loads_, simulation_)});
  log_measures(phase.name, list);
  times().book(Task::measures);
  results_.write_measures(time, phase.name, list, die, flows_.in_phase(simulation_));
  results_.frame(simulation_, loads_, die ? std::optional(die->porosity) : std::nullopt);
  if (sight) results_.fields(time, *sight, die->porosity, field_support(case_));
  results_.write_pressures(loads_, simulation_, phase.name);
  times().book(Task::files);
  for (const std::size_t s : phase.sources) {
    const SourceState& source = simulation_.state().sources[s];
    if (source.done || (phase.until != Phase::Until::inserted && phase.until != Phase::Until::mass)) continue;
    warn(fmt::format("source {} had given {} parcels ({}) when phase {} ended by {}", case_.sources[s].name,
                     source.count, format_quantity(source.mass, dimension::mass), phase.name, ended_by));
  }
  if (case_.output.picture) {
    const bool last_phase = simulation_.state().progress.phase + 1 == case_.phases.size();
    results_.pictures(simulation_, phase.name, last_phase || run_ends);
    times().book(Task::pictures);
  }
}

void Runner::show_progress() {
  progress_.update({.phase = procedure_.phase().name,
                    .simulated_time = simulation_.time(),
                    .fraction = procedure_.share(),
                    .parcels = simulation_.state().parcels.size(),
                    .particle_steps = summary().particle_steps});
}

/// Only between two steps, when all output of the one before is written.
void Runner::save() {
  times().book(Task::rest);
  simulation_.require_sound();  // the last good one must not give way to one that leads nowhere
  times().book(Task::guards);
  checkpoint_.time_step = simulation_.model().dt;
  checkpoint_.state = simulation_.snapshot();
  checkpoint_.loads = loads_.record();
  checkpoint_.flows = flows_.record();
  checkpoint_.results = results_.written();
  checkpoint_.times = times().seconds();
  checkpoints_.write(checkpoint_);
  checkpoint_.state = {};
  checkpoint_.loads = {};
  checkpoint_.flows = {};
  times().book(Task::checkpoints);
  saved_ = times().booked();
}

void Runner::begin() {
  loads_.begin_phase(procedure_.phase(), simulation_);
  flows_.begin_phase(simulation_);
  results_.log(simulation_, procedure_.phase().name);
  times().book(Task::measures);
  results_.frame(simulation_, loads_, {});
  times().book(Task::files);
  save();
}

/// Whether anything is to be done after the next step but to go on.
bool Runner::looks_after_next_step() const {
  const std::uint64_t next = simulation_.state().step + 1;
  const auto due = [&](std::uint64_t every) { return every != 0 && next % every == 0; };
  return due(steps_between_looks) || due(log_every_) || due(measure_every_) || due(frame_every_) ||
         loads_.samples_after_next_step() || flows_.look_at(next) || procedure_.may_end_after_next_step();
}

void Runner::step(Simulation::Then then) {
  simulation_.step(then);
  if (loads_.after_step(simulation_)) results_.log_walls(loads_, simulation_, procedure_.phase().name);
  flows_.after_step(simulation_);
  times().book(Task::measures);
  summary().particle_steps += simulation_.state().parcels.size();
  check_escapes();
}

void Runner::end_phase(const std::string& ended_by) {
  close_phase(ended_by, false);
  results_.write_result(not_ended(summary()), nullptr,
                        false);  // so that a report finds the phase after a crash
  times().book(Task::files);
  procedure_.next_phase();
  if (!procedure_.finished()) {
    loads_.begin_phase(procedure_.phase(), simulation_);
    flows_.begin_phase(simulation_);
  }
  save();
}

/// Whether to stop before the next step; everything is saved and written then.
bool Runner::stops(double latest) {
  const int signal = signal_to_stop();
  const bool too_long = times().booked() > latest;
  if (signal == 0 && !too_long) return false;
  save();
  if (signal == SIGINT) {
    close_phase("stopped on request", true);
    summary().exit = Exit::cancelled;
    summary().reason = "stopped on request; the results are those up to then";
    return true;
  }
  const char* why = signal == SIGTERM ? "SIGTERM" : signal == SIGUSR1 ? "SIGUSR1" : "--max-wall";
  summary().exit = Exit::interrupted;
  summary().reason =
      fmt::format("stopped by {} at {} of simulated time; the same command with --resume goes on from {}",
                  why, format_quantity(simulation_.time(), dimension::time), checkpoints_.file());
  return true;
}

void Runner::run(double latest) {
  if (summary().resumes == 0) begin();
  while (!procedure_.finished()) {
    const bool looks = looks_after_next_step();
    step(looks ? Simulation::Then::look : Simulation::Then::go_on);
    if (!looks) continue;
    const auto ended = procedure_.ended();
    if (ended) {
      simulation_.require_sound();
      times().book(Task::guards);
    }
    look(ended.has_value(), procedure_.phase().name);
    times().book(Task::measures);
    show_progress();
    if (ended) end_phase(*ended);
    times().book(Task::rest);
    if (procedure_.finished()) break;
    if (stops(latest)) return;
    const double interval = case_.output.checkpoint_interval;
    if (interval > 0.0 && times().booked() - saved_ >= interval) save();
  }
  summary().reason = "completed";
}

}  // namespace pulvis
