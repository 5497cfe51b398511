// SPDX-License-Identifier: Apache-2.0
#include "measures/continuum.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <stdexcept>

#include "packings.hpp"
#include "pressed_beds.hpp"

namespace pulvis::measures {
namespace {

using packings::Uniform;

std::vector<Particle> random_particles(std::size_t count, std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<Particle> parcels(count);
  for (Particle& p : parcels) {
    p.position = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
    p.velocity = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    p.mass = uniform(1, 2);
  }
  return parcels;
}

TEST(Continuum, DensityAndMomentumIntegrateToMassAndMomentum) {
  const auto parcels = random_particles(20, 1);
  double mass = 0.0;
  Vec3 momentum;
  for (const Particle& p : parcels) {
    mass += p.mass;
    momentum += p.mass * p.velocity;
  }
  const std::size_t n = 60;  // cells of 0.05 over [-1, 2], the kernel's support being 1
  const auto points = grid_points({.min = {-1, -1, -1}, .max = {2, 2, 2}}, {n, n, n});
  const ContinuumFields fields = continuum_fields(points, parcels, {}, {}, 1.0);
  double all = 0.0;
  Vec3 moved;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all += fields.density[i];
    moved += fields.density[i] * fields.velocity[i];
  }
  const double cell = std::pow(3.0 / n, 3);
  EXPECT_NEAR(all * cell / mass, 1.0, 1e-6);  // the midpoint rule's error
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(moved[a] * cell, momentum[a], 1e-6 * mass);
}

TEST(Continuum, StressOfAUniformBedIsThePressureOfItsPlates) {
  // c = 3 d: inside, the lattice leaves ripples of below 0.002; over one of its cells they cancel.
  const double d = 1e-3;
  const Vec3 pressure{500, 480, 900};
  const auto bed = packings::pressed_bed(12, d, pressure);
  const auto points = grid_points({.min = {6 * d, 6 * d, 6 * d}, .max = {7 * d, 7 * d, 7 * d}}, {4, 4, 4});
  const ContinuumFields fields = continuum_fields(points, bed.parcels, bed.pairs, bed.walls, 3 * d);
  Tensor mean;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double expected = static_cast<int>(i) == j ? pressure[j] : 0.0;
        EXPECT_NEAR(fields.contact_stress[p].rows[i][j], expected, 0.002 * pressure[j]);
      }
    mean += (1.0 / 64) * fields.contact_stress[p];
    EXPECT_NEAR(fields.density[p] * d * d * d, 1.0, 0.002);
    EXPECT_EQ(fields.kinetic_stress[p].trace(), 0.0);
  }
  for (int j = 0; j < 3; ++j) EXPECT_NEAR(mean.rows[static_cast<std::size_t>(j)][j] / pressure[j], 1.0, 1e-6);
}

TEST(Continuum, StressIntegratesToForceTimesBranch) {
  // One pair and one contact with a wall: over all space, the sum of f (x) l of stress() times its volume.
  const std::vector<Particle> parcels{{{0, 0, 0}, {}, 1, 0.5}, {{0.6, 0.5, 0.4}, {}, 1, 0.5}};
  const std::vector<PairForce> pairs{{0, 1, {-3, 1, 2}, {-0.6, -0.5, -0.4}}};
  const std::vector<WallForce> walls{{0, {0, 0.5, 4}, {0, 0, 0.5}}};
  const std::size_t n = 60;
  const auto points = grid_points({.min = {-1.5, -1.5, -1.5}, .max = {1.5, 1.5, 1.5}}, {n, n, n});
  const ContinuumFields fields = continuum_fields(points, parcels, pairs, walls, 0.8);
  Tensor integral;
  for (const Tensor& value : fields.contact_stress) integral += std::pow(3.0 / n, 3) * value;
  const std::vector<std::uint8_t> all{1, 1};
  const Tensor whole = stress(parcels, all, pairs, walls, 1.0).contact;
  for (std::size_t i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(integral.rows[i][j], whole.rows[i][j], 1e-5);
}

TEST(Continuum, StressOfAStandingBedBalancesItsWeight) {
  // d stress_zj/dx_j = density g_z at any point farther than c from the walls, by differences over 0.02 d.
  const double d = 1.0, weight = 2.0, c = 3.0, h = 0.01;
  const auto bed = packings::pressed_bed(12, d, {5, 5, 1}, weight);
  Uniform uniform(4);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 at{uniform(4, 8), uniform(4, 8), uniform(4, 8)};
    std::vector<Vec3> points{at};
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-h, h}) {
        points.push_back(at);
        points.back()[axis] += side;
      }
    const ContinuumFields f = continuum_fields(points, bed.parcels, bed.pairs, bed.walls, c);
    Vec3 divergence;
    for (int j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t low = 1 + 2 * static_cast<std::size_t>(j);
        divergence[static_cast<int>(i)] +=
            (f.contact_stress[low + 1].rows[i][j] - f.contact_stress[low].rows[i][j]) / (2 * h);
      }
    const double expected = -weight * f.density[0];  // mass 1: weight is g
    EXPECT_NEAR(divergence.z / expected, 1.0, 1e-4);
    EXPECT_NEAR(divergence.x / expected, 0.0, 1e-4);
    EXPECT_NEAR(divergence.y / expected, 0.0, 1e-4);
  }
}

