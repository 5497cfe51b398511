// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/simulation/energy_ledger.hpp"

namespace pulvis {

struct RunSummary;

/// A line of the ledger of energy, as it is written and printed.
struct EnergyLine {
  enum class Kind { now, lost, brought_in, total };
  const char* name;   ///< in result.json
  const char* words;  ///< for people
  Kind kind;
  double value;  ///< J
};

/// All lines of a ledger; what a model does not have is not among them. The sum of `now` is that of start, inserted less
/// removed and `brought_in`, less `lost`, but for the closing error.
std::vector<EnergyLine> energy_lines(const EnergyBalance& balance);

/// Adds a warning if more than 1 % of the energy put through is unaccounted for.
void warn_of_energy(const EnergyBalance& balance, RunSummary& summary);
/// What is printed at the end of a run.
std::string energy_text(const EnergyBalance& balance);

}  // namespace pulvis
