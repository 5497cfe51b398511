// SPDX-License-Identifier: Apache-2.0
#include "engine/math/functions.hpp"

#include <array>
#include <cstdint>
#include <limits>

#include "engine/math/scalar.hpp"

namespace pulvis {
namespace {

// --- Error-free steps: results carried as the sum of two numbers ---------------------------------------

/// An unevaluated sum; |low| is at most half an ulp of `high`.
struct Pair {
  double high = 0.0, low = 0.0;
};

/// a + b without error, if |a| >= |b| or a = 0 (Dekker 1971).
Pair exact_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// The upper 26 bits of a number, so that products of such parts are exact (Veltkamp 1968).
double upper_half(double a) {
  const double scaled = a * (0x1p27 + 1.0);
  return scaled - (scaled - a);
}

/// a * b without error (Dekker 1971); |a|, |b| and the product below 1e300.
Pair exact_product(double a, double b) {
  const double product = a * b;
  const double a_upper = upper_half(a), b_upper = upper_half(b);
  const double a_lower = a - a_upper, b_lower = b - b_upper;
  const double error =
      ((a_upper * b_upper - product) + a_upper * b_lower + a_lower * b_upper) + a_lower * b_lower;
  return {product, error};
}

// --- Constants and series -------------------------------------------------------------------------------

constexpr Pair two_pi = {6.283185307179586, 2.4492935982947064e-16};
constexpr Pair log_two = {0x1.62e42fefa38p-1,
                          5.497923018708371e-14};  // upper part: 42 bits, so k * high is exact
constexpr double square_root_of_two_pi = 2.5066282746310002;

/// 1/n!, each correctly rounded, for n! is exact up to n = 22.
constexpr auto inverse_factorial = [] {
  std::array<double, 20> table{};
  double factorial = 1.0;
  for (int n = 0; n < 20; ++n) {
    if (n > 0) factorial *= n;
    table[n] = 1.0 / factorial;
  }
  return table;
}();

/// x * 2^k for |k| < 2000, in two steps so that results may be subnormal or infinite.
double scaled_by_power_of_two(double x, int k) {
  const auto power_of_two = [](int exponent) {
    return __builtin_bit_cast(double, static_cast<std::uint64_t>(exponent + 1023) << 52);
  };
  const int half = k / 2;
  return x * power_of_two(half) * power_of_two(k - half);
}

// --- Sine and cosine ------------------------------------------------------------------------------------

/// An angle as quarter turns (-2 to 2) and a rest of at most an eighth of a turn, in radians.
struct Reduced {
  double quarters = 0.0;
  Pair rest;
};

/// Both subtractions are exact, hence no angle is too large; only the product with 2 pi rounds.
Reduced reduce(double turns) {
  const double fraction = turns - nearest_whole(turns);
  const double quarters = nearest_whole(4.0 * fraction);
  const double rest = fraction - 0.25 * quarters;
  Pair angle = exact_product(rest, two_pi.high);
  angle.low += rest * two_pi.low;
  return {quarters, angle};
}

/// Taylor series of the sine to a^17 (the next term is below 8e-20), largest term last.
double sine(const Pair& a) {
  const double a2 = a.high * a.high;
  double series = 0.0;
  for (int k = 8; k >= 1; --k) series = (k % 2 ? -1.0 : 1.0) * inverse_factorial[2 * k + 1] + a2 * series;
  return a.high + (a.low * (1.0 - 0.5 * a2) + a.high * (a2 * series));
}

/// Taylor series of the cosine to a^16; 1 - a^2/2 is carried exactly.
double cosine(const Pair& a) {
  const Pair a2 = exact_product(a.high, a.high);
  double series = 0.0;
  for (int k = 8; k >= 2; --k) series = (k % 2 ? -1.0 : 1.0) * inverse_factorial[2 * k] + a2.high * series;
  const Pair head = exact_sum(1.0, -0.5 * a2.high);
  return head.high + (head.low - 0.5 * a2.low - a.high * a.low + a2.high * (a2.high * series));
}

// --- Exponential and logarithm --------------------------------------------------------------------------

/// e^(x.high + x.low) for |x.high| < 1100: k log 2 is taken out, the rest (at most 0.35) goes into Taylor's
/// series to r^14 (the next term is below 1e-19).
double exponential_of(const Pair& x) {
  const double k = nearest_whole(x.high * (1.0 / log_two.high));
  const Pair r = exact_sum(x.high - k * log_two.high, x.low - k * log_two.low);
  double series = 0.0;
  for (int n = 14; n >= 2; --n) series = inverse_factorial[n] + r.high * series;
  const Pair head = exact_sum(1.0, r.high);
  const double tail = head.low + (r.low * head.high + r.high * r.high * series);
  return scaled_by_power_of_two(head.high + tail, static_cast<int>(k));
}

/// log x to about 2^-58 of its value. x = 2^k m with m from 1/sqrt 2 to sqrt 2, and
/// log m = 2 artanh s = 2 (s + s^3/3 + s^5/5 + ...), s = (m - 1)/(m + 1), |s| < 0.172; the first term
/// is carried in two parts, the others are at most 1 % of it.
Pair logarithm_of(double x) {
  const auto bits = __builtin_bit_cast(std::uint64_t, x);
  double k = static_cast<double>(static_cast<int>(bits >> 52) - 1023);
  double m = __builtin_bit_cast(double, (bits & 0x000fffffffffffffU) | 0x3ff0000000000000U);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    k += 1.0;
  }

