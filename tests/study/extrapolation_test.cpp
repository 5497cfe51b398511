// SPDX-License-Identifier: Apache-2.0
#include "study/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "study/statistics.hpp"

using namespace pulvis::study;

namespace {

double law(double alpha, double order) { return 0.6 + 0.003 * (std::pow(alpha, order) - 1.0); }

std::vector<Sample> samples(double order, double standard_error = 0.0) {
  std::vector<Sample> list;
  for (const double alpha : {8.0, 4.0, 6.0}) list.push_back({alpha, law(alpha, order), standard_error});
  return list;
}

TEST(Extrapolation, FindsTheOrderAndTheValueOfGrains) {
  for (const double order : {0.6, 1.0, 1.7, 2.9}) {
    const Extrapolation e = extrapolate(samples(order));
    EXPECT_TRUE(e.order_observed);
    EXPECT_NEAR(e.order, order, 1e-9);
    EXPECT_NEAR(e.value, 0.6, 1e-12);
    EXPECT_NEAR(e.growth, 0.003, 1e-12);
    EXPECT_NEAR(e.coarse_graining_error, 1.25 * (law(4.0, order) - 0.6), 1e-12);
  }
}

TEST(Extrapolation, AssumesTheFirstOrderWhereScatterHidesItOrItCannotBeBelieved) {
  const Extrapolation hidden = extrapolate(samples(1.7, 0.02));
  EXPECT_FALSE(hidden.order_observed);
  EXPECT_EQ(hidden.order, 1.0);
  EXPECT_GT(hidden.scatter, 0.01);
  EXPECT_GT(hidden.error(), hidden.scatter);
  EXPECT_FALSE(extrapolate(samples(4.0)).order_observed);
  EXPECT_FALSE(extrapolate({{4, 0.6}, {6, 0.7}, {8, 0.65}}).order_observed) << "to and fro";
}

TEST(Extrapolation, TakesTwoFactorsAsAStraightLineWithThreeTimesTheDifference) {
  const Extrapolation e = extrapolate({{4, 0.63}, {7, 0.66}});
  EXPECT_NEAR(e.value, 0.60, 1e-12);
  EXPECT_NEAR(e.error(), 0.09, 1e-12);
  EXPECT_THROW(extrapolate({{4, 0.63}}), std::invalid_argument);
}

TEST(Extrapolation, GivesTheScatterOfTheValueThatOfItsSamples) {
  // From x = 3 and 6 to 0: the value is 2 a - b.
  const Extrapolation e = extrapolate({{4, 0.63, 0.01}, {7, 0.66, 0.02}});
  EXPECT_NEAR(e.scatter, 2.0 * std::sqrt(4 * 1e-4 + 4e-4), 1e-12);
}

TEST(Statistics, OfADifferenceAreThoseOfStudentsTest) {
  // W. S. Gosset's sleep data (Biometrika 6 (1908) 1-25): t = 1.8608 with 18 degrees of freedom.
  const std::vector<double> first{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0},
      second{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const Difference d = difference(first, second);
  EXPECT_NEAR(d.value, 1.58, 1e-12);
  EXPECT_NEAR(d.value / d.standard_error, 1.8608, 1e-4);
  EXPECT_NEAR(d.half_width / d.standard_error, 2.101, 0.01);
  EXPECT_TRUE(std::isinf(difference({1.0}, {2.0}).half_width));
  EXPECT_NEAR(standard_error_of({1.0, 2.0, 3.0}), 1.0 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ(standard_error_of({1.0}), 0.0);
}

}  // namespace
