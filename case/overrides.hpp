// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/problems.hpp"
#include "case/value.hpp"

namespace pulvis {

/// A value from the command line, `--set key=value`, that replaces or adds to what the file says.
struct Override {
  std::string key;    ///< "powders.mo.coarse_graining", "phases.shake.cycles", "phases[2].cycles"
  std::string value;  ///< TOML; what is no TOML is taken as text, so that "1e-4 J/m^2" needs no inner quotes
};

/// Overrides from "key=value". Throws Failure(Exit::usage) for what is not so.
std::vector<Override> overrides_from(const std::vector<std::string>& settings);

namespace case_file {

/// Puts the overrides into the parsed file, one after the other; what they cannot address is a problem.
void apply_overrides(const std::vector<Override>& overrides, Value& root, ProblemList& problems);

}  // namespace case_file
}  // namespace pulvis
