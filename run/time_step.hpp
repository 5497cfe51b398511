// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"
#include "engine/walls/bodies.hpp"
#include "run/species.hpp"

namespace pulvis {

/// One limit on the time step.
struct StepLimit {
  std::string kind;   ///< rayleigh, or of laws::TimeLimit
  std::string of;     ///< the powder or the pair it comes from
  double time = 0.0;  ///< s
};

struct TimeStep {
  double step = 0.0;                  ///< s
  double characteristic_speed = 0.0;  ///< m/s
  std::vector<StepLimit> limits;      ///< all of them, the smallest first
  bool given = false;                 ///< the case fixes the step
};

/// Speed that collisions can reach, m/s: over all phases, the largest sum of the fall of the parcels that
/// appear in it (from the top of their region to the deepest wall, with their initial velocity) and of its
/// fastest wall. The case can state its own.
double characteristic_speed(const Case& c, const Walls& walls);

/// The time step: the case's own, or its fraction of the smallest limit. For the smallest parcels, whose
/// radius (m) is given for each species that is a powder:
/// laws::rayleigh_time per powder, and laws::time_limits per pair of species.
TimeStep choose_time_step(const Case& c, const std::vector<Species>& species,
                          const std::vector<PairProperties>& pairs, const Walls& walls,
                          const std::vector<double>& smallest_radius);

/// Why the step cannot be used (the case gives one above the smallest limit), with its remedy; empty if it can.
std::string step_problem(const Case& c, const TimeStep& chosen);

}  // namespace pulvis
