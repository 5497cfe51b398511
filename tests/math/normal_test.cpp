// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "engine/math/functions.hpp"
#include "tests/math/ulp.hpp"

using pulvis::inverse_normal;
using pulvis::normal_cumulative;
using pulvis::validation::between;

namespace {

constexpr int samples = 100000;
constexpr double infinity = std::numeric_limits<double>::infinity();

long double true_cumulative(double z) { return 0.5L * std::erfc(-z / std::numbers::sqrt2_v<long double>); }

long double true_density(double z) {
  const long double exact = z;
  return std::exp(-0.5L * exact * exact) * std::numbers::inv_sqrtpi_v<long double> /
         std::numbers::sqrt2_v<long double>;
}

TEST(NormalCumulative, AgreesWithLongDoubleAsStated) {
  double worst = 0.0, worst_relative = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double z = i % 2 ? between(-37.0, 9.0, i) : between(-3.0, 3.0, i);
    const auto error = static_cast<double>(std::fabs(normal_cumulative(z) - true_cumulative(z)));
    worst = std::max(worst, error);
    worst_relative = std::max(worst_relative, error / static_cast<double>(true_cumulative(z)));
  }
  EXPECT_LT(worst, 4e-16);
  EXPECT_LT(worst_relative, 1e-13);
}

TEST(NormalCumulative, HoldsAtItsEnds) {
  EXPECT_EQ(normal_cumulative(0.0), 0.5);
  EXPECT_EQ(normal_cumulative(-infinity), 0.0);
  EXPECT_EQ(normal_cumulative(infinity), 1.0);
  EXPECT_TRUE(std::isnan(normal_cumulative(std::numeric_limits<double>::quiet_NaN())));
}

TEST(InverseNormal, SolvesForTheShareToTwoIn1e14) {
  double worst = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double p = i % 2 ? between(0.0, 0.5, i) : std::exp2(-between(1.0, 996.0, i));
    const double z = inverse_normal(p);
    worst = std::max(worst, static_cast<double>(std::fabs((true_cumulative(z) - p) / true_density(z))));
  }
  EXPECT_LT(worst, 2e-14);
}

TEST(InverseNormal, KnowsItsQuantiles) {
  EXPECT_EQ(inverse_normal(0.5), 0.0);
  EXPECT_NEAR(inverse_normal(0.975), 1.9599639845400545, 1e-14);
  EXPECT_NEAR(inverse_normal(1e-300), -37.047096299361199, 2e-14);
  EXPECT_EQ(inverse_normal(0.0), -infinity);
  EXPECT_EQ(inverse_normal(1.0), infinity);
  EXPECT_TRUE(std::isnan(inverse_normal(std::numeric_limits<double>::quiet_NaN())));
}

TEST(InverseNormal, IsOddAboutOneHalf) {
  for (int i = 0; i < 1000; ++i) {
    const double p = std::round(between(1.0, 511.0, i)) / 1024.0;
    EXPECT_EQ(inverse_normal(1.0 - p), -inverse_normal(p));
  }
}

}  // namespace
