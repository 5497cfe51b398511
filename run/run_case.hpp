// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "case/reader.hpp"
#include "engine/base/failure.hpp"

namespace pulvis {

struct RunRequest {
  std::string case_file;
  std::vector<Override> overrides;
  std::string out;
  int threads = 0;  ///< 0: all processors this process may use
  bool force = false;
  bool resume = false;   ///< go on from the newest checkpoint in `out`
  std::string max_wall;  ///< time on the clock after which to stop with a checkpoint, "12 h"; empty: none
  /// Makes a page of the results in the folder it is given, when they are complete and the folder is still held;
  /// may be empty. Returns the page's file. What it throws is warned of: the results are there without it.
  std::function<std::string(const std::string&)> make_page;
};

/// Runs a case from the file to the results. Progress goes to stderr; a short summary with the places of the
/// results to stdout. Returns the exit code; errors before the results folder is held are thrown as Failure.
Exit run_case(const RunRequest& request);

/// Processors this process may use.
int available_processors();

}  // namespace pulvis