  const double above_one = m - 1.0;
  const Pair divisor = m < 1.0 ? exact_sum(1.0, m) : exact_sum(m, 1.0);
  const double s = above_one / divisor.high;
  const Pair back = exact_product(s, divisor.high);
  const double s_low = ((above_one - back.high) - back.low - s * divisor.low) / divisor.high;

  const double s2 = s * s;
  double series = 0.0;
  for (int n = 23; n >= 3; n -= 2) series = 1.0 / n + s2 * series;
  const Pair head = exact_sum(k * log_two.high, 2.0 * s);
  const double tail = head.low + (k * log_two.low + 2.0 * (s_low + s * (s2 * series)));
  return exact_sum(head.high, tail);
}

// --- Normal distribution --------------------------------------------------------------------------------

/// e^(z^2/2) times the integral of e^(-t^2/2) from 0 to z, by the series z + z^3/3 + z^5/(3*5) + ...; all
/// terms have one sign, so nothing cancels. For |z| < 2.5, where 44 terms leave less than 1e-17.
double scaled_centre(double z) {
  double series = 1.0;
  for (int k = 44; k >= 1; --k) series = 1.0 + series * (z * z / (2 * k + 1));
  return z * series;
}

/// e^(z^2/2) times the integral from z to infinity (Mills' ratio), by Laplace's continued fraction
/// 1/(z + 1/(z + 2/(z + 3/(z + ...)))). It is cut at a depth where, for z >= 2.5, replacing the rest by its
/// fixed point leaves less than 1e-16.
double scaled_tail(double z) {
  constexpr int depth = 60;
  double rest = 0.5 * (z + root(z * z + 4.0 * depth));
  for (int k = depth; k >= 1; --k) rest = z + k / rest;
  return 1.0 / rest;
}

constexpr double end_of_centre = 2.5;

/// First guess of the quantile for the upper tail share q <= 1/2, good to 9e-5: t - N(t)/D(t) with
/// t = sqrt(-2 log q). The coefficients are an own minimax fit to 1.17 < t < 38.
double rough_quantile(double q) {
  const double t = root(-2.0 * logarithm(q));
  const double above = 2.66552274748 + t * (1.62207134044 + t * 0.065323998404);
  const double below = 1.0 + t * (1.94283472995 + t * (0.47527430515 + t * 0.0102309100192));
  return t - above / below;
}

/// z >= 0 with the share q <= 1/2 above it. With d the miss of the guess divided by the density there,
/// Taylor's series of the quantile to d^4 leaves an error near 1e-15 in one step.
double upper_quantile(double q) {
  const double z = rough_quantile(q);
  const double inverse_density = square_root_of_two_pi * exponential(0.5 * z * z);
  const double d = z < end_of_centre ? (0.5 - q) * inverse_density - scaled_centre(z)
                                     : scaled_tail(z) - q * inverse_density;
  const double z2 = z * z;
  return z + d * (1.0 + d * (z / 2.0 + d * ((1.0 + 2.0 * z2) / 6.0 + d * (z * (7.0 + 6.0 * z2) / 24.0))));
}

}  // namespace

double sine_of_cycles(double x) {
  const Reduced angle = reduce(x);
  if (angle.quarters == 0.0) return sine(angle.rest);
  if (angle.quarters == 1.0) return cosine(angle.rest);
  if (angle.quarters == -1.0) return -cosine(angle.rest);
  return -sine(angle.rest);
}

double cosine_of_cycles(double x) {
  const Reduced angle = reduce(x);
  if (angle.quarters == 0.0) return cosine(angle.rest);
  if (angle.quarters == 1.0) return -sine(angle.rest);
  if (angle.quarters == -1.0) return sine(angle.rest);
  return -cosine(angle.rest);
}

double exponential(double x) {
  if (x > 710.0) return std::numeric_limits<double>::infinity();
  if (x < -746.0) return 0.0;
  if (x != x) return x;
  return exponential_of({x, 0.0});
}

double logarithm(double x) {
  if (x != x) return x;
  const Pair result = logarithm_of(x);
  return result.high + result.low;
}

double power(double x, double y) {
  if (x != x || x == 1.0) return x;
  const Pair exponent = logarithm_of(x);
  Pair product = exact_product(exponent.high, y);
  if (!(magnitude(product.high) < 746.0)) return exponential(product.high);
  product.low += exponent.low * y;
  return exponential_of(product);
}

double normal_cumulative(double z) {
  if (z != z) return z;
  const double distance = magnitude(z);
  const double density = exponential(-0.5 * z * z) / square_root_of_two_pi;
  if (distance < end_of_centre) return 0.5 + density * scaled_centre(z);
  const double tail = density > 0.0 ? density * scaled_tail(distance) : 0.0;
  return z < 0.0 ? tail : 1.0 - tail;
}

double inverse_normal(double p) {
  if (p <= 0.0) return -std::numeric_limits<double>::infinity();
  if (p >= 1.0) return std::numeric_limits<double>::infinity();
  if (p != p) return p;
  return p < 0.5 ? -upper_quantile(p) : upper_quantile(1.0 - p);
}

}  // namespace pulvis
