// SPDX-License-Identifier: Apache-2.0
#include "measures/porosity_parts.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "measures/periodic_images.hpp"
#include "measures/sphere_box.hpp"
#include "packings.hpp"

namespace pulvis::measures {
namespace {

using packings::Uniform;
constexpr double pi = std::numbers::pi;
constexpr double cubic = 1 - pi / 6;

/// A packing with its surface and porosity in cells of `edge` diameters.
struct Scene {
  std::vector<Sphere> spheres;
  Container container;
  FreeSurface surface;
  PorosityField field;

  Scene(std::vector<Sphere> s, const Container& c, double surface_height, double edge)
      : spheres(std::move(s)), container(c), surface(free_surface({}, {}, c, 0.37 * DieFrame(c).size().x)) {
    surface.heights.assign(surface.heights.size(), surface_height);
    field = porosity(spheres, surface, container, edge);
  }
  PartPorosity in(const Box& part, std::span<const double> masses = {}) const {
    return part_porosity(spheres, masses, surface, container, field, part);
  }
};

Scene simple_cubic_scene() { return {packings::simple_cubic(6, 1.0).spheres, {.max = {6, 6, 10}}, 6.0, 2.0}; }

/// Spheres anywhere in and a little beyond the unit cube, overlapping freely.
Scene random_scene(std::size_t count) {
  Uniform uniform(11);
  std::vector<Sphere> spheres(count);
  for (Sphere& sphere : spheres)
    sphere = {{uniform(-0.1, 1.1), uniform(-0.1, 1.1), uniform(-0.1, 1.1)}, 0.03 * uniform(0.5, 1.5)};
  Scene scene(std::move(spheres), {.max = {1, 1, 1}}, 0.8, 0.2);
  scene.surface.heights[1] = 0.55;
  scene.field = porosity(scene.spheres, scene.surface, scene.container, 0.2);
  return scene;
}

TEST(PorosityProfiles, OfASimpleCubicPackingAreFlatAndEndAtTheSurface) {
  const auto profiles = porosity_profiles(simple_cubic_scene().field);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    EXPECT_EQ(profiles[axis].position, (std::vector<double>{1, 3, 5}));
    for (const double value : profiles[axis].porosity) EXPECT_NEAR(value, cubic, 1e-9);
    for (const double volume : profiles[axis].volume) EXPECT_NEAR(volume, 72.0, 1e-9);
  }
  const PorosityProfile& up = profiles[2];
  EXPECT_EQ(up.position, (std::vector<double>{1, 3, 5, 7, 9}));
  EXPECT_TRUE(std::isnan(up.porosity[4]));
  EXPECT_EQ(up.volume[4], 0.0);
  EXPECT_NEAR(std::accumulate(up.volume.begin(), up.volume.end(), 0.0), 216.0, 1e-9);
}

TEST(PorosityProfiles, WeighCellsByTheirCountedVolume) {
  const Scene scene = random_scene(500);
  for (const PorosityProfile& profile : porosity_profiles(scene.field)) {
    double solid = 0.0, volume = 0.0;
    for (std::size_t i = 0; i < profile.volume.size(); ++i)
      if (profile.volume[i] > 0.0) {
        solid += (1 - profile.porosity[i]) * profile.volume[i];
        volume += profile.volume[i];
      }
    EXPECT_NEAR(volume, scene.field.total_volume, 1e-12);
    EXPECT_NEAR(solid, scene.field.total_solid, 1e-12);
  }
}

TEST(PorosityHistogram, HasOneBinForAUniformPacking) {
  const Scene scene(packings::simple_cubic(6, 1.0).spheres, {.max = {6, 6, 6}}, 6.0, 2.0);
  const PorosityHistogram histogram = porosity_histogram(scene.field);
  ASSERT_EQ(histogram.share.size(), 1u);
  EXPECT_NEAR(histogram.share[0], 1.0, 1e-12);
  EXPECT_NEAR(histogram.edges[0], 0.47, 1e-15);  // 1 - pi/6 = 0.4764
  EXPECT_NEAR(histogram.edges[1], 0.48, 1e-15);
}

TEST(PorosityHistogram, SharesOutTheCountedVolume) {
  PorosityField field;
  field.values = {0.425, 0.415, 0.405, std::nan(""), 0.445};
  field.counted_volume = {2, 1, 1, 0, 4};
  field.total_volume = 8;
  const PorosityHistogram histogram = porosity_histogram(field);
  ASSERT_EQ(histogram.share, (std::vector<double>{0.125, 0.125, 0.25, 0.0, 0.5}));
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(histogram.edges[i], 0.40 + 0.01 * static_cast<double>(i), 1e-15);
  const PorosityHistogram coarse = porosity_histogram(field, 0.5);
  EXPECT_EQ(coarse.edges, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(coarse.share, (std::vector<double>{1.0}));
  EXPECT_TRUE(porosity_histogram(PorosityField{}).share.empty());
  for (const double width : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(porosity_histogram(field, width), std::invalid_argument);
}

TEST(PartPorosity, OfTheHalvesOfASimpleCubicPackingIsExact) {
  const Scene scene(packings::simple_cubic(6, 1.0).spheres, {.max = {6, 6, 6}}, 6.0, 2.0);
  const std::vector<double> masses(216, 2.0);
  const auto parts = halves(scene.container);
  EXPECT_EQ(parts[0].name, "lower half");
  EXPECT_EQ(parts[1].name, "upper half");
  EXPECT_EQ(parts[1].box.min, (Vec3{0, 0, 3}));
  EXPECT_EQ(parts[2].name, "first lower half");
  EXPECT_EQ(parts[2].box.max, (Vec3{3, 6, 6}));
  EXPECT_EQ(parts[5].name, "second upper half");
  for (const Part& part : parts) {
    const PartPorosity half = scene.in(part.box, masses);
    EXPECT_NEAR(half.porosity.value(), cubic, 1e-12);
    EXPECT_NEAR(half.volume, 108.0, 1e-12);
    EXPECT_NEAR(half.mass, 216.0, 1e-9);
    EXPECT_NEAR(half.density.value(), 2.0, 1e-12);
    EXPECT_NEAR(half.standard_deviation.value(), 0.0, 1e-12);
  }
}

TEST(PartPorosity, CutsSpheresExactly) {
  const Scene scene = simple_cubic_scene();
  const PartPorosity slab = scene.in({{0, 0, 0}, {6, 6, 0.25}});  // caps of height r/2
  EXPECT_NEAR(slab.volume, 9.0, 1e-12);
  EXPECT_NEAR(slab.solid, 36 * pi * 0.25 * 0.25 * (3 * 0.5 - 0.25) / 3, 1e-12);
  EXPECT_EQ(slab.mass, 0.0);
  EXPECT_FALSE(slab.standard_deviation.has_value());  // no cell has its middle there
}

TEST(PartPorosity, EndsAtTheSurfaceAndAtTheDie) {
  const Scene scene = simple_cubic_scene();
  const PartPorosity all = scene.in({{-10, -10, -10}, {10, 10, 10}});
  EXPECT_NEAR(all.volume, 216.0, 1e-12);
  EXPECT_NEAR(all.porosity.value(), cubic, 1e-12);
  EXPECT_NEAR(scene.in({{0, 0, 4.5}, {6, 6, 9}}).volume, 54.0, 1e-12);
  const PartPorosity above = scene.in({{0, 0, 7}, {6, 6, 9}});
  EXPECT_EQ(above.volume, 0.0);
  EXPECT_FALSE(above.porosity.has_value());
  EXPECT_FALSE(above.density.has_value());
  EXPECT_FALSE(scene.in({{7, 0, 0}, {9, 6, 9}}).porosity.has_value());
}

TEST(PartPorosity, OfOneCellIsThatOfTheCellUnderAnUnevenSurface) {
  const Scene scene = random_scene(3000);
  for (const std::size_t cell : {0u, 7u, 31u, 62u, 85u}) {
    if (!(scene.field.counted_volume[cell] > 0.0)) continue;
    const Vec3 low{0.2 * static_cast<double>(cell % 5), 0.2 * static_cast<double>(cell / 5 % 5),
                   0.2 * static_cast<double>(cell / 25)};
    const PartPorosity part = scene.in({low, low + Vec3{0.2, 0.2, 0.2}});
    EXPECT_NEAR(part.volume, scene.field.counted_volume[cell], 1e-12);
    EXPECT_NEAR(part.porosity.value(), scene.field.values[cell], 1e-9);
  }
}

TEST(PartPorosity, OfTwoHalvesAddsUpToTheWhole) {
  const Scene scene = random_scene(3000);
  const auto parts = halves(scene.container);
  const PartPorosity whole = scene.in({{0, 0, 0}, {1, 1, 1}});
  for (std::size_t i = 0; i < 6; i += 2) {
    const PartPorosity low = scene.in(parts[i].box), high = scene.in(parts[i + 1].box);
    EXPECT_NEAR(low.volume + high.volume, whole.volume, 1e-12);
    EXPECT_NEAR(low.solid + high.solid, whole.solid, 1e-12);
  }
  EXPECT_NEAR(scene.in({{0, 0, 0}, {1, 1, 1}}).standard_deviation.value(),
              scene.field.standard_deviation.value(), 1e-12);
}

TEST(PartPorosity, OfRandomSpheresApartIsThatOfTheirNumber) {
  // Exactly in the whole die; a half holds N/2 +- sqrt(N)/2 of spheres put anywhere (less if they keep apart).
  const std::size_t n = 2000;
  const double solid = static_cast<double>(n) * sphere_volume(0.03);
  const Scene scene(packings::random_apart(n, 0.03, 21), {.max = {1, 1, 1}}, 1.0, 0.1);
  EXPECT_NEAR(scene.in({{0, 0, 0}, {1, 1, 1}}).porosity.value(), 1 - solid, 1e-9);
  const double error = 4 * solid / std::sqrt(static_cast<double>(n));
  for (const Part& part : halves(scene.container))
    EXPECT_NEAR(scene.in(part.box).porosity.value(), 1 - solid, error) << part.name;
}

TEST(PartPorosity, OfAPeriodicBodyCentredPackingIsExactInAnyWholeCells) {
  const auto [spheres, contacts] = packings::body_centred(4, 1.0);
  const auto images = periodic_images(spheres, {{0, 0, 0}, {4, 4, 4}}, {true, true, true});
  std::vector<double> masses;
  for (std::size_t i = 0; i < images.spheres.size(); ++i) {
    ASSERT_LT(images.original[i], spheres.size());
    EXPECT_EQ(images.spheres[i].radius, spheres[images.original[i]].radius);
    masses.push_back(3.0);
  }
  const Scene scene(images.spheres, {.max = {4, 4, 4}}, 4.0, 1.0);
  const PartPorosity part = scene.in({{0, 1, 2}, {2, 2, 4}}, masses);
  EXPECT_NEAR(part.porosity.value(), 1 - std::sqrt(3.0) / 8 * pi, 1e-12);
  EXPECT_NEAR(part.mass, 4 * 2 * 3.0, 1e-9);  // two spheres in each of four cells
}

TEST(PartPorosity, OfACylinderKnowsItsWall) {
  const Container round{.shape = Container::Shape::cylinder, .base = {3, 3, 0}, .radius = 3, .height = 6};
  const Scene scene({{{3, 3, 1}, 0.5}, {{3, 3, 4}, 0.7}, {{0.3, 0.3, 1}, 0.2}}, round, 6.0, 1.0);
  const PartPorosity low = scene.in(halves(round)[0].box), high = scene.in(halves(round)[1].box);
  EXPECT_NEAR(low.volume, 27 * pi, 1e-12);
  EXPECT_NEAR(low.solid, sphere_volume(0.5), 1e-13);  // the third is outside the wall
  EXPECT_NEAR(high.solid, sphere_volume(0.7), 1e-13);
  EXPECT_NEAR(scene.in(halves(round)[2].box).volume, 27 * pi, 1e-12);
}

TEST(PartPorosity, HasTheSameBitsForOneAndForTwoThreads) {
  const Scene scene = random_scene(5000);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const PartPorosity one = scene.in({{0, 0, 0}, {0.5, 1, 1}});
  omp_set_num_threads(2);
  const PartPorosity two = scene.in({{0, 0, 0}, {0.5, 1, 1}});
  omp_set_num_threads(before);
  EXPECT_EQ(one.solid, two.solid);
  EXPECT_EQ(one.volume, two.volume);
}

TEST(PartPorosity, RefusesWhatDoesNotBelongTogether) {
  const Scene scene = simple_cubic_scene();
  const std::vector<double> few{1.0};
  EXPECT_THROW(scene.in({{0, 0, 0}, {1, 1, 1}}, few), std::invalid_argument);
  EXPECT_THROW(part_porosity({}, {}, FreeSurface{}, scene.container, scene.field, {}), std::invalid_argument);
  EXPECT_THROW(part_porosity({}, {}, scene.surface, scene.container, PorosityField{}, {}),
               std::invalid_argument);
}

TEST(CentresInPart, BelongToOneHalfEach) {
  const auto [spheres, contacts] = packings::simple_cubic(3, 1.0);  // centres at 0.5, 1.5, 2.5
  const Container container{.max = {3, 3, 3}};
  const auto parts = halves(container);
  const auto low = centres_in_part(spheres, container, parts[0].box);
  const auto high = centres_in_part(spheres, container, parts[1].box);
  EXPECT_EQ(std::accumulate(low.begin(), low.end(), 0), 9);
  EXPECT_EQ(std::accumulate(high.begin(), high.end(), 0), 18);
  for (std::size_t i = 0; i < spheres.size(); ++i) EXPECT_EQ(low[i] + high[i], 1);
  const std::vector<Sphere> lid{{{1, 1, 3}, 0.5}, {{1, 1, 3.1}, 0.5}};
  EXPECT_EQ(centres_in_part(lid, container, parts[1].box), (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace pulvis::measures
