// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/simulation/simulation.hpp"

namespace pulvis {

/// Largest overlap of all contacts now, with parcels and walls, over the (smaller) radius.
double largest_overlap_ratio(const Simulation& simulation);

}  // namespace pulvis
