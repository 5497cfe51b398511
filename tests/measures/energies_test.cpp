// SPDX-License-Identifier: Apache-2.0
#include "measures/energies.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

TEST(Energies, OfTwoBodiesAreThoseOnPaper) {
  const std::vector<Body> bodies{{{1, 2, 3}, {1, 2, 2}, {0, 0, 4}, 2.0, 0.5},
                                 {{0, 0, -1}, {}, {3, 0, 4}, 4.0, 0.2}};
  const Energies all = energies(bodies, {0, 0, -10});
  EXPECT_DOUBLE_EQ(all.translational, 9.0);
  EXPECT_DOUBLE_EQ(all.rotational, 4.0 + 2.5);
  EXPECT_DOUBLE_EQ(all.potential, 2 * 10 * 3 - 4 * 10 * 1);
  EXPECT_DOUBLE_EQ(all.kinetic(), 15.5);
  EXPECT_DOUBLE_EQ(energies(bodies, {0, 0, -10}, {5, 5, -1}).potential, 2 * 10 * 4);
  EXPECT_DOUBLE_EQ(energies(bodies, {3, 0, 0}).potential, -6.0);
}

TEST(Energies, OfNothingAreZero) {
  const Energies all = energies({}, {0, 0, -9.81});
  EXPECT_EQ(all.kinetic(), 0.0);
  EXPECT_EQ(all.potential, 0.0);
}

TEST(PairwiseSum, KeepsSmallTermsThatARunningSumLoses) {
  // 2^24 times 0.1: a running sum is wrong in the tenth digit, halving only in the last.
  const std::size_t count = std::size_t{1} << 24;
  const double sum = pairwise_sum(count, [](std::size_t) { return 0.1; });
  EXPECT_NEAR(sum / (0.1 * static_cast<double>(count)), 1.0, 1e-15);
  EXPECT_EQ(pairwise_sum(0, [](std::size_t) { return 1.0; }), 0.0);
}

}  // namespace
}  // namespace pulvis::measures
