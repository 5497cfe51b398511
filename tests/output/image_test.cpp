// SPDX-License-Identifier: Apache-2.0
#include "output/image.hpp"

#include <gtest/gtest.h>

#include "output/typeface.hpp"

namespace pulvis {
namespace {

constexpr Colour white{1, 1, 1}, black{0, 0, 0};

double ink(const Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += 1.0 - image.at(x, y).green;
  return sum;
}

TEST(Image, CoversAsMuchAsALineIsLongAndThick) {
  Image image(100, 100, white);
  image.line(10, 50, 90, 50, 2.0, black);
  EXPECT_NEAR(ink(image), 80.0 * 2.0, 6.0);  // and its round ends, pi/4 of 2 x 2
  EXPECT_EQ(image.at(50, 50).red, 0.0f);
  EXPECT_EQ(image.at(50, 53).red, 1.0f);
}

TEST(Image, LeavesOutWhatLiesOutside) {
  Image image(10, 10, white);
  image.fill(-5, -5, 10, 10, black);
  EXPECT_DOUBLE_EQ(ink(image), 25.0);
  image.line(-100, 20, 200, 20, 3.0, black);
  image.blend(10, 0, black, 1.0f);
  EXPECT_DOUBLE_EQ(ink(image), 25.0);
}

TEST(Typeface, DrawsInkWithinTheWidthItPromises) {
  Typeface typeface;
  Image image(400, 60, white);
  typeface.draw(image, 20, 40, "100 µm", 24, black);
  const double width = typeface.width("100 µm", 24);
  EXPECT_GT(ink(image), 100.0);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 18; ++x) ASSERT_EQ(image.at(x, y).red, 1.0f);
    for (int x = static_cast<int>(22 + width); x < 400; ++x) ASSERT_EQ(image.at(x, y).red, 1.0f);
  }
}

TEST(Typeface, TakesALetterOfSeveralBytesForOne) {
  Typeface typeface;
  EXPECT_LT(typeface.width("µ", 40), 1.2 * typeface.width("u", 40));
  EXPECT_GT(typeface.width("\xC2", 40), 0.0);  // a broken letter is shown, not skipped or run over
}

}  // namespace
}  // namespace pulvis
