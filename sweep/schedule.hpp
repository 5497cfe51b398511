// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/base/failure.hpp"
#include "sweep/overview.hpp"

namespace pulvis::sweep {

/// A run to be brought to its end.
struct Task {
  std::string name;
  std::string folder;                  ///< of its results
  std::string log;                     ///< what it prints
  std::vector<std::string> arguments;  ///< of the program, without --resume and --force
  /// Whether it goes on from what is in its folder without being told, or by --resume and --force.
  enum class Continues { when_told, by_itself } continues = Continues::when_told;
};

/// What became of it.
struct Outcome {
  enum class State { complete, failed, stopped, not_started };
  State state = State::not_started;
  int exit = 0;      ///< of the process; 128 + the signal if one ended it
  std::string line;  ///< what it said in the end, if it failed
};

/// Runs the tasks as processes of `program`, at most `jobs` at once: those that are complete are left, those
/// with a checkpoint resumed, those broken off before one begun anew. A failing one stops no other. When this
/// process is asked to stop (stop_request.hpp), so are those that run, and no more are started.
std::vector<Outcome> run_all(const std::vector<Task>& tasks, const std::string& program, int jobs,
                             Overview& overview);

/// Exit::ok if all are complete; else, if one failed, the exit code of the first that did (Exit::unexpected if a
/// signal ended it); else what stopped this process.
Exit exit_of(const std::vector<Outcome>& outcomes);

/// Says on stderr what failed, and how many are left.
void print_what_is_missing(const std::vector<Task>& tasks, const std::vector<Outcome>& outcomes,
                           const std::string& what = "runs");

}  // namespace pulvis::sweep
