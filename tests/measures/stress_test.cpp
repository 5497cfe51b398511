// SPDX-License-Identifier: Apache-2.0
#include "measures/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "pressed_beds.hpp"

namespace pulvis::measures {
namespace {

TEST(Stress, OfABedPressedOnAllSidesIsThePressureOfItsPlates) {
  // Spheres of diameter d in a cubic lattice; along each axis every chain carries the force P d^2.
  const double d = 2e-3;
  const Vec3 pressure{500, 480, 900};
  const auto bed = packings::pressed_bed(6, d, pressure);
  const std::vector<std::uint8_t> all(bed.parcels.size(), 1);
  const Stress result = stress(bed.parcels, all, bed.pairs, bed.walls, std::pow(6 * d, 3));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(result.contact.rows[static_cast<std::size_t>(i)][j], i == j ? pressure[i] : 0.0, 1e-9);
  EXPECT_NEAR(result.pressure(), 1880.0 / 3, 1e-9);
  EXPECT_EQ(result.kinetic_pressure(), 0.0);
}

TEST(Stress, OfPartOfABedCountsHalfOfTheBranchesAcrossItsEdge) {
  const double d = 1.0;
  const auto bed = packings::pressed_bed(6, d, {10, 20, 30});
  std::vector<std::uint8_t> lower(bed.parcels.size(), 0);
  for (std::size_t i = 0; i < lower.size() / 2; ++i) lower[i] = 1;
  const Stress result = stress(bed.parcels, lower, bed.pairs, bed.walls, 108.0);
  EXPECT_NEAR(result.contact.rows[0].x, 10.0, 1e-12);
  EXPECT_NEAR(result.contact.rows[2].z, 30.0, 1e-12);
}

TEST(Stress, OfPullingContactsIsNegativeAndOfShearIsOnItsSide) {
  const std::vector<Particle> two{{{1, 0, 0}, {}, 1, 0.5}, {{0, 0, 0}, {}, 1, 0.5}};
  const std::vector<std::uint8_t> all{1, 1};
  const std::vector<PairForce> pull{{0, 1, {-3, 2, 0}, {1, 0, 0}}};
  const Stress result = stress(two, all, pull, {}, 2.0);
  EXPECT_EQ(result.contact.rows[0].x, -1.5);
  EXPECT_EQ(result.contact.rows[1].x, 1.0);  // force along the second axis, branch along the first
  EXPECT_EQ(result.contact.rows[0].y, 0.0);
}

TEST(Stress, OfAGasIsItsMassTimesTheSpreadOfItsVelocities) {
  const std::vector<Particle> gas{
      {{}, {5 + 1, 2, 0}, 2, 0.1}, {{}, {5 - 2, 2, 0}, 1, 0.1}, {{}, {100, 0, 0}, 9, 0.1}};
  const std::vector<std::uint8_t> counted{1, 1, 0};
  const Stress result = stress(gas, counted, {}, {}, 0.5);
  EXPECT_EQ(result.mean_velocity, (Vec3{5, 2, 0}));
  EXPECT_DOUBLE_EQ(result.kinetic.rows[0].x, (2 * 1 + 1 * 4) / 0.5);
  EXPECT_EQ(result.kinetic.rows[1].y, 0.0);
  EXPECT_DOUBLE_EQ(result.kinetic_pressure(), 4.0);
  EXPECT_DOUBLE_EQ(result.pressure(), 4.0);
}

TEST(Tensor, TurnsIntoOtherAxes) {
  const Tensor a = outer({1, 2, 3}, {4, 5, 6});
  const std::array<Vec3, 3> axes{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  EXPECT_EQ(along_axes(a, axes), outer({2, 3, 1}, {5, 6, 4}));
}

TEST(Stress, OfNothingIsNone) {
  const Stress result = stress({}, {}, {}, {}, 1.0);
  EXPECT_EQ(result.pressure(), 0.0);
}

TEST(Stress, RefusesBadInput) {
  const std::vector<Particle> one{{}};
  const std::vector<std::uint8_t> mark{1};
  const std::vector<PairForce> pair{{0, 1, {}, {}}};
  const std::vector<WallForce> wall{{1, {}, {}}};
  EXPECT_THROW(stress(one, mark, pair, {}, 1.0), std::out_of_range);
  EXPECT_THROW(stress(one, mark, {}, wall, 1.0), std::out_of_range);
  EXPECT_THROW(stress(one, {}, {}, {}, 1.0), std::invalid_argument);
  EXPECT_THROW(stress(one, mark, {}, {}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
