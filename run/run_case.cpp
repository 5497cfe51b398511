// SPDX-License-Identifier: Apache-2.0
#include "run/run_case.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <optional>

#include "case/units.hpp"
#include "run/energy_lines.hpp"
#include "run/preflight.hpp"
#include "run/runner.hpp"

namespace pulvis {
namespace {

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

double seconds_of(const std::string& max_wall) {
  if (max_wall.empty()) return std::numeric_limits<double>::infinity();
  const QuantityReading reading = read_quantity(max_wall);
  if (!reading.quantity || !(reading.quantity->dimension == dimension::time) || reading.quantity->value < 0.0)
    throw Failure(Exit::usage, fmt::format("--max-wall {}: expected a time, e.g. \"12 h\"", max_wall));
  return reading.quantity->value;
}

void refuse_if_changed(const Checkpoint& then, const std::vector<CaseKey>& keys, double time_step) {
  std::string list;
  for (const std::string& line : differences(then.keys, keys)) list += "\n  " + line;
  if (!list.empty())
    throw Failure(Exit::usage,
                  "the case has changed since this run began; go on with what it was, or start "
                  "anew with --force:" +
                      list);
  if (then.time_step != time_step)
    throw Failure(Exit::usage,
                  fmt::format("the run began with a time step of {} s, and this program (pulvis {}, then {}) "
                              "finds {} s; go on with the program it began with, or start anew with --force",
                              then.time_step, PULVIS_VERSION, then.program, time_step));
}

/// Where to go on from; nothing if the run is complete.
std::optional<Checkpoint> to_resume(const RunFolder& folder, Checkpoints& checkpoints,
                                    const std::vector<CaseKey>& keys, double time_step) {
  const bool complete = is_complete(folder);
  if (complete && checkpoints.none()) return {};
  Checkpoint c = checkpoints.newest();
  refuse_if_changed(c, keys, time_step);
  if (complete) return {};
  if (c.program != PULVIS_VERSION)
    fmt::print(stderr, "warning: the run began with pulvis {}, and this is {}: the results may differ\n",
               c.program, PULVIS_VERSION);
  fmt::print(stderr, "going on from {} at {} of simulated time\n", checkpoints.file(),
             format_quantity(static_cast<double>(c.state.step) * c.time_step, dimension::time));
  ++c.summary.resumes;
  return c;
}

/// What is known before the first step.
Checkpoint fresh_start(const Case& c, const Assembly& assembly) {
  Checkpoint start;
  start.state = Simulation::initial_state(assembly.model);
  start.summary.notes = assembly.notes;
  for (const Motion& motion : c.motions) start.summary.notes.push_back(motion_line(motion));
  for (const auto& warning : forecast(c, assembly).warnings) add_warning(start.summary, warning);
  return start;
}

void make_page(const RunRequest& request, const RunFolder& folder) {
  if (!request.make_page) return;
  try {
    fmt::print("  page      {}\n", request.make_page(folder.path()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "warning: there is no page of the results: {}\n", error.what());
  }
}

}  // namespace

int available_processors() { return omp_get_num_procs(); }

Exit run_case(const RunRequest& request) {
  const TimeSheet times;
  const double latest = times.booked() + seconds_of(request.max_wall);
  const Case c = read_case(request.case_file, request.overrides);
  Assembly assembly = assemble(c);
  const std::vector<CaseKey> keys = deciding_keys(c);
  const RunFolder folder = open_results(c, request.out,
                                        request.resume  ? UsedFolder::resume
                                        : request.force ? UsedFolder::replace_results
                                                        : UsedFolder::refuse);
  Checkpoints checkpoints(folder);
  std::optional<Checkpoint> start;
  if (request.resume) {
    start = to_resume(folder, checkpoints, keys, assembly.model.dt);
    if (!start) {
      fmt::print("The run in {} is complete; there is nothing to go on with.\n", folder.path());
      return Exit::ok;
    }
  }
  Results results(c, assembly.time_step, assembly.model.walls, folder,
                  start ? start->results : WrittenResults{});
  results.write_case();
  results.write_result(not_ended(start ? start->summary : RunSummary{}), nullptr, false);
  if (!start) start = fresh_start(c, assembly);
  start->keys = keys;
  RunSummary summary = start->summary;

  std::optional<Runner> runner;
  std::optional<Failure> failed;
  try {
    runner.emplace(c, std::move(assembly.model), std::move(*start), results, checkpoints,
                   request.threads > 0 ? request.threads : available_processors(), times);
    runner->run(latest);
    check_ledger(runner->simulation());
  } catch (const Failure& failure) {
    failed = failure;
  } catch (const std::exception& error) {
    failed = Failure(Exit::unexpected, fmt::format("unexpected: {}", error.what()));
  }
  if (runner) summary = runner->summary();
  if (failed) summary.exit = failed->code(), summary.reason = failed->what();
  warn_of_overlap(results.largest_overlap(), summary);
  if (runner) warn_of_escapes(c, runner->simulation().state(), summary);
  if (const auto energy = runner ? runner->simulation().energy() : std::nullopt)
    warn_of_energy(*energy, summary);
  // First: if the results cannot be written, that is a second failure, not the reason of the first.
  if (summary.exit != Exit::ok) fmt::print(stderr, "pulvis: {}\n", summary.reason);
  results.write_result(summary, runner ? &runner->simulation() : nullptr);
  if (runner && (summary.exit == Exit::ok || summary.exit == Exit::cancelled)) {
    print_summary(c, folder.path(), summary, runner->simulation());
    if (c.output.report) make_page(request, folder);
  }
  return summary.exit;
}

}  // namespace pulvis
