// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pulvis {

// Functions that advance the state of a simulation. The C library's versions choose among variants by
// processor and so differ in the last bit from machine to machine; these use + - * / and the square root
// only, compiled without fused multiply-add, and give the same bits everywhere. The errors stated are the
// largest seen in tests/math against long double; 1 ulp is the distance between neighbouring numbers.
// A NaN goes in and comes out.

/// sin(2 pi x), x in turns; any finite x. Exact at multiples of a quarter turn; error below 0.8 ulp.
double sine_of_cycles(double x);

/// cos(2 pi x), x in turns; any finite x. Exact at multiples of a quarter turn; error below 0.85 ulp.
double cosine_of_cycles(double x);

/// e^x; error below 0.7 ulp where the result is a normal number. Below -746 it is 0, above 709.78 infinite.
double exponential(double x);

/// Natural logarithm of a positive normal number; error below 0.6 ulp.
double logarithm(double x);

/// x^y for positive normal x and |y| < 1e300. Error below 1 ulp where |y log x| < 7 and below 6 ulp where it
/// is below 70; at the ends of the range (near 700) it reaches 50 ulp. power(x, 0) and power(1, y) are
/// exactly 1.
double power(double x, double y);

/// Share of a standard normal distribution below z: Phi(z). Error below 4e-16, and below 1e-13 of the value
/// itself down to z = -37.
double normal_cumulative(double z);

/// Quantile of the standard normal distribution: z with Phi(z) = p. Error below 2e-14 for
/// 1e-300 < p <= 1/2; above 1/2 the spacing of p itself limits it, as |dz| = 1.1e-16 / phi(z).
/// p <= 0 gives minus, p >= 1 plus infinity.
double inverse_normal(double p);

}  // namespace pulvis
