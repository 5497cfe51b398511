// SPDX-License-Identifier: Apache-2.0
#include "measures/segregation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "packings.hpp"

namespace pulvis::measures {
namespace {

using packings::Uniform;

double mass_of(const Sphere& sphere) { return std::pow(sphere.radius, 3); }

Segregation of(const std::vector<Sphere>& spheres, const Container& die, double edge) {
  std::vector<double> masses;
  for (const Sphere& sphere : spheres) masses.push_back(mass_of(sphere));
  return segregation(spheres, masses, die, edge);
}

/// A cubic lattice of 12 with radii 0.5 below and 0.25 above.
std::vector<Sphere> unmixed() {
  auto spheres = packings::simple_cubic(12, 1.0).spheres;
  for (Sphere& sphere : spheres) sphere.radius = sphere.centre.z > 6 ? 0.25 : 0.5;
  return spheres;
}
const Container die{.max = {12, 12, 12}};

TEST(Segregation, OfEqualSpheresIsNone) {
  const Segregation result = of(packings::simple_cubic(12, 1.0).spheres, die, 4.0);
  EXPECT_EQ(result.spheres, 1728u);
  EXPECT_EQ(result.cells, 27u);
  EXPECT_DOUBLE_EQ(result.mean_diameter.value(), 1.0);
  EXPECT_NEAR(result.index.value(), 0.0, 1e-12);
  EXPECT_EQ(result.intensity.value(), 0.0);
}

TEST(Segregation, OfTwoSizesInTwoHalvesIsWhole) {
  const Segregation result = of(unmixed(), die, 6.0);
  EXPECT_NEAR(result.intensity.value(), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(result.of_spheres, 0.0625);
  EXPECT_DOUBLE_EQ(result.of_cells, 0.0625);
  // Of the mass, 8/9 is in spheres of diameter 1: all of the lower half, and 7/18 of 9/18 of the upper.
  EXPECT_NEAR(result.mean_diameter.value(), 8.0 / 9 + 0.5 / 9, 1e-12);
  EXPECT_NEAR(result.lower.value(), 1.0, 1e-12);
  EXPECT_NEAR(result.upper.value(), 7.0 / 9 + 0.5 * 2 / 9, 1e-12);
  EXPECT_NEAR(result.index.value(), -(1.0 / 9) / (17.0 / 18), 1e-12);

  auto turned = unmixed();
  for (Sphere& sphere : turned) sphere.centre.z = 12 - sphere.centre.z;
  EXPECT_NEAR(of(turned, die, 6.0).index.value(), 2.0 / 17, 1e-12);
}

TEST(Segregation, OfRandomOrderIsWhatRandomMixingGives) {
  // Over shuffles s^2 is s_r^2 in the mean, each off by about sqrt(2/K) of it.
  Uniform uniform(17);
  auto spheres = unmixed();
  for (Sphere& sphere : spheres) sphere.radius = uniform(0.2, 0.5);
  const int shuffles = 400;
  double sum = 0.0, largest = 0.0, at_random = 0.0;
  for (int i = 0; i < shuffles; ++i) {
    for (std::size_t k = spheres.size() - 1; k > 0; --k)
      std::swap(spheres[k].radius,
                spheres[static_cast<std::size_t>(uniform(0, static_cast<double>(k + 1)))].radius);
    const Segregation result = of(spheres, die, 4.0);
    sum += result.of_cells;
    largest = std::max(largest, result.intensity.value());
    at_random = result.at_random;
    EXPECT_LT(std::abs(result.index.value()), 0.05);
  }
  EXPECT_NEAR(sum / shuffles / at_random, 1.0, 4 * std::sqrt(2.0 / 27 / shuffles));
  EXPECT_LT(largest, 0.03);  // s_r^2 is 26/1727 of s_0^2
}

TEST(Segregation, CountsWhatIsInTheDieOnly) {
  auto spheres = unmixed();
  spheres.push_back({{5, 5, 20}, 7.0});
  EXPECT_EQ(of(spheres, die, 6.0).index, of(unmixed(), die, 6.0).index);
  EXPECT_EQ(of(spheres, die, 6.0).intensity, of(unmixed(), die, 6.0).intensity);
}

TEST(Segregation, OfTooLittleSaysNothing) {
  const Segregation nothing = of({}, die, 6.0);
  EXPECT_FALSE(nothing.mean_diameter.has_value());
  EXPECT_FALSE(nothing.index.has_value());
  EXPECT_FALSE(nothing.intensity.has_value());
  const Segregation one = of({{{1, 1, 1}, 0.5}}, die, 6.0);
  EXPECT_EQ(one.index, 0.0);
  EXPECT_FALSE(one.intensity.has_value());
  const std::vector<Sphere> sphere{{{1, 1, 1}, 0.5}};
  EXPECT_THROW(segregation(sphere, {}, die, 6.0), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
