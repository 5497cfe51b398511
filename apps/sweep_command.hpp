// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <optional>

#include "engine/base/failure.hpp"

namespace pulvis {

/// Adds `pulvis sweep` to the command line.
void add_sweep_command(CLI::App& app);

/// Does what was asked for if it was that. Throws Failure.
std::optional<Exit> run_sweep_command(const CLI::App& app);

}  // namespace pulvis
