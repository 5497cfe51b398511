// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "case/overrides.hpp"
#include "study/study.hpp"

namespace pulvis::study {

/// Runs a case in the folder of a point (in `run/`), from the checkpoint that an interrupted one left there; what is
/// complete is not run again. Returns its result.json. Throws Stopped when asked to stop, and Failure with the exit
/// code of a run that failed.
Json run_of_case(const Work& work, const std::string& case_file, const std::vector<Override>& settings);

}  // namespace pulvis::study
