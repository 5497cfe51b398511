// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "case/case.hpp"
#include "engine/simulation/simulation.hpp"
#include "run/run_summary.hpp"
#include "run/time_step.hpp"

namespace pulvis {

/// What result.json says. `simulation` may be null if the run failed before it began.
nlohmann::ordered_json result_json(const Case& c, const TimeStep& time_step, const RunSummary& summary,
                                   const Simulation* simulation, double largest_overlap);

}  // namespace pulvis
