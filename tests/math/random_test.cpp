// SPDX-License-Identifier: Apache-2.0
#include "engine/base/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace {

using Words = std::array<std::uint32_t, 4>;

Words philox(const Words& counter, std::array<std::uint32_t, 2> key) {
  const auto result =
      r123::Philox4x32{}({{counter[0], counter[1], counter[2], counter[3]}}, {{key[0], key[1]}});
  return {result[0], result[1], result[2], result[3]};
}

TEST(Philox, GivesItsAuthorsKnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Uniform, TakesItsBitsFromTheKnownAnswers) {
  EXPECT_EQ(pulvis::uniform(0, 0, 0, 0), std::ldexp(static_cast<double>(0x6627e8d5e169c58dU >> 11), -53));
  // seed = key, number = first half of the counter, then draw and stream
  EXPECT_EQ(pulvis::uniform(0x299f31d0a4093822U, 0x03707344, 0x85a308d3243f6a88U, 0x13198a2e),
            std::ldexp(static_cast<double>(0xd16cfe0994fdccebU >> 11), -53));
}

TEST(Uniform, DependsOnEachArgument) {
  const std::set<double> numbers = {
      pulvis::uniform(1, 2, 3, 4), pulvis::uniform(5, 2, 3, 4), pulvis::uniform(1ULL << 40, 2, 3, 4),
      pulvis::uniform(1, 5, 3, 4), pulvis::uniform(1, 2, 5, 4), pulvis::uniform(1, 2, 3 + (1ULL << 40), 4),
      pulvis::uniform(1, 2, 3, 5),
  };
  EXPECT_EQ(numbers.size(), 7U);
  EXPECT_EQ(pulvis::uniform(1, 2, 3, 4), pulvis::uniform(1, 2, 3, 4));
}

TEST(Uniform, FillsItsRangeEvenly) {
  constexpr int count = 100000, bins = 20;
  std::array<int, bins> hits{};
  double sum = 0.0;
  for (int i = 0; i < count; ++i) {
    const double number = pulvis::uniform(7, 0, i, 0);
    ASSERT_GE(number, 0.0);
    ASSERT_LT(number, 1.0);
    ++hits[static_cast<int>(number * bins)];
    sum += number;
  }
  EXPECT_NEAR(sum / count, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / count));
  for (const int hit : hits) EXPECT_NEAR(hit, count / bins, 5.0 * std::sqrt(count / bins));
}

}  // namespace
