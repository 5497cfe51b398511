// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "study/study.hpp"

namespace pulvis::study {

/// What follows from the points of the study box-filling: see box_filling.cpp for what they hold.
void conclude_box_filling(const std::vector<Done>& all, validation::Findings& findings);

}  // namespace pulvis::study
