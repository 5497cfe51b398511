// SPDX-License-Identifier: Apache-2.0
#include "run/run_case.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>

#include "case/units.hpp"
#include "output/progress.hpp"
#include "run/preflight.hpp"
#include "run/procedure.hpp"
#include "run/results.hpp"

namespace pulvis {
namespace {

std::atomic<bool> stop_asked{false};

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One run from the first phase to the last: steps, looks, outputs.
class Runner {
 public:
  Runner(const Case& c, Model&& model, Results& results, int threads)
      : case_(c),
        results_(results),
        simulation_(simulation_of(std::move(model), threads)),
        procedure_(c, simulation_),
        progress_(ProgressOptions::for_stderr()),
        loads_(c, simulation_, hundredth_of_longest_phase(c)),
        frame_every_(every(c.output.interval)),
        log_every_(every(log_interval(c))) {
    if (!procedure_.finished()) loads_.begin_phase(procedure_.phase(), simulation_);
  }

  void run(RunSummary& summary);
  const Simulation& simulation() const { return simulation_; }

 private:
  static Simulation simulation_of(Model&& model, int threads) {
    State state = Simulation::initial_state(model);
    return {std::move(model), std::move(state), threads};
  }
  /// Steps between looks that are `interval` seconds apart; 0: never.
  std::uint64_t every(double interval) const {
    return interval > 0.0
               ? static_cast<std::uint64_t>(std::max(1.0, std::round(interval / simulation_.model().dt)))
               : 0;
  }
  static double log_interval(const Case& c) {
    return c.output.log_interval > 0.0 ? c.output.log_interval : hundredth_of_longest_phase(c);
  }
  static double hundredth_of_longest_phase(const Case& c) {
    double longest = 0.0;
    for (const Phase& p : c.phases) {
      double length = std::max(p.duration, p.time_limit);
      if (p.until == Phase::Until::cycles)
        length = std::max(length, length_of_cycles(c.motions[p.motions.front()].motion, p.cycles).value());
      if (p.until == Phase::Until::motions)
        for (const std::size_t m : p.motions)
          length = std::max(length, duration(c.motions[m].motion).value());
      longest = std::max(longest, length);
    }
    return longest / 100.0;
  }

  void look(bool phase_ends, const std::string& phase);
  void close_phase(const std::string& ended_by, bool run_ends, RunSummary& summary);
  void show_progress(const RunSummary& summary);
  void check_escapes() const;
  void check_finite() const;
  void warn(RunSummary& summary, const std::string& text) {
    summary.warnings.push_back(text);
    progress_.message("warning: " + text);
  }

