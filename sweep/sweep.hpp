// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "engine/base/failure.hpp"
#include "sweep/combinations.hpp"

namespace pulvis::sweep {

struct Request {
  Choice choice;
  std::string out;
  int jobs = 0;         ///< runs at once; 0: as many as the processors are enough for
  int threads = 0;      ///< of each run; 0: one, or more if there are fewer runs than processors
  bool resume = false;  ///< a sweep must be there to go on with
};

/// Runs all that was chosen, each as a process of this program with its results in a folder of its name in
/// `out`. A sweep of the same runs that is there is gone on with. Progress goes to stderr, a table of the results
/// to stdout and sweep.csv; `pulvis compare` makes a page of the complete runs. Returns Exit::ok if all are
/// complete; else, if one failed, the exit code of the first that did (Exit::unexpected if a signal ended it);
/// else what stopped it. Throws Failure for what is wrong before the first run is started: the cases, as read_case
/// does; a folder with other things in it, Exit::usage.
Exit run_sweep(const Request& request);

/// Runs at once and threads of each on a machine with that many processors; 0 where they are not asked for.
struct Shares {
  int jobs, threads;
};
Shares shares(int jobs, int threads, std::size_t runs, int processors);

}  // namespace pulvis::sweep
