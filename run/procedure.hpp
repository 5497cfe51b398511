// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"

namespace pulvis {

/// Leads a simulation through the phases of its case: opens sources and starts motions when a phase begins,
/// closes them when it ends, and knows when it ends. Where it stands is part of the simulation's state.
class Procedure {
 public:
  /// Begins the first phase if the state is fresh; goes on where a saved state stopped.
  Procedure(const Case& c, Simulation& simulation);

  bool finished() const { return simulation_.state().progress.phase >= case_.phases.size(); }
  const Phase& phase() const { return case_.phases[simulation_.state().progress.phase]; }
  double phase_start() const;  ///< s
  /// False if the phase will surely not have ended after the next step.
  bool may_end_after_next_step() const;

  /// After a step: why the phase ends now ("time", "inserted", "mass", "cycles", "rest", "time_limit"), or
  /// nothing. Throws Failure(physics) if the phase's limit is an error.
  std::optional<std::string> ended() const;

  /// Ends this phase and begins the next, if there is one.
  void next_phase();

  /// Share of the phase that is done as far as its criterion tells, 0 to 1.
  std::optional<double> phase_share() const;
  /// Share of the whole procedure's work (parcels times steps), as far as it can be foreseen.
  double share() const;

 private:
  void begin_phase();
  void end_phase();
  std::uint64_t steps_in_phase() const;
  std::optional<std::uint64_t> planned_steps(const Phase& phase) const;
  double expected_length(const Phase& phase) const;  ///< s
  bool criterion_met(const Phase& phase) const;

  const Case& case_;
  Simulation& simulation_;
  double default_rest_energy_ = 0.0;      ///< J per parcel
  std::vector<double> expected_parcels_;  ///< of each source
  double time_to_fall_ = 0.0;             ///< s: what is released at rest has moved by then
};

}  // namespace pulvis
