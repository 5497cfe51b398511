// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <optional>

#include "engine/base/failure.hpp"

namespace pulvis {

/// `pulvis bench`.
void add_bench_command(CLI::App& app);
/// Carries it out if it was given.
std::optional<Exit> run_bench_command(const CLI::App& app);

}  // namespace pulvis
