// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "study/study.hpp"

namespace pulvis::study {

/// The rows as a table for people.
std::string table_text(const validation::Findings& findings);

/// study.json: {"study", "passed", "rows": [{"quantity", "source", "value", "reference", "deviation", "limit", "passed"}],
/// "points": [{"name", "settings", "result"}]}. `limit` is null where a row is only reported. A number that JSON does
/// not know fails its row and stands as null.
std::string json_text(const Study& study, const std::vector<Done>& points,
                      const validation::Findings& findings);

/// Writes study.json, study.html and, for each figure, SVG and CSV into the folder. Without gnuplot the images are
/// missing, and the page says so. Throws Failure(Exit::io).
void write_report(const std::string& folder, const Study& study, const std::vector<Done>& points,
                  const validation::Findings& findings);

}  // namespace pulvis::study
