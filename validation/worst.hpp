// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <limits>

#include "engine/math/vec3.hpp"

namespace pulvis::validation {

/// Raises `worst` to `error`; an error that is not a number counts as infinite and stays.
inline void raise(double& worst, double error) {
  if (!(error <= worst)) worst = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

/// What two runs differ by in a vector, over its size.
struct Scaled {
  double difference = 0.0, largest = 0.0;  ///< largest of all steps
  double differences = 0.0, sizes = 0.0;   ///< sums over the steps

  void add(const Vec3& a, const Vec3& b) {
    raise(difference, norm(a - b));
    raise(largest, norm(a));
    differences += norm(a - b);
    sizes += norm(a);
  }
  /// Largest difference over the largest size.
  double of_largest() const { return difference == 0.0 ? 0.0 : difference / largest; }
  /// Mean difference over the mean size: for forces, whose laws jump where a contact begins or breaks, sticks or
  /// slips, so that in some step of many a rounding may decide. One step of 10,000 that is off by a hundred
  /// thousandth still shows as 1e-9.
  double of_mean() const { return differences == 0.0 ? 0.0 : differences / sizes; }
};

}  // namespace pulvis::validation
