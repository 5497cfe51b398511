// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "run/flow_meters.hpp"
#include "run/measuring.hpp"

namespace pulvis {

/// What measures/after-PHASE.json holds: docs/measures-format.md.
nlohmann::ordered_json measures_json(double time, const std::string& phase, const std::vector<Measure>& list,
                                     const std::optional<DieSurvey>& die, const std::vector<FlowSince>& flow);

/// The measures by their names, each with value, unit and window.
nlohmann::ordered_json scalars_json(const std::vector<Measure>& list);

}  // namespace pulvis
