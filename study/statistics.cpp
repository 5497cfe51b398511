// SPDX-License-Identifier: Apache-2.0
#include "study/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pulvis::study {
namespace {

double squares_about_mean(const std::vector<double>& values) {
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum;
}

/// The 97.5 % quantile of Student's t. (M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions (1964), table
/// 26.10; beyond it the normal one and the first term of its expansion in 1/n, 26.7.5.)
double student(std::size_t freedom) {
  constexpr double table[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  if (freedom == 0) return HUGE_VAL;
  if (freedom <= std::size(table)) return table[freedom - 1];
  constexpr double normal = 1.959964;
  return normal + (normal * normal * normal + normal) / (4.0 * static_cast<double>(freedom));
}

}  // namespace

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_error_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  return values.size() < 2 ? 0.0 : std::sqrt(squares_about_mean(values) / ((n - 1.0) * n));
}

Difference difference(const std::vector<double>& a, const std::vector<double>& b) {
  const auto na = static_cast<double>(a.size()), nb = static_cast<double>(b.size());
  const std::size_t freedom = a.size() + b.size() - 2;
  Difference d;
  d.value = mean_of(b) - mean_of(a);
  if (freedom == 0) return {d.value, HUGE_VAL, HUGE_VAL};
  const double variance = (squares_about_mean(a) + squares_about_mean(b)) / static_cast<double>(freedom);
  d.standard_error = std::sqrt(variance * (1.0 / na + 1.0 / nb));
  d.half_width = student(freedom) * d.standard_error;
  return d;
}

}  // namespace pulvis::study
