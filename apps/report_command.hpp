// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <optional>

#include "engine/base/failure.hpp"

namespace pulvis {

/// Adds `pulvis report` and `pulvis compare` to the command line.
void add_report_commands(CLI::App& app);

/// Does what was asked for if it was one of them. Throws Failure.
std::optional<Exit> run_report_command(const CLI::App& app);

}  // namespace pulvis
