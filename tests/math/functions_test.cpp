// SPDX-License-Identifier: Apache-2.0
#include "engine/math/functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/math/ulp.hpp"

using pulvis::cosine_of_cycles;
using pulvis::exponential;
using pulvis::logarithm;
using pulvis::power;
using pulvis::sine_of_cycles;
using pulvis::validation::between;
using pulvis::validation::error_in_ulp;

namespace {

constexpr int samples = 300000;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// sin(2 pi x) in long double; the angle is brought near zero exactly, so that pi's rounding stays relative.
long double true_sine(double x) {
  constexpr long double two_pi = 2.0L * std::numbers::pi_v<long double>;
  long double turns = std::remainder(static_cast<long double>(x), 1.0L);
  if (turns > 0.25L) turns = 0.5L - turns;
  if (turns < -0.25L) turns = -0.5L - turns;
  const bool steep = std::fabs(turns) < 0.125L;
  if (steep) return std::sin(two_pi * turns);
  return std::copysign(std::cos(two_pi * (0.25L - std::fabs(turns))), turns);
}

long double true_cosine(double x) {
  const long double turns = std::fabs(std::remainder(static_cast<long double>(x), 1.0L));
  constexpr long double two_pi = 2.0L * std::numbers::pi_v<long double>;
  if (turns < 0.125L) return std::cos(two_pi * turns);
  if (turns > 0.375L) return -std::cos(two_pi * (0.5L - turns));
  return std::sin(two_pi * (0.25L - turns));
}

/// Turns of all sizes: one period, many periods, tiny.
double some_turns(int sample) {
  if (sample % 3 == 0) return between(-0.5, 0.5, sample);
  if (sample % 3 == 1) return between(-1e6, 1e6, sample);
  return between(-1.0, 1.0, sample) * std::exp2(-between(0.0, 300.0, sample, 1));
}

TEST(SineOfCycles, AgreesWithLongDoubleToOneUlp) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    worst = std::max(worst, error_in_ulp(sine_of_cycles(some_turns(i)), true_sine(some_turns(i))));
  }
  EXPECT_LT(worst, 0.8);
}

TEST(SineOfCycles, IsExactAtQuarterTurns) {
  for (const double turns : {0.0, 1.0, -7.0, 123456789.0, 0x1p52, 0x1p60}) {
    EXPECT_EQ(sine_of_cycles(turns), 0.0);
    EXPECT_EQ(cosine_of_cycles(turns), 1.0);
  }
  for (const double turns : {0.0, 5.0, -3.0, 0x1p40}) {
    EXPECT_EQ(sine_of_cycles(turns + 0.25), 1.0);
    EXPECT_EQ(sine_of_cycles(turns + 0.5), 0.0);
    EXPECT_EQ(sine_of_cycles(turns + 0.75), -1.0);
    EXPECT_EQ(cosine_of_cycles(turns + 0.25), 0.0);
    EXPECT_EQ(cosine_of_cycles(turns + 0.5), -1.0);
  }
}

TEST(SineOfCycles, IsOddAndRepeatsEachTurn) {
  for (int i = 0; i < 1000; ++i) {
    const double turns =
        std::ldexp(std::round(between(-1e6, 1e6, i)), -20);  // so that whole turns add exactly
    EXPECT_EQ(sine_of_cycles(-turns), -sine_of_cycles(turns));
    EXPECT_EQ(sine_of_cycles(turns + 1024.0), sine_of_cycles(turns));
    EXPECT_EQ(cosine_of_cycles(-turns), cosine_of_cycles(turns));
  }
}

TEST(SineOfCycles, OfNoNumberIsNoNumber) {
  for (const double turns : {not_a_number, infinity, -infinity}) {
    EXPECT_TRUE(std::isnan(sine_of_cycles(turns)));
    EXPECT_TRUE(std::isnan(cosine_of_cycles(turns)));
  }
}

TEST(CosineOfCycles, AgreesWithLongDoubleToOneUlp) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    worst = std::max(worst, error_in_ulp(cosine_of_cycles(some_turns(i)), true_cosine(some_turns(i))));
  }
  EXPECT_LT(worst, 0.85);
}

TEST(Exponential, AgreesWithLongDoubleToOneUlp) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double x = i % 2 ? between(-708.0, 709.7, i) : between(-1.0, 1.0, i);
    worst = std::max(worst, error_in_ulp(exponential(x), std::exp(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 0.7);
}

TEST(Exponential, HoldsAtTheEndsOfItsRange) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-745.0), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(exponential(-746.5), 0.0);
  EXPECT_EQ(exponential(-infinity), 0.0);
  EXPECT_TRUE(std::isfinite(exponential(709.78)));
  EXPECT_EQ(exponential(709.79), infinity);
  EXPECT_EQ(exponential(infinity), infinity);
  EXPECT_TRUE(std::isnan(exponential(not_a_number)));
}

TEST(Logarithm, AgreesWithLongDoubleToOneUlp) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double x = i % 3 == 0   ? std::exp2(between(-1022.0, 1023.9, i))
                     : i % 3 == 1 ? between(0.5, 2.0, i)
                                  : 1.0 + between(-1e-6, 1e-6, i);
    worst = std::max(worst, error_in_ulp(logarithm(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 0.6);
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_TRUE(std::isnan(logarithm(not_a_number)));
}

/// Largest error of power(x, y) in ulp, over powers with |y log x| below a bound.
double worst_power(double bound) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double x = i % 2 ? std::exp2(between(-1000.0, 1000.0, i)) : between(0.5, 2.0, i);
    const double y = between(-bound, bound, i, 1) / std::log(x);
    const long double truth = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    worst = std::max(worst, error_in_ulp(power(x, y), truth));
  }
  return worst;
}

TEST(Power, AgreesWithLongDoubleAsStated) {
  EXPECT_LT(worst_power(7.0), 1.0);
  EXPECT_LT(worst_power(70.0), 6.0);
  EXPECT_LT(worst_power(700.0), 50.0);
}

TEST(Power, IsExactWhereOneExpectsIt) {
  EXPECT_EQ(power(3.7, 0.0), 1.0);
  EXPECT_EQ(power(1.0, 1e299), 1.0);
  EXPECT_EQ(power(2.0, 10.0), 1024.0);
  EXPECT_EQ(power(4.0, 0.5), 2.0);
  EXPECT_EQ(power(10.0, 400.0), infinity);
  EXPECT_EQ(power(10.0, -400.0), 0.0);
  EXPECT_TRUE(std::isnan(power(not_a_number, 2.0)));
  EXPECT_TRUE(std::isnan(power(2.0, not_a_number)));
}

// If any of these bits changes, results computed earlier cannot be continued bit for bit.
TEST(Functions, GiveTheSameBitsOnEveryMachine) {
  EXPECT_EQ(sine_of_cycles(0.1), 0x1.2cf2304755a5ep-1);
  EXPECT_EQ(cosine_of_cycles(0.1), 0x1.9e3779b97f4a8p-1);
  EXPECT_EQ(exponential(0.1), 0x1.1aec7b35a00d4p+0);
  EXPECT_EQ(logarithm(0.1), -0x1.26bb1bbb55515p+1);
  EXPECT_EQ(power(0.1, 0.3), 0x1.009b9cf334253p-1);
}

}  // namespace
