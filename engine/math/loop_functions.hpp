// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/scalar.hpp"

// Functions that some contact laws need inside the loops over contacts: like those of scalar.hpp without
// branches and in plain arithmetic, so that the loops become vector code and give the same bits everywhere.
// Outside of loops those of functions.hpp are more exact. Errors stated are the largest seen in
// tests/math/loop_functions_test.cpp.
namespace pulvis {

/// Fifth root of a number from 1e-300 to 1e300 (0 gives 0); error below 1.5 ulp. As in inverse_cube_root the
/// first guess divides the exponent; Halley's method does the rest.
PULVIS_INLINE double fifth_root(double a) {
  const auto bits = __builtin_bit_cast(std::int64_t, a);
  const auto high = static_cast<std::int32_t>(bits >> 32);
  const auto fifth = static_cast<std::int32_t>(static_cast<double>(high) * 0.2);
  const auto guess = static_cast<std::int64_t>(fifth + 858024755) << 32;  // 4/5 of the exponent bias, shifted
  double x = __builtin_bit_cast(double, guess);
  for (int step = 0; step < 4; ++step) {
    const double square_of_x = x * x, power = square_of_x * square_of_x * x;
    x = x - x * ((power - a) / (3.0 * power + 2.0 * a));
  }
  return a > 0.0 ? x : 0.0;
}

/// e^x for |x| < 700; beyond, the value at the end of that range. Error below 1 ulp near 0, below 3 ulp
/// anywhere. k log 2 is taken out, the rest (at most 0.35) goes into Taylor's series to r^13.
PULVIS_INLINE double loop_exponential(double x) {
  constexpr double log_two_high = 0x1.62e42fefa38p-1, log_two_low = 5.497923018708371e-14;
  constexpr double shift = 0x1.8p52;  // leaves whole numbers in the lowest bits of the mantissa
  const double inside = least(greatest(x, -700.0), 700.0);
  const double shifted = inside * (1.0 / log_two_high) + shift;
  const double k = shifted - shift;
  const double r = (inside - k * log_two_high) - k * log_two_low;
  double series = 1.0 / 6227020800.0;
  constexpr double inverse_factorial[] = {1.0,
                                          1.0,
                                          1.0 / 2.0,
                                          1.0 / 6.0,
                                          1.0 / 24.0,
                                          1.0 / 120.0,
                                          1.0 / 720.0,
                                          1.0 / 5040.0,
                                          1.0 / 40320.0,
                                          1.0 / 362880.0,
                                          1.0 / 3628800.0,
                                          1.0 / 39916800.0,
                                          1.0 / 479001600.0};
  for (int n = 12; n >= 2; --n) series = inverse_factorial[n] + r * series;
  const double mantissa = 1.0 + (r + r * r * series);
  const auto exponent = static_cast<std::uint64_t>(__builtin_bit_cast(std::uint64_t, shifted) + 1023U) << 52;
  return mantissa * __builtin_bit_cast(double, exponent);
}

/// Natural logarithm of a positive normal number; error below 1.5 ulp of the larger of 1 and the result.
/// x = 2^k m with m from 1/sqrt 2 to sqrt 2, log m = 2 (s + s^3/3 + ...) with s = (m - 1)/(m + 1).
PULVIS_INLINE double loop_logarithm(double x) {
  constexpr double log_two_high = 0x1.62e42fefa38p-1, log_two_low = 5.497923018708371e-14;
  const auto bits = __builtin_bit_cast(std::uint64_t, x);
  const auto high = static_cast<std::int32_t>(bits >> 32);
  const double whole = __builtin_bit_cast(double, (bits & 0x000fffffffffffffU) | 0x3ff0000000000000U);
  const bool upper = whole > 1.4142135623730951;
  const double m = whole * select(upper, 0.5, 1.0);
  const double k = static_cast<double>((high >> 20) - 1023) + select(upper, 1.0, 0.0);
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s;
  double series = 0.0;
  constexpr double odd[] = {1.0 / 3.0,  1.0 / 5.0,  1.0 / 7.0,  1.0 / 9.0,  1.0 / 11.0,
                            1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0, 1.0 / 19.0, 1.0 / 21.0};
  for (int n = 9; n >= 0; --n) series = odd[n] + s2 * series;
  return k * log_two_high + (2.0 * s + (k * log_two_low + 2.0 * s * s2 * series));
}

/// sin x for |x| <= 2 (radians); error below 4e-16. Taylor's series to x^23.
PULVIS_INLINE double loop_sine(double x) {
  const double x2 = x * x;
  double series = 0.0;
  for (int n = 11; n >= 1; --n) series = (1.0 + series) * (-x2 / static_cast<double>(2 * n * (2 * n + 1)));
  return x + x * series;
}

/// cos x for |x| <= 2 (radians); error below 4e-16. Taylor's series to x^24.
PULVIS_INLINE double loop_cosine(double x) {
  const double x2 = x * x;
  double series = 0.0;
  for (int n = 12; n >= 1; --n) series = (1.0 + series) * (-x2 / static_cast<double>(2 * n * (2 * n - 1)));
  return 1.0 + series;
}

}  // namespace pulvis
