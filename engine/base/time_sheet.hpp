// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <numeric>

namespace pulvis {

/// Seconds on a clock that never goes backwards.
inline double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What the time of a run goes to. From `insertion` to `guards`: time steps, booked by the engine.
enum class Task {
  preparation,    ///< case, meshes, laws, all before the first step
  insertion,      ///< sources
  bodies,         ///< moving walls, and whether anything left its margin
  near_lists,     ///< finding neighbours, sorting, carrying contacts over
  walls,          ///< contacts with walls
  pairs,          ///< contacts of parcels, sums of forces, motion: the sweep
  leaving,        ///< taking parcels out
  energy_ledger,  ///< if asked for
  guards,         ///< looking for what must stop a run
  measures,       ///< and the logs they go to
  files,          ///< series for ParaView, tables, result.json
  pictures,
  checkpoints,
  rest,
};
inline constexpr std::array task_names{"preparation", "insertion", "bodies",        "near_lists", "walls",
                                       "pairs",       "leaving",   "energy_ledger", "guards",     "measures",
                                       "files",       "pictures",  "checkpoints",   "rest"};
static_assert(task_names.size() == static_cast<std::size_t>(Task::rest) + 1);

/// Seconds by task.
struct TaskSeconds {
  std::array<double, task_names.size()> of{};

  double operator[](Task task) const { return of[static_cast<std::size_t>(task)]; }
  double total() const { return std::accumulate(of.begin(), of.end(), 0.0); }
  double of_steps() const {
    const auto at = [&](Task task) { return of.begin() + static_cast<std::ptrdiff_t>(task); };
    return std::accumulate(at(Task::insertion), at(Task::measures), 0.0);
  }
};

/// Books time: what passed since the last booking goes to the task that is named, so that all of it goes somewhere.
/// A booking reads the clock once (some 30 ns): they stand between the parts of a step, never in a loop over parcels.
class TimeSheet {
 public:
  void book(Task task) {
    const double now = seconds_now();
    seconds_.of[static_cast<std::size_t>(task)] += now - booked_;
    booked_ = now;
  }
  /// What an earlier process needed for the same run.
  void add(const TaskSeconds& earlier) {
    for (std::size_t k = 0; k < seconds_.of.size(); ++k) seconds_.of[k] += earlier.of[k];
  }
  const TaskSeconds& seconds() const { return seconds_; }
  double booked() const { return booked_; }  ///< all time up to this moment is, as seconds_now() has it

 private:
  TaskSeconds seconds_;
  double booked_ = seconds_now();
};

}  // namespace pulvis
