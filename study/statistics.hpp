// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

namespace pulvis::study {

double mean_of(const std::vector<double>& values);
/// Standard deviation of the mean over equal draws; 0 for fewer than two values.
double standard_error_of(const std::vector<double>& values);

/// The difference of two means, b less a.
struct Difference {
  double value = 0.0;
  double standard_error = 0.0;  ///< from the scatter within each
  double half_width = 0.0;      ///< of its 95 % interval, Student's t; infinite without a scatter
};
Difference difference(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace pulvis::study
