// SPDX-License-Identifier: Apache-2.0
// The functions of the loops over contacts against long double.
#include "engine/math/loop_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/draw.hpp"

using namespace pulvis;
using pulvis::validation::Draw;

namespace {

constexpr double ulp = 0x1p-52;

double relative_error(double value, long double truth) {
  return static_cast<double>(std::fabs((static_cast<long double>(value) - truth) / truth));
}

TEST(FifthRoot, IsExactToRoundingOver600Decades) {
  double worst = 0.0;
  for (std::uint64_t k = 0; k < 100000; ++k) {
    const double x = Draw(k, 41).decades(1e-300, 1e300);
    worst = std::max(worst, relative_error(fifth_root(x), std::pow(static_cast<long double>(x), 0.2L)));
  }
  EXPECT_LT(worst, 1.5 * ulp);
  EXPECT_EQ(fifth_root(0.0), 0.0);
}

TEST(LoopExponential, IsWithinThreeUlp) {
  double worst = 0.0, near_zero = 0.0;
  for (std::uint64_t k = 0; k < 100000; ++k) {
    const double x = Draw(k, 42).between(-699.0, 699.0), y = Draw(k, 43).between(-1.0, 1.0);
    worst = std::max(worst, relative_error(loop_exponential(x), std::exp(static_cast<long double>(x))));
    near_zero =
        std::max(near_zero, relative_error(loop_exponential(y), std::exp(static_cast<long double>(y))));
  }
  EXPECT_LT(worst, 3.0 * ulp);
  EXPECT_LT(near_zero, 1.0 * ulp);
  EXPECT_EQ(loop_exponential(0.0), 1.0);
}

TEST(LoopExponential, StaysFiniteBeyondItsRange) {
  EXPECT_TRUE(std::isfinite(loop_exponential(1e6)));
  EXPECT_GT(loop_exponential(-1e6), 0.0);
  EXPECT_LT(loop_exponential(-1e6), 1e-300);
}

TEST(LoopLogarithm, IsWithinOneAndAHalfUlp) {
  double worst = 0.0;
  for (std::uint64_t k = 0; k < 100000; ++k) {
    for (const double x : {Draw(k, 44).decades(1e-300, 1e300), Draw(k, 45).between(0.5, 2.0)}) {
      const long double truth = std::log(static_cast<long double>(x));
      const long double scale = std::max(1.0L, std::fabs(truth));
      worst = std::max(worst, static_cast<double>(std::fabs(loop_logarithm(x) - truth) / scale));
    }
  }
  EXPECT_LT(worst, 1.5 * ulp);
  EXPECT_EQ(loop_logarithm(1.0), 0.0);
}

TEST(LoopSineAndCosine, AreWithinRoundingUpToTwoRadians) {
  double sine = 0.0, cosine = 0.0;
  for (std::uint64_t k = 0; k < 100000; ++k) {
    const double x = Draw(k, 46).between(-2.0, 2.0);
    sine =
        std::max(sine, static_cast<double>(std::fabs(loop_sine(x) - std::sin(static_cast<long double>(x)))));
    cosine = std::max(cosine,
                      static_cast<double>(std::fabs(loop_cosine(x) - std::cos(static_cast<long double>(x)))));
  }
  EXPECT_LT(sine, 4e-16);
  EXPECT_LT(cosine, 4e-16);
}

}  // namespace
