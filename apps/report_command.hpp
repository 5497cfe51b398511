// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "engine/base/failure.hpp"

namespace pulvis {

/// Adds `pulvis report` and `pulvis compare` to the command line.
void add_report_commands(CLI::App& app);

/// Writes report.html into the folder of a run, prints what to warn of and returns the page's file. Throws Failure.
std::string make_report(const std::string& folder);

/// Does what was asked for if it was one of them. Throws Failure.
std::optional<Exit> run_report_command(const CLI::App& app);

}  // namespace pulvis
