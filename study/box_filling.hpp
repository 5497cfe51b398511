// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "study/study.hpp"

namespace pulvis::study {

constexpr double end_layer =
    2e-3;  ///< m: left out at the floor and below the surface; 2.6 of the coarsest parcels

/// What follows from the points of the study box-filling: see box_filling.cpp for what they hold.
void conclude_box_filling(const std::vector<Done>& all, validation::Findings& findings);

}  // namespace pulvis::study