TEST(Continuum, KnowsTheSpreadOfVelocitiesAtAPoint) {
  const std::vector<Particle> two{{{0, 0, 0}, {3, 0, 0}, 2, 0.1}, {{0, 0, 0}, {0, 0, 0}, 1, 0.1}};
  const std::vector<Vec3> points{{0, 0, 0}, {5, 0, 0}};
  const ContinuumFields f = continuum_fields(points, two, {}, {}, 1.0);
  EXPECT_DOUBLE_EQ(f.velocity[0].x, 2.0);
  EXPECT_NEAR(f.kinetic_stress[0].rows[0].x / (f.density[0] / 3), 2 * 1 + 1 * 4, 1e-12);
  EXPECT_EQ(f.density[1], 0.0);
  EXPECT_EQ(f.velocity[1], Vec3{});
}

TEST(Continuum, FindsByCellsWhatASumOverAllFinds) {
  const auto parcels = random_particles(2000, 2);
  const auto points = grid_points({.min = {-0.2, 0, 0}, .max = {0.9, 1, 1.1}}, {7, 5, 6});
  const double c = 0.11, peak = 105 / (16 * 3.14159265358979323846);
  const ContinuumFields f = continuum_fields(points, parcels, {}, {}, c);
  for (std::size_t p = 0; p < points.size(); ++p) {
    double density = 0.0;
    for (const Particle& parcel : parcels) {
      const double x = norm(points[p] - parcel.position) / c;
      if (x < 1) density += parcel.mass * peak / (c * c * c) * (1 + 3 * x) * std::pow(1 - x, 3);
    }
    EXPECT_NEAR(f.density[p], density, 1e-9 * (1 + density));
  }
}

TEST(Continuum, HasTheSameBitsForOneAndForTwoThreads) {
  const auto bed = packings::pressed_bed(8, 1.0, {1, 2, 3}, 0.3);
  const auto points = grid_points({.max = {8, 8, 8}}, {9, 9, 9});
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const ContinuumFields one = continuum_fields(points, bed.parcels, bed.pairs, bed.walls, 2.5);
  omp_set_num_threads(2);
  const ContinuumFields two = continuum_fields(points, bed.parcels, bed.pairs, bed.walls, 2.5);
  omp_set_num_threads(before);
  EXPECT_EQ(one.density, two.density);
  EXPECT_EQ(one.contact_stress, two.contact_stress);
}

TEST(Continuum, RefusesBadInput) {
  const std::vector<Particle> one{{}};
  const std::vector<Vec3> points{{}};
  const std::vector<PairForce> pair{{0, 1, {}, {}}};
  EXPECT_THROW(continuum_fields(points, one, pair, {}, 1.0), std::out_of_range);
  EXPECT_THROW(continuum_fields(points, one, {}, {}, 0.0), std::invalid_argument);
  EXPECT_TRUE(continuum_fields({}, one, {}, {}, 1.0).density.empty());
}

}  // namespace
}  // namespace pulvis::measures
