// SPDX-License-Identifier: Apache-2.0
#include "single_contact/numeric.hpp"

#include <gtest/gtest.h>

using namespace pulvis::single_contact;

namespace {

TEST(Numeric, BoundaryIsFoundToTheLastBitFromEitherSide) {
  EXPECT_NEAR(boundary([](double x) { return x * x < 2.0; }, 0.0, 3.0), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(boundary([](double x) { return x * x > 2.0; }, 3.0, 0.0), std::sqrt(2.0), 1e-15);
}

TEST(Numeric, LowestValueIsFoundInsideAndAtTheEnds) {
  EXPECT_NEAR(lowest_value([](double x) { return (x - 0.3) * (x - 0.3) - 1.0; }, 0.0, 1.0), -1.0, 1e-14);
  EXPECT_NEAR(lowest_value([](double x) { return std::abs(x - 1e-3) - 1.0; }, 0.0, 1.0), -1.0, 1e-12);
  EXPECT_EQ(lowest_value([](double x) { return x; }, -2.0, 1.0), -2.0);
}

TEST(Numeric, IntegralHoldsWithRootsAtTheEndsKinksAndTails) {
  EXPECT_NEAR(integral([](double x) { return std::sqrt(x); }, 0.0, 1.0), 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(integral([](double x) { return std::abs(x - 0.3); }, 0.0, 1.0), 0.045 + 0.245, 1e-9);
  // As Hamaker's: constant up to 0.001, then 1/x^2.
  const auto tail = [](double x) { return 1.0 / std::pow(std::max(x, 1e-3), 2); };
  EXPECT_NEAR(integral(tail, 0.0, 1.0), 1e3 + 1e3 - 1.0, 1e-5);
  EXPECT_EQ(integral(tail, 1.0, 1.0), 0.0);
}

}  // namespace
