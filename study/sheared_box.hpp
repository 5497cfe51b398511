// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "study/study.hpp"
#include "validation/findings.hpp"

namespace pulvis::study {

/// Conclusions from all points of the study.
void conclude_sheared_box(const std::vector<Done>& all, validation::Findings& findings);

}  // namespace pulvis::study
