// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "report/document.hpp"
#include "report/run_data.hpp"

namespace pulvis::report {

/// Runs whose cases differ in nothing but the seed (and the title and what is written).
struct Group {
  std::string label;
  std::vector<std::size_t> runs;
};

/// In the order of their first runs. A run whose keys are not known is alone.
std::vector<Group> groups_of(const std::vector<RunData>& runs);

/// Numbers of a group: those that are finite.
struct Statistic {
  std::size_t count = 0;
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation of the sample; NaN for fewer than two
};
Statistic statistic_of(const std::vector<double>& values);

/// Whether the means of two groups differ by more than their scatter explains.
struct Verdict {
  double difference = 0.0;  ///< second minus first
  double error = 0.0;       ///< standard error of the difference
  double limit = 0.0;       ///< how many errors the difference must exceed
  bool judged = false;      ///< false: fewer than three runs together, or no number
  bool beyond = false;
};

/// Student's test for samples whose variances may differ (B. L. Welch, Biometrika 34 (1947) 28, doi:10.1093/biomet/34.1-2.28):
/// the difference of means over sqrt(e1 + e2), with e = s^2/n of each, exceeds in absolute value the 97.5 % point of
/// Student's distribution with (e1 + e2)^2/(e1^2/(n1-1) + e2^2/(n2-1)) degrees of freedom, here rounded down, in one case of
/// twenty by chance. A single run is held against the scatter s of the other group: s sqrt(1 + 1/n), n-1 degrees.
Verdict compare_means(const Statistic& first, const Statistic& second);

/// The 97.5 % point of Student's distribution; beyond 30 degrees of freedom that of 30, which is on the safe side.
double student_limit(std::size_t degrees_of_freedom);

// The parts of the page. `last` are the phases that are compared, one of each run.
void add_differing_keys(HtmlPage& page, const std::vector<RunData>& runs);
void add_measures(HtmlPage& page, const std::vector<RunData>& runs,
                  const std::vector<const PhaseData*>& last);
void add_groups(HtmlPage& page, const std::vector<RunData>& runs, const std::vector<const PhaseData*>& last);
void add_costs(HtmlPage& page, const std::vector<RunData>& runs);
void add_compared_figures(Document& document, const std::vector<RunData>& runs,
                          const std::vector<const PhaseData*>& last);
void add_compared_pictures(HtmlPage& page, const std::vector<RunData>& runs);

}  // namespace pulvis::report