  const Case& case_;
  Results& results_;
  Simulation simulation_;
  Procedure procedure_;
  Progress progress_;
  WallLoads loads_;
  std::uint64_t frame_every_, log_every_;
};

std::string text_of(const Escape& e) {
  return fmt::format("t = {:.6g} s, position ({:.5g}, {:.5g}, {:.5g}) m, speed {:.4g} m/s", e.time,
                     e.position.x, e.position.y, e.position.z, norm(e.velocity));
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

/// Each step looks at what the one before it made; nobody else would look at what the last one made.
void Runner::check_finite() const {
  const auto finite = [](const Vec3& v) { return std::isfinite(dot(v, v)); };
  const Parcel* bad = nullptr;
  for (const Parcel& p : simulation_.state().parcels.body)
    if (!(finite(p.position) && finite(p.velocity) && finite(p.spin)) && (!bad || p.id < bad->id)) bad = &p;
  if (!bad) return;
  const Vec3 &x = bad->position, &v = bad->velocity;
  throw Failure(
      Exit::physics,
      fmt::format("position, velocity or spin is not a finite number: parcel {} at t = {:.6g} s, position "
                  "({:.6g}, {:.6g}, {:.6g}) m, velocity ({:.6g}, {:.6g}, {:.6g}) m/s, radius {:.4g} m\n  "
                  "the time step may be too large (lower time.fraction) or a material constant out of range",
                  bad->id, simulation_.time(), x.x, x.y, x.z, v.x, v.y, v.z, bad->radius));
}

void Runner::look(bool phase_ends, const std::string& phase) {
  const std::uint64_t step = simulation_.state().step;
  if (phase_ends || (log_every_ && step % log_every_ == 0)) results_.log(simulation_, phase);
  if (phase_ends) return;
  if (frame_every_ && step % frame_every_ == 0)
    results_.frame(simulation_, loads_, measure(case_, simulation_).porosity);
}

void Runner::close_phase(const std::string& ended_by, bool run_ends, RunSummary& summary) {
  const Phase& phase = procedure_.phase();
  Measurement m = measure(case_, simulation_);
  for (Measure& of_walls : wall_measures(case_, loads_, simulation_)) m.list.push_back(std::move(of_walls));
  summary.phases.push_back({phase.name, procedure_.phase_start(), simulation_.time(), ended_by, m.list,
                            wall_forces(loads_, simulation_)});
  results_.frame(simulation_, loads_, m.porosity);
  results_.walls().write_pressures(loads_, simulation_, phase.name);
  for (const std::size_t s : phase.sources) {
    const SourceState& source = simulation_.state().sources[s];
    if (source.done || (phase.until != Phase::Until::inserted && phase.until != Phase::Until::mass)) continue;
    warn(summary,
         fmt::format("source {} had given {} parcels ({}) when phase {} ended by {}", case_.sources[s].name,
                     source.count, format_quantity(source.mass, dimension::mass), phase.name, ended_by));
  }
  if (case_.output.picture) {
    const bool last_phase = simulation_.state().progress.phase + 1 == case_.phases.size();
    results_.picture(simulation_, phase.name, last_phase || run_ends);
  }
}

void Runner::show_progress(const RunSummary& summary) {
  progress_.update({.phase = procedure_.phase().name,
                    .simulated_time = simulation_.time(),
                    .fraction = procedure_.share(),
                    .parcels = simulation_.state().parcels.size(),
                    .particle_steps = summary.particle_steps});
}

void Runner::run(RunSummary& summary) {
  results_.log(simulation_, procedure_.phase().name);
  results_.frame(simulation_, loads_, {});
  double mark = seconds_now();
  const auto since_mark = [&] {
    const double before = mark;
    mark = seconds_now();
    return mark - before;
  };
  while (!procedure_.finished()) {
    simulation_.step();
    if (loads_.after_step(simulation_)) results_.walls().log(loads_, simulation_, procedure_.phase().name);
    summary.particle_steps += simulation_.state().parcels.size();
    check_escapes();
    const auto ended = procedure_.ended();
    const bool stop = stop_asked && !ended;
    if (ended || stop) check_finite();
    summary.stepping_time += since_mark();
    look(ended.has_value(), procedure_.phase().name);
    if (simulation_.state().step % 16 == 0 || ended) show_progress(summary);
    summary.looking_time += since_mark();
    if (ended) {
      close_phase(*ended, false, summary);
      summary.looking_time += since_mark();
      procedure_.next_phase();
      if (!procedure_.finished()) loads_.begin_phase(procedure_.phase(), simulation_);
    } else if (stop) {
      close_phase("stopped on request", true, summary);
      summary.exit = Exit::cancelled;
      summary.reason = "stopped on request; the results are those up to then";
      return;
    }
  }
  summary.reason = "completed";
}

/// Counts must balance exactly, masses to rounding.
void check_ledger(const Simulation& simulation) {
  const Ledger& l = simulation.state().ledger;
  const std::uint64_t present = simulation.state().parcels.size();
  double mass = 0.0;
  for (const Parcel& p : simulation.state().parcels.body) mass += p.mass;
  const double off = l.inserted_mass - mass - l.removed_mass - l.escaped_mass;
  if (l.inserted == present + l.removed + l.escaped && std::abs(off) <= 1e-9 * l.inserted_mass) return;
  throw Failure(
      Exit::internal_check,
      fmt::format(
          "the ledger does not balance: {} parcels inserted, {} present, {} removed, {} escaped; "
          "{:.3g} kg unaccounted for\n  this is a fault of the program, please report it with the case",
          l.inserted, present, l.removed, l.escaped, off));
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

/// Escapes that are an error need no warning: they are the reason for the end.
void warn_of_escapes(const Case& c, const State& state, RunSummary& summary) {
  if (c.domain.escape_is_error || state.escapes.empty()) return;
  const Escape& first = state.escapes.front();
  add_warning(summary, fmt::format("{} parcel{} ({}) escaped; the first was parcel {} through {} at {}",
                                   state.ledger.escaped, state.ledger.escaped == 1 ? "" : "s",
                                   format_quantity(state.ledger.escaped_mass, dimension::mass), first.id,
                                   first.through, text_of(first)));
}

void print_summary(const Case& c, const Results& results, const RunSummary& summary,
                   const Simulation& simulation) {
  fmt::print(
      "{} after {} of simulated time ({} steps, {} parcels) in {} ({} of it measures and files), {} "
      "particle-steps/s\n",
      summary.exit == Exit::ok ? "Completed" : "Ended", format_quantity(simulation.time(), dimension::time),
      simulation.state().step, simulation.state().parcels.size(), duration_text(summary.wall_time),
      duration_text(summary.looking_time),
      count_text(static_cast<double>(summary.particle_steps) / std::max(summary.stepping_time, 1e-9)));
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
  const std::string& folder = results.folder().path();
  fmt::print("Results in {}:\n  numbers   {}/result.json, {}/log.csv\n", folder, folder, folder);
  if (c.output.picture)
    fmt::print("  picture   {0}/picture.png{1}\n", folder,
               summary.phases.size() > 1 ? fmt::format(", {}/pictures/after-*.png", folder) : "");
  fmt::print("  ParaView  {0}/parcels.pvd, {0}/walls.pvd, {0}/porosity.pvd\n", folder);
}

}  // namespace

int available_processors() { return omp_get_num_procs(); }

void ask_to_stop() { stop_asked = true; }

Exit run_case(const RunRequest& request) {
  const Case c = read_case(request.case_file, request.overrides);
  Assembly assembly = assemble(c);
  Results results(c, assembly.time_step, request.out,
                  request.force ? UsedFolder::replace_results : UsedFolder::refuse);
  results.write_case(request.overrides);

  RunSummary summary;
  // What stands there if this process is killed, or the disk is too full for more.
  summary.exit = Exit::unexpected;
  summary.reason = "the run has not ended, or it was killed";
  results.write_result(summary, nullptr, false);
  summary.exit = Exit::ok;
  summary.notes = assembly.notes;
  for (const Motion& motion : c.motions) summary.notes.push_back(motion_line(motion));
  for (const auto& warning : forecast(c, assembly).warnings) add_warning(summary, warning);

  std::optional<Runner> runner;
  const double start = seconds_now();
  try {
    runner.emplace(c, std::move(assembly.model), results,
                   request.threads > 0 ? request.threads : available_processors());
    runner->run(summary);
    check_ledger(runner->simulation());
  } catch (const Failure& failure) {
    summary.exit = failure.code();
    summary.reason = failure.what();
  } catch (const std::exception& error) {
    summary.exit = Exit::unexpected;
    summary.reason = fmt::format("unexpected: {}", error.what());
  }
  summary.wall_time = seconds_now() - start;
  warn_of_overlap(results.largest_overlap(), summary);
  if (runner) warn_of_escapes(c, runner->simulation().state(), summary);
  // First: if the results cannot be written, that is a second failure, not the reason of the first.
  if (summary.exit != Exit::ok) fmt::print(stderr, "pulvis: {}\n", summary.reason);
  results.write_result(summary, runner ? &runner->simulation() : nullptr);
  if (runner && (summary.exit == Exit::ok || summary.exit == Exit::cancelled))
    print_summary(c, results, summary, runner->simulation());
  return summary.exit;
}

}  // namespace pulvis
