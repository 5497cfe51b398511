// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <optional>

#include "engine/base/failure.hpp"

namespace pulvis {

/// `pulvis study`.
void add_study_command(CLI::App& app);
/// Carries it out if it was given.
std::optional<Exit> run_study_command(const CLI::App& app);

}  // namespace pulvis
