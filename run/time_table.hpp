// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "engine/base/time_sheet.hpp"

namespace pulvis {

/// Where the time of a run went, a line for each task that took any, and their sum.
std::string time_table(const TaskSeconds& times);

}  // namespace pulvis
