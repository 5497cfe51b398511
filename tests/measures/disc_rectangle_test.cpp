// SPDX-License-Identifier: Apache-2.0
#include "measures/disc_rectangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "packings.hpp"
#include "quadrature.hpp"

namespace pulvis::measures {
namespace {

using packings::Uniform;
constexpr double pi = std::numbers::pi;

TEST(DiscRectangle, AgreesWithAWalkRoundTheRectangle) {
  Uniform uniform(1);
  const double places[] = {-1.0, -std::sqrt(0.5), -0.6, 0.0, 0.6, 0.8, 1.0};
  for (int trial = 0; trial < 20000; ++trial) {
    double side[4];
    for (double& s : side)
      s = uniform(0, 1) < 0.3 ? places[static_cast<int>(uniform(0, std::size(places)))] : uniform(-1.3, 1.3);
    const Rectangle r{least(side[0], side[1]), least(side[2], side[3]), greatest(side[0], side[1]),
                      greatest(side[2], side[3])};
    const double expected = static_cast<double>(oracle::disc_area(1, r.min_x, r.max_x, r.min_y, r.max_y));
    ASSERT_NEAR(disc_rectangle_area({0, 0, 1}, r), expected, 1e-14);
  }
}

TEST(DiscRectangle, ScalesAndMoves) {
  const double unit = disc_rectangle_area({0, 0, 1}, {-0.3, 0.2, 0.9, 1.1});
  EXPECT_NEAR(disc_rectangle_area({5, -7, 2}, {4.4, -6.6, 6.8, -4.8}), 4 * unit, 1e-14);
}

TEST(DiscRectangle, KnowsWholeHalfInsideAndOutside) {
  EXPECT_DOUBLE_EQ(disc_rectangle_area({0, 0, 2}, {-3, -3, 3, 3}), 4 * pi);
  EXPECT_DOUBLE_EQ(disc_rectangle_area({0, 0, 2}, {0, -3, 3, 3}), 2 * pi);
  EXPECT_EQ(disc_rectangle_area({0, 0, 2}, {-1, -1, 1, 0.5}), 3.0);
  EXPECT_EQ(disc_rectangle_area({0, 0, 1}, {0.8, 0.8, 2, 2}), 0.0);
  EXPECT_EQ(disc_rectangle_area({0, 0, 1}, {0, 0, 0, 1}), 0.0);
}

}  // namespace
}  // namespace pulvis::measures
