// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "report/run_data.hpp"

namespace pulvis::report {

/// Writes the page of a run: `out`, or report.html in its folder if that is empty; figures and their data lie in a
/// folder of the same name without ".html". Returns what to warn of. Throws Failure(Exit::bad_input) if the run cannot
/// be read, Failure(Exit::io) if the page cannot be written.
std::vector<std::string> write_report(const std::string& folder, std::string out);

/// The page of several runs beside each other: comparison.html in the folder `out`. Throws besides
/// Failure(Exit::usage) for fewer than two runs and for runs of different dies.
std::vector<std::string> write_comparison(const std::vector<std::string>& folders, const std::string& out);

}  // namespace pulvis::report
