// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>

#include "engine/base/random.hpp"

namespace pulvis::validation {

/// Distance of a result from the truth, counted in the spacing of doubles near the truth.
inline double error_in_ulp(double result, long double truth) {
  if (truth == 0.0L) return result == 0.0 ? 0.0 : HUGE_VAL;
  int exponent = 0;
  std::frexp(truth, &exponent);
  return static_cast<double>(std::fabs(result - truth) / std::ldexp(1.0L, exponent - 53));
}

/// A repeatable random number between two bounds.
inline double between(double low, double high, std::uint64_t number, std::uint32_t draw = 0) {
  return low + (high - low) * uniform(20240601, 0, number, draw);
}

}  // namespace pulvis::validation
