// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "sweep/combinations.hpp"
#include "sweep/schedule.hpp"

namespace pulvis::sweep {

/// The runs as a table for people: what was varied, state, parcels, time, and the measures of die filling.
std::string table_text(const std::vector<Member>& members, const std::vector<Task>& tasks,
                       const std::vector<Outcome>& outcomes);

/// The same with all measures of the last phase, as comma-separated values. Throws Failure(Exit::io).
void write_table(const std::string& file, const std::vector<Member>& members, const std::vector<Task>& tasks,
                 const std::vector<Outcome>& outcomes);

}  // namespace pulvis::sweep
