// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "output/html_page.hpp"
#include "report/run_data.hpp"

namespace pulvis::report {

/// Names and units of all measures that at least one of the phases has, in the order they first come.
std::vector<Scalar> measures_of(const std::vector<const PhaseData*>& phases);

/// The values of one measure in the unit that suits the largest of them: "1.6"; "-" where there is none.
std::vector<std::string> cells_of(const Scalar& measure, const std::vector<double>& values,
                                  std::string& unit);

/// Measures as rows, phases as columns, with units and windows.
void add_results(HtmlPage& page, const RunData& run);

/// Parts of the die at the end of the last phase that measured any.
void add_parts(HtmlPage& page, const RunData& run);

}  // namespace pulvis::report
