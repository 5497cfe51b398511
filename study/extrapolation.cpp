// SPDX-License-Identifier: Apache-2.0
#include "study/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace pulvis::study {
namespace {

/// The order that three samples show, the finest first; nothing if their differences do not stand out of the scatter
/// or no order within the limits fits.
std::optional<double> observed_order(const Sample& fine, const Sample& middle, const Sample& coarse) {
  const double near = middle.mean - fine.mean, far = coarse.mean - middle.mean;
  const auto scatter = [](const Sample& a, const Sample& b) {
    return 2.0 * std::hypot(a.standard_error, b.standard_error);
  };
  if (std::fabs(near) <= scatter(fine, middle) || std::fabs(far) <= scatter(middle, coarse) ||
      near * far <= 0.0)
    return {};
  // The ratio of differences grows with p: halve the interval.
  const auto ratio = [&](double p) {
    const auto grown = [p](const Sample& s) { return std::pow(s.factor, p); };
    return (grown(coarse) - grown(middle)) / (grown(middle) - grown(fine));
  };
  double low = lowest_order, high = highest_order;
  if (far / near < ratio(low) || far / near > ratio(high)) return {};
  for (int k = 0; k < 60; ++k) (ratio(0.5 * (low + high)) < far / near ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/// Straight line over x = alpha^p - 1 by least squares, each sample with equal weight.
void fit(const std::vector<Sample>& samples, Extrapolation& e) {
  const auto n = static_cast<double>(samples.size());
  const auto abscissa = [&](const Sample& s) { return std::pow(s.factor, e.order) - 1.0; };
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (const Sample& s : samples) mean_x += abscissa(s) / n, mean_y += s.mean / n;
  for (const Sample& s : samples) {
    xx += (abscissa(s) - mean_x) * (abscissa(s) - mean_x);
    xy += (abscissa(s) - mean_x) * (s.mean - mean_y);
  }
  e.growth = xy / xx;
  e.value = mean_y - e.growth * mean_x;
  double variance = 0.0;
  for (const Sample& s : samples) {
    const double weight = 1.0 / n - (abscissa(s) - mean_x) / xx * mean_x;  // of this sample in e.value
    variance += weight * weight * s.standard_error * s.standard_error;
  }
  e.scatter = 2.0 * std::sqrt(variance);
}

}  // namespace

double Extrapolation::error() const { return std::hypot(coarse_graining_error, scatter); }

Extrapolation extrapolate(std::vector<Sample> samples) {
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.factor < b.factor; });
  if (samples.size() < 2 || samples.front().factor == samples.back().factor)
    throw std::invalid_argument("an extrapolation needs two factors");
  Extrapolation e;
  if (samples.size() >= 3)
    if (const auto order = observed_order(samples[0], samples[1], samples[2])) {
      e.order = *order;
      e.order_observed = true;
      samples.resize(3);  // where the order was seen
    }
  fit(samples, e);
  e.coarse_graining_error =
      (e.order_observed ? observed_safety : assumed_safety) * std::fabs(samples.front().mean - e.value);
  return e;
}

}  // namespace pulvis::study
