// SPDX-License-Identifier: Apache-2.0
#include "engine/math/largest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pulvis;

namespace {

TEST(LargestBetween, FindsAPeakBetweenItsPoints) {
  EXPECT_NEAR(largest_between(0.0, 3.0, 7, [](double x) { return std::sin(x); }), 1.0, 1e-15);
  EXPECT_NEAR(largest_between(-1.0, 2.0, 16, [](double x) { return x * (1.0 - x * x); }),
              2.0 / std::sqrt(27.0), 1e-15);
}

TEST(LargestBetween, FindsTheHigherOfTwoPeaksThoughItsPointsSayOtherwise) {
  // The first peak lies on a point, the second, higher one, between two.
  const auto f = [](double x) {
    return std::exp(-200.0 * square(x - 0.25)) + 1.05 * std::exp(-200.0 * square(x - 0.7));
  };
  EXPECT_NEAR(largest_between(0.0, 1.0, 12, f), 1.05, 1e-9);
}

TEST(LargestBetween, LooksAtTheEndsAndJustInsideThem) {
  EXPECT_EQ(largest_between(0.0, 1.0, 5, [](double x) { return x; }), 1.0);
  EXPECT_EQ(largest_between(0.0, 1.0, 5, [](double x) { return -x; }), 0.0);
  EXPECT_NEAR(largest_between(0.0, 1.0, 5, [](double x) { return -square(x - 0.03); }), 0.0, 1e-16);
}

TEST(NearestWhole, RoundsTiesToEvenAndLeavesLargeNumbers) {
  for (const double x : {0.0, 0.4, -0.4, 0.5, -0.5, 1.5, 2.5, -2.5, 7.0, 1e15 + 0.25, -0x1p53, 1e300})
    EXPECT_EQ(nearest_whole(x), std::nearbyint(x)) << x;
  EXPECT_EQ(nearest_whole(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::infinity());
}

}  // namespace
