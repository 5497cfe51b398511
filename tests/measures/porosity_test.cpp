// SPDX-License-Identifier: Apache-2.0
#include "measures/porosity.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/base/failure.hpp"
#include "measures/periodic_images.hpp"
#include "measures/sphere_box.hpp"
#include "packings.hpp"

namespace pulvis::measures {
namespace {

using packings::Faces;
using packings::Uniform;
constexpr double pi = std::numbers::pi;

Container cube(double edge, double height) { return {.min = {0, 0, 0}, .max = {edge, edge, height}}; }

/// A surface at the same height everywhere, in columns that do not fit the cells.
FreeSurface flat_surface(const Container& container, double height) {
  FreeSurface surface = free_surface({}, {}, container, 0.37 * DieFrame(container).size().x);
  surface.heights.assign(surface.heights.size(), height);
  return surface;
}

/// Spheres anywhere in and a little beyond the unit cube, overlapping freely.
std::vector<Sphere> random_spheres(std::size_t count, double radius, std::uint64_t seed) {
  Uniform uniform(seed);
  std::vector<Sphere> spheres(count);
  for (Sphere& sphere : spheres)
    sphere = {{uniform(-0.1, 1.1), uniform(-0.1, 1.1), uniform(-0.1, 1.1)}, radius * uniform(0.5, 1.5)};
  return spheres;
}

TEST(Porosity, OfASimpleCubicPackingIsOneMinusPiOverSix) {
  const double d = 4.6e-6;
  const auto [spheres, contacts] = packings::simple_cubic(9, d);
  const Container container = cube(9 * d, 12 * d);
  const FreeSurface surface = free_surface(spheres, contacts, container, column_diameters * d);
  const PorosityField field = porosity(spheres, surface, container, cell_diameters * d);
  EXPECT_EQ(field.cells, (std::array<std::size_t, 3>{3, 3, 4}));
  EXPECT_NEAR(field.mean.value(), 1 - pi / 6, 1e-9);
  EXPECT_NEAR(field.standard_deviation.value(), 0.0, 1e-9);
  EXPECT_NEAR(field.total_volume / std::pow(9 * d, 3), 1.0, 1e-12);
  EXPECT_NEAR(field.total_solid / (729 * sphere_volume(d / 2)), 1.0, 1e-12);
  for (std::size_t cell = 0; cell < 36; ++cell) {
    if (cell < 27) {
      EXPECT_NEAR(field.values[cell], 1 - pi / 6, 1e-9);
    } else {
      EXPECT_TRUE(std::isnan(field.values[cell]));  // above the surface
      EXPECT_EQ(field.counted_volume[cell], 0.0);
    }
  }
}

TEST(Porosity, OfAPeriodicBodyCentredPackingIsExactInEveryCell) {
  const auto [spheres, contacts] = packings::body_centred(4, 1.0);
  const Container container = cube(4, 4);
  const auto all = periodic_images(spheres, {{0, 0, 0}, {4, 4, 4}}, {true, true, true}).spheres;
  for (const double edge : {4.0, 2.0, 1.0, 0.5}) {  // whole cells of the lattice, and its eighths
    const PorosityField field = porosity(all, flat_surface(container, 4.0), container, edge);
    EXPECT_NEAR(field.mean.value(), 1 - std::sqrt(3.0) / 8 * pi, 1e-12);
    for (const double value : field.values) EXPECT_NEAR(value, 1 - std::sqrt(3.0) / 8 * pi, 1e-12);
  }
}

TEST(Porosity, CountsTheHeapAboveTheDieOnlyAsSurface) {
  const auto [spheres, contacts] = packings::simple_cubic(6, 1.0);
  const Container low = cube(6, 3);
  const PorosityField field = porosity(spheres, free_surface(spheres, contacts, low, 2.0), low, 3.0);
  EXPECT_EQ(field.cells[2], 1u);
  EXPECT_NEAR(field.mean.value(), 1 - pi / 6, 1e-12);
  EXPECT_DOUBLE_EQ(field.total_volume, 108.0);
}

TEST(Porosity, TakesSolidAndVolumeFromTheSameRegionUnderAnUnevenSurface) {
  // One cell under columns of two heights: its counted part is two boxes, and what they hold is known.
  const auto spheres = random_spheres(200, 0.06, 7);
  const Container container = cube(1, 1);
  FreeSurface surface = free_surface({}, {}, container, 0.5);
  ASSERT_EQ(surface.heights.size(), 4u);
  surface.heights = {0.9, 0.45, 0.9, 0.45};
  const PorosityField field = porosity(spheres, surface, container, 1.0);
  const Box left{{0, 0, 0}, {0.5, 1, 0.9}}, right{{0.5, 0, 0}, {1, 1, 0.45}};
  const double solid =
      0.45 * solid_fraction_in_box(spheres, left) + 0.225 * solid_fraction_in_box(spheres, right);
  EXPECT_NEAR(field.total_volume, 0.675, 1e-15);
  EXPECT_NEAR(field.total_solid, solid, 1e-13);
  EXPECT_NEAR(field.mean.value(), 1 - solid / 0.675, 1e-13);
  EXPECT_EQ(field.standard_deviation.value(), 0.0);
}

TEST(Porosity, OfAllCellsTogetherIsThatOfTheDie) {
  const auto spheres = random_spheres(2000, 0.04, 8);
  const Container container = cube(1, 1);
  const Box box{container.min, container.max};
  for (const double edge : {1.0, 0.3, 0.11, 0.05}) {
    const PorosityField field = porosity(spheres, flat_surface(container, 2.0), container, edge);
    EXPECT_NEAR(field.mean.value(), 1 - solid_fraction_in_box(spheres, box), 1e-12);
  }
}

TEST(Porosity, LeavesOutCellsWithLessThanHalfButKeepsExactHalves) {
  const Container container = cube(3, 3);
  const auto counted = [&](double height) {
    return porosity({}, flat_surface(container, height), container, 1.0).total_volume;
  };
  EXPECT_DOUBLE_EQ(counted(1.5), 9 * 1.5);
  EXPECT_DOUBLE_EQ(counted(1.49), 9 * 1.0);
  EXPECT_DOUBLE_EQ(counted(1.51), 9 * 1.51);
  EXPECT_DOUBLE_EQ(counted(99), 27.0);
}

TEST(Porosity, SpreadIsWeightedByCountedVolume) {
  // Lower layer of cells: empty. Upper layer: each holds one sphere, and counts with 0.8 of its volume.
  const Container container = cube(2, 2);
  std::vector<Sphere> spheres;
  for (const double x : {0.5, 1.5})
    for (const double y : {0.5, 1.5}) spheres.push_back({{x, y, 1.4}, 0.3});
  const PorosityField field = porosity(spheres, flat_surface(container, 1.8), container, 1.0);
  const double low = 1 - sphere_volume(0.3) / 0.8;
  const double mean = (1.0 * 1.0 + 0.8 * low) / 1.8;
  EXPECT_NEAR(field.mean.value(), mean, 1e-14);
  EXPECT_NEAR(field.standard_deviation.value(),
              std::sqrt(((1 - mean) * (1 - mean) + 0.8 * (low - mean) * (low - mean)) / 1.8), 1e-14);
}

TEST(Porosity, OfACylinderCountsOnlyWhatIsWithinItsWall) {
  const Container round{.shape = Container::Shape::cylinder, .base = {3, 3, 0}, .radius = 3, .height = 6};
  std::vector<Sphere> spheres{{{3, 3, 1}, 0.5}, {{3, 3, 4}, 0.7}};
  const double solid = sphere_volume(0.5) + sphere_volume(0.7);
  const PorosityField whole = porosity(spheres, flat_surface(round, 6.0), round, 6.0);
  EXPECT_NEAR(whole.total_volume, 54 * pi, 1e-12);
  EXPECT_NEAR(whole.total_solid, solid, 1e-13);

  spheres.push_back({{0.3, 0.3, 1}, 0.2});  // in the corner of the grid, outside the wall
  EXPECT_EQ(porosity(spheres, flat_surface(round, 6.0), round, 6.0).total_solid, whole.total_solid);

  // Cells in the corners of a 6 x 6 grid have less than half inside: they are left out, the rest is exact.
  const PorosityField fine = porosity(spheres, flat_surface(round, 6.0), round, 1.0);
  EXPECT_TRUE(std::isnan(fine.values[0]));
  EXPECT_LT(fine.total_volume, 54 * pi);
  EXPECT_NEAR(fine.total_solid, solid, 1e-13);
}

TEST(Porosity, FollowsTheDieWhereverItStandsAndWhicheverWayIsUp) {
  const auto [spheres, contacts] = packings::simple_cubic(6, 1.0);
  std::vector<Sphere> turned;
  for (const Sphere& sphere : spheres)
    turned.push_back(
        {Vec3{10 - sphere.centre.z, sphere.centre.x, sphere.centre.y} + Vec3{0.25, 0.5, 0.125}, 0.5});
  const Container container{.min = {1.25, 0.5, 0.125}, .max = {10.25, 6.5, 6.125}, .up = {-1, 0, 0}};
  const FreeSurface surface = free_surface(turned, contacts, container, 2.0);
  EXPECT_NEAR(surface.mean, 6.0, 1e-14);
  const PorosityField field = porosity(turned, surface, container, 3.0);
  EXPECT_EQ(field.cells, (std::array<std::size_t, 3>{2, 2, 3}));
  EXPECT_NEAR(field.mean.value(), 1 - pi / 6, 1e-12);
  EXPECT_NEAR(field.total_volume, 216.0, 1e-11);
}

TEST(Porosity, HasTheSameBitsForOneAndForTwoThreads) {
  const auto spheres = random_spheres(20000, 0.02, 9);
  const Container container = cube(1, 1);
  FreeSurface surface = flat_surface(container, 0.7);
  surface.heights[2] = 0.4;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const PorosityField one = porosity(spheres, surface, container, 0.07);
  omp_set_num_threads(2);
  const PorosityField two = porosity(spheres, surface, container, 0.07);
  omp_set_num_threads(before);
  EXPECT_EQ(one.counted_volume, two.counted_volume);
  for (std::size_t i = 0; i < one.values.size(); ++i)
    if (one.counted_volume[i] > 0) {
      ASSERT_EQ(one.values[i], two.values[i]);
    }
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.standard_deviation, two.standard_deviation);
  EXPECT_EQ(one.total_solid, two.total_solid);
}

TEST(Porosity, OfAnEmptyDieHasNoMean) {
  const Container container = cube(3, 3);
  const PorosityField field = porosity({}, free_surface({}, {}, container, 1.0), container, 1.0);
  EXPECT_FALSE(field.mean.has_value());
  EXPECT_FALSE(field.standard_deviation.has_value());
  EXPECT_EQ(field.total_volume, 0.0);
  EXPECT_EQ(field.total_solid, 0.0);
  for (const double value : field.values) EXPECT_TRUE(std::isnan(value));
}

TEST(Porosity, OfADieSmallerThanACellHasOneCell) {
  const auto [spheres, contacts] = packings::simple_cubic(2, 1.0);
  const Container container = cube(2, 2);
  const PorosityField field =
      porosity(spheres, free_surface(spheres, contacts, container, 2.0), container, 30.0);
  EXPECT_EQ(field.values.size(), 1u);
  EXPECT_NEAR(field.mean.value(), 1 - pi / 6, 1e-14);
}

TEST(Porosity, RefusesBadInput) {
  const Container container = cube(1, 1);
  const FreeSurface surface = flat_surface(container, 1.0);
  for (const double edge : {0.0, -1.0, 1e-5, 1e-12, std::nan("")})
    EXPECT_THROW(porosity({}, surface, container, edge), Failure);
  const std::vector<Sphere> lost{{{0.5, 0.5, HUGE_VAL}, 0.5}};
  EXPECT_THROW(porosity(lost, surface, container, 1.0), Failure);
  EXPECT_THROW(porosity({}, FreeSurface{}, container, 1.0), std::invalid_argument);
  EXPECT_THROW(porosity({}, flat_surface(cube(2, 1), 1.0), container, 1.0), std::invalid_argument);
  EXPECT_THROW(solid_fraction_in_box({}, {{0, 0, 0}, {1, 0, 1}}), std::invalid_argument);
}

TEST(MeanDiameter, IsThatOfTheList) {
  EXPECT_EQ(mean_diameter({}), 0.0);
  const std::vector<Sphere> spheres{{{}, 1.0}, {{}, 2.0}};
  EXPECT_EQ(mean_diameter(spheres), 3.0);
}

}  // namespace
}  // namespace pulvis::measures
