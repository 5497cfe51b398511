// SPDX-License-Identifier: Apache-2.0
#include "measures/lucy_kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "packings.hpp"

namespace pulvis::measures {
namespace {

/// Mean of f over [0, 1] by the midpoint rule.
template <class Function>
double mean(const Function& f, int n) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n);
  return sum / n;
}

TEST(LucyKernel, HasIntegralOneOverSpace) {
  const LucyKernel kernel(0.3);
  const auto shell = [&](double s) {
    return 4 * std::numbers::pi * std::pow(0.3, 3) * s * s * kernel.at(0.09 * s * s);
  };
  EXPECT_NEAR(mean(shell, 20000), 1.0, 1e-8);
}

TEST(LucyKernel, IsThatOnPaperAndEndsAtItsSupport) {
  const LucyKernel kernel(2.0);
  EXPECT_DOUBLE_EQ(kernel.at(0.0), 105 / (16 * std::numbers::pi * 8));
  EXPECT_DOUBLE_EQ(kernel.at(1.0), 105 / (16 * std::numbers::pi * 8) * 2.5 / 8);
  EXPECT_EQ(kernel.at(4.0), 0.0);
  EXPECT_EQ(kernel.at(5.0), 0.0);
}

TEST(LucyKernel, AlongALineIsItsMeanThere) {
  packings::Uniform uniform(5);
  const LucyKernel kernel(1.0);
  const auto any = [&](double size) {
    return Vec3{uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  };
  int seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Vec3 point = any(0.8), from = any(0.8), to = any(1.5);
    const auto value = [&](double s) {
      const Vec3 apart = point - (from + s * (to - from));
      return kernel.at(dot(apart, apart));
    };
    const double exact = kernel.along(point, from, to);
    EXPECT_NEAR(exact, mean(value, 4000), 2e-6);  // of a peak of 2.09: the midpoint rule's error
    EXPECT_NEAR(kernel.along(point, to, from), exact, 1e-13);
    if (exact > 0.0) ++seen;
  }
  EXPECT_GT(seen, 150);
}

TEST(LucyKernel, AlongALineThroughThePointIsThePolynomialsIntegral) {
  const LucyKernel kernel(1.0);
  const double peak = kernel.at(0.0);
  // Integral of 1 - 6 r^2 + 8 r^3 - 3 r^4 from 0 to 1: 0.4.
  EXPECT_NEAR(kernel.along({}, {0, 0, 0}, {0, 0, 1}), 0.4 * peak, 1e-14);
  EXPECT_NEAR(kernel.along({}, {0, 0, -2}, {0, 0, 2}), 0.8 * peak / 4, 1e-14);
  EXPECT_NEAR(kernel.along({1e-9, 0, 0}, {0, 0, -2}, {0, 0, 2}), 0.2 * peak, 1e-14);
  EXPECT_EQ(kernel.along({}, {0.5, 0, 0}, {0.5, 0, 0}), kernel.at(0.25));  // a line without length
  EXPECT_EQ(kernel.along({}, {1, -1, 0}, {1, 1, 0}), 0.0);
  EXPECT_EQ(kernel.along({}, {1.5, 0, 0}, {2.5, 0, 0}), 0.0);
}

TEST(LucyKernel, RefusesASupportThatIsNone) {
  for (const double support : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(LucyKernel{support}, std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
