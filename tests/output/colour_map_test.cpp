// SPDX-License-Identifier: Apache-2.0
#include "output/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pulvis {
namespace {

double lightness(const Colour& colour) {
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
  return 116.0 * std::cbrt(y) - 16.0;  // CIE L*, for Y above 0.009
}

TEST(ColourMap, IsTheKnownOneAtItsEnds) {
  EXPECT_FLOAT_EQ(viridis(0.0f).red, 0.267004f);
  EXPECT_FLOAT_EQ(viridis(1.0f).green, 0.906157f);
}

TEST(ColourMap, IsNearThePublishedTableBetweenItsControlColours) {
  // Entries 25, 76 and 230 of 255.
  const Colour low = viridis(25.0f / 255.0f), middle = viridis(76.0f / 255.0f),
               high = viridis(230.0f / 255.0f);
  EXPECT_NEAR(low.red, 0.282623f, 0.005f);
  EXPECT_NEAR(low.blue, 0.457517f, 0.005f);
  EXPECT_NEAR(middle.green, 0.371758f, 0.005f);
  EXPECT_NEAR(high.red, 0.741388f, 0.005f);
  EXPECT_NEAR(high.blue, 0.149561f, 0.01f);
}

// What makes it readable in grey and for the colour-blind.
TEST(ColourMap, GrowsEvenlyLighter) {
  const double whole = lightness(viridis(1.0f)) - lightness(viridis(0.0f));
  for (int i = 0; i < 20; ++i) {
    const float value = static_cast<float>(i) / 20.0f;
    const double step = lightness(viridis(value + 0.05f)) - lightness(viridis(value));
    EXPECT_GT(step, 0.5 * whole / 20.0) << value;
    EXPECT_LT(step, 1.5 * whole / 20.0) << value;
  }
}

TEST(ColourMap, ClampsAndShowsMissingValuesInGrey) {
  EXPECT_EQ(viridis(7.0f).red, viridis(1.0f).red);
  EXPECT_EQ(viridis(-1.0f).blue, viridis(0.0f).blue);
  const Colour none = viridis(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(none.red, none.green);
  EXPECT_EQ(none.green, none.blue);
}

}  // namespace
}  // namespace pulvis
