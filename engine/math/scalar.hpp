// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

// Inlining is forced because one call left in a law loop makes the compiler give up on vectorising it.
#define PULVIS_INLINE [[gnu::always_inline]] inline constexpr

namespace pulvis {

// The vocabulary of contact laws: + - * / and these. None of them branches, so loops over contacts
// become vector code, and each gives the same bits on every machine.

inline constexpr double pi = 3.14159265358979323846;

PULVIS_INLINE double select(bool condition, double yes, double no) { return condition ? yes : no; }
PULVIS_INLINE double least(double a, double b) { return a < b ? a : b; }
PULVIS_INLINE double greatest(double a, double b) { return a > b ? a : b; }
PULVIS_INLINE double magnitude(double a) { return a < 0.0 ? -a : a; }
PULVIS_INLINE double square(double a) { return a * a; }

/// Nearest whole number. Adding 2^52 pushes the fraction out of the mantissa; larger numbers are whole.
PULVIS_INLINE double nearest_whole(double x) {
  const double shift = x < 0.0 ? -0x1p52 : 0x1p52;
  return magnitude(x) < 0x1p52 ? (x + shift) - shift : x;
}

/// Square root; IEEE 754 rounds it correctly, so no library version can differ.
PULVIS_INLINE double root(double a) { return __builtin_sqrt(a); }

/// a^(-1/3) of a number from 1e-307 to 5e307 in plain arithmetic; error below 1.1 ulp. The first guess divides the exponent
/// by three in the bit pattern (error below 3.5 %); two steps with a series of fourth order do the rest (2e-5, rounding). No
/// step divides: a division keeps the processor as long as a dozen multiplications.
PULVIS_INLINE double inverse_cube_root(double a) {
  const auto bits = __builtin_bit_cast(std::int64_t, a);
  const auto high = static_cast<std::int32_t>(bits >> 32);
  const auto third = static_cast<std::int32_t>(static_cast<double>(high) * (1.0 / 3.0));
  const auto guess = static_cast<std::int64_t>(1430188164 - third)
                     << 32;  // 4/3 of the exponent bias, shifted
  double x = __builtin_bit_cast(double, guess);
  for (int step = 0; step < 2; ++step) {
    const double rest = 1.0 - a * (x * x * x);  // x (1 - rest)^(-1/3) would be exact
    x = x + x * (rest * (1.0 / 3.0 + rest * (2.0 / 9.0 + rest * (14.0 / 81.0))));
  }
  return x;
}

/// Cube root of a number from 1e-307 to 5e307 (0 gives 0) in plain arithmetic; error below 1 ulp. Newton's step at the end takes
/// off what rounding left.
PULVIS_INLINE double cube_root(double a) {
  const double inverse = inverse_cube_root(a), square = inverse * inverse, x = a * square;
  return a > 0.0 ? x - (x * x * x - a) * (square * (1.0 / 3.0)) : 0.0;
}

}  // namespace pulvis
