// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "run/preflight.hpp"

namespace pulvis {

/// What `check`, `law` and a run say of the pairs of a case: too soft for the load or for the cohesion, a restitution
/// that is not shown, cohesion that is given and not used, or that one pair has not. Each begins with the pair's
/// name. `pairs` in the order of the assembly's.
std::vector<std::string> pair_warnings(const Case& c, const Assembly& a,
                                       const std::vector<PairForecast>& pairs);

}  // namespace pulvis
