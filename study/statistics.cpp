// SPDX-License-Identifier: Apache-2.0
#include "study/statistics.hpp"

#include <cmath>
#include <numeric>

#include "report/compare.hpp"

namespace pulvis::study {

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_error_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  return report::statistic_of(values).deviation / std::sqrt(static_cast<double>(values.size()));
}

Difference difference(const std::vector<double>& a, const std::vector<double>& b) {
  const report::Verdict v = report::compare_means(report::statistic_of(a), report::statistic_of(b));
  if (!v.judged) return {mean_of(b) - mean_of(a), HUGE_VAL, HUGE_VAL};
  return {v.difference, v.error, v.limit * v.error};
}

}  // namespace pulvis::study
