// SPDX-License-Identifier: Apache-2.0
#include "measures/layers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/base/failure.hpp"
#include "packings.hpp"
#include "pressed_beds.hpp"

namespace pulvis::measures {
namespace {

TEST(Layers, OfAStandingBedKnowItsDensityContactsAndTheWeightAbove) {
  const std::uint32_t n = 6;
  const double d = 2.0, weight = 3.0;
  const auto bed = packings::pressed_bed(n, d, {5, 6, 7}, weight);
  const Container die{.max = {n * d, n * d, n * d}};
  const Layers up = layers(bed.parcels, bed.pairs, bed.walls, die, 2, d);  // a layer of parcels in each
  ASSERT_EQ(up.position.size(), n);
  for (std::size_t k = 0; k < n; ++k) {
    EXPECT_DOUBLE_EQ(up.position[k], d * (static_cast<double>(k) + 0.5));
    EXPECT_EQ(up.count[k], 36u);
    EXPECT_DOUBLE_EQ(up.volume[k], 144 * d);
    EXPECT_NEAR(up.density[k], 1 / (d * d * d), 1e-12);
    EXPECT_DOUBLE_EQ(up.mean_diameter[k], d);
    const bool end = k == 0 || k + 1 == n;
    EXPECT_NEAR(up.coordination[k], (120.0 + 36 * (end ? 1 : 2)) / 36, 1e-12);
    EXPECT_NEAR(up.contact_stress[k].rows[0].x, 5.0, 1e-12);
    EXPECT_NEAR(up.contact_stress[k].rows[1].y, 6.0, 1e-12);
    const double parcels_above = n - 0.5 - static_cast<double>(k);  // half of its own: at the middle
    EXPECT_NEAR(up.contact_stress[k].rows[2].z, 7 + parcels_above * weight / (d * d), 1e-12);
    EXPECT_EQ(up.temperature[k], 0.0);
  }
}

TEST(Layers, ShareOutSpheresAcrossTheirEdgesExactly) {
  const std::vector<Particle> one{{{1, 1, 1.25}, {}, 3.0, 0.5}};
  const Container die{.max = {2, 2, 4}};
  const Layers up = layers(one, {}, {}, die, 2, 1.0);
  const double cap = std::numbers::pi * 0.25 * 0.25 * (3 * 0.5 - 0.25) / 3;
  const double sphere = std::numbers::pi / 6;
  EXPECT_NEAR(up.density[0], 3 * cap / sphere / 4, 1e-12);
  EXPECT_NEAR(up.density[1], 3 * (1 - cap / sphere) / 4, 1e-12);
  EXPECT_EQ(up.count, (std::vector<std::size_t>{0, 1, 0, 0}));
  EXPECT_EQ(up.density[2], 0.0);
  EXPECT_TRUE(std::isnan(up.velocity[0].x));
  EXPECT_TRUE(std::isnan(up.temperature[0]));
  EXPECT_TRUE(std::isnan(up.coordination[0]));
  EXPECT_EQ(up.mean_diameter[1], 1.0);
}

TEST(Layers, OfAShearedGasKnowVelocityAndTemperature) {
  // v_x = 10 z and, about it, velocities uniform in +-1: temperature 1/3. The relative error of a mean square
  // of n numbers uniform in +-1 is sqrt(4/5/n).
  packings::Uniform uniform(8);
  const std::size_t n = 100'000;
  std::vector<Particle> gas(n);
  for (Particle& p : gas) {
    p.position = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
    const double layer = std::floor(p.position.z * 4);
    p.velocity = {10 * layer + uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    p.mass = 2.0;
  }
  const Layers up = layers(gas, {}, {}, {.max = {1, 1, 1}}, 2, 0.25);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto count = static_cast<double>(up.count[k]);
    const double u = 10.0 * static_cast<double>(k);
    EXPECT_NEAR(up.velocity[k].x, u, 4 * std::sqrt(1 / 3.0 / count));
    EXPECT_NEAR(up.temperature[k] * 3, 1.0, 4 * std::sqrt(0.8 / 3 / count));
    EXPECT_NEAR(square(up.speed_rms[k]), dot(up.velocity[k], up.velocity[k]) + 3 * up.temperature[k],
                1e-9 * (1 + u * u));
    EXPECT_NEAR(up.kinetic_stress[k].trace(), 3 * up.temperature[k] * up.density[k], 1e-6 * up.density[k]);
    EXPECT_NEAR(up.density[k], 8 * count, 1e-6);
  }
}

TEST(Layers, LieAlongTheAxisAskedForInsideTheDieOnly) {
  const std::vector<Particle> two{{{0.5, 0.5, 0.5}, {1, 0, 0}, 1, 0.1}, {{0.5, 0.5, 5}, {9, 0, 0}, 1, 0.1}};
  const Layers along = layers(two, {}, {}, {.max = {2, 1, 1}}, 0, 1.0);
  EXPECT_EQ(along.count, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(along.velocity[0], (Vec3{1, 0, 0}));
}

TEST(Layers, RefuseBadInput) {
  const Container die{.max = {1, 1, 1}};
  const std::vector<PairForce> pair{{0, 1, {}, {}}};
  EXPECT_THROW(layers({}, {}, {}, die, 3, 0.1), std::invalid_argument);
  EXPECT_THROW(layers({}, {}, {}, die, 2, 0.0), Failure);
  EXPECT_THROW(layers({}, pair, {}, die, 2, 0.1), std::out_of_range);
}

}  // namespace
}  // namespace pulvis::measures
