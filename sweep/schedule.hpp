// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "sweep/overview.hpp"

namespace pulvis::sweep {

/// A run to be brought to its end.
struct Task {
  std::string name;
  std::string folder;                  ///< of its results
  std::string log;                     ///< what it prints
  std::vector<std::string> arguments;  ///< of the program, without --resume and --force
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

}  // namespace pulvis::sweep
