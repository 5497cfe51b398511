// SPDX-License-Identifier: Apache-2.0
#include "measures/sphere_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "packings.hpp"
#include "quadrature.hpp"

namespace pulvis::measures {
namespace {

using packings::Uniform;
constexpr double pi = std::numbers::pi;

/// Compares with quadrature, relative to the sphere's volume, and checks the bounds.
void expect_exact(const Sphere& sphere, const Box& box) {
  const double volume = sphere_box_volume(sphere, box);
  const double expected = oracle::sphere_box_volume(sphere, box);
  const Vec3 width = box.max - box.min;
  ASSERT_NEAR(volume / sphere_volume(sphere.radius), expected / sphere_volume(sphere.radius), 1e-12)
      << "radius " << sphere.radius << ", centre " << sphere.centre.x << ' ' << sphere.centre.y << ' '
      << sphere.centre.z << ", box " << box.min.x << ' ' << box.min.y << ' ' << box.min.z << " to "
      << box.max.x << ' ' << box.max.y << ' ' << box.max.z;
  ASSERT_GE(volume, 0.0);
  ASSERT_LE(volume, sphere_volume(sphere.radius));
  ASSERT_LE(volume, width.x * width.y * width.z);
}

TEST(SphereBox, AgreesWithAdaptiveQuadratureForRandomBoxes) {
  Uniform uniform(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double radius = std::exp2(uniform(-20.0, 4.0));
    const Vec3 centre = radius * Vec3{uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = centre[axis] + radius * uniform(-1.2, 1.2);
      const double b = centre[axis] + radius * uniform(-1.2, 1.2);
      box.min[axis] = least(a, b);
      box.max[axis] = greatest(a, b);
    }
    expect_exact({centre, radius}, box);
  }
}

TEST(SphereBox, AgreesWithQuadratureForBoxesMuchSmallerThanTheSphere) {
  Uniform uniform(2);
  for (int trial = 0; trial < 300; ++trial) {
    // Round a point near the surface, so that most of these boxes are cut.
    Vec3 point{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    point = point / norm(point);
    const double size = std::exp2(uniform(-14.0, -2.0));
    const Vec3 half{size * uniform(0.1, 1), size * uniform(0.1, 1), size * uniform(0.1, 1)};
    expect_exact({{}, 1.0}, {point - half, point + half});
  }
}

TEST(SphereBox, AgreesWithQuadratureWherePlanesEdgesAndCornersAreDegenerate) {
  // Sides on the centre, tangent, on each other's meeting points with the sphere, and a hair beside them.
  const double half = std::sqrt(0.5), third = std::sqrt(1.0 / 3.0);
  Uniform uniform(3);
  const double places[] = {-1.5, -1.0, -0.8, -half, -0.6, -third, 0.0, third, 0.6, half, 0.8, 1.0, 1.5};
  const auto pick = [&] { return places[static_cast<int>(uniform(0, std::size(places)))]; };
  const double hairs[] = {0.0, 0.0, 0.0, 1e-16, -1e-15, 1e-13, -1e-11, 1e-9, -1e-7};
  const auto hair = [&] { return hairs[static_cast<int>(uniform(0, std::size(hairs)))]; };
  int tested = 0;
  while (tested < 2000) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = pick() + hair(), b = pick() + hair();
      box.min[axis] = least(a, b);
      box.max[axis] = greatest(a, b);
    }
    if (box.min.x >= box.max.x || box.min.y >= box.max.y || box.min.z >= box.max.z) continue;
    expect_exact({{}, 1.0}, box);
    ++tested;
  }
}

TEST(SphereBox, KnowsTheClosedFormsOfCapHalfQuarterAndEighth) {
  const double far = 10.0;
  const Sphere unit{{}, 1.0};
  const double whole = 4.0 / 3.0 * pi;
  EXPECT_DOUBLE_EQ(sphere_box_volume(unit, {{-far, -far, -far}, {far, far, far}}), whole);
  EXPECT_DOUBLE_EQ(sphere_box_volume(unit, {{0, -far, -far}, {far, far, far}}), whole / 2);
  EXPECT_DOUBLE_EQ(sphere_box_volume(unit, {{-far, -far, -far}, {far, 0, 0}}), whole / 4);
  EXPECT_DOUBLE_EQ(sphere_box_volume(unit, {{-far, 0, -far}, {0, far, 0}}), whole / 8);
  for (const double x : {-0.999, -0.5, -1e-9, 1e-9, 0.25, 0.5, 0.999}) {
    const double cap = pi / 3 * (1 - x) * (1 - x) * (2 + x);
    EXPECT_NEAR(sphere_box_volume(unit, {{-far, x, -far}, {far, far, far}}), cap, 4e-16 * whole);
    EXPECT_NEAR(sphere_box_volume(unit, {{-far, -far, -far}, {far, far, -x}}), cap, 4e-16 * whole);
  }
}

TEST(SphereBox, TakesInfiniteBounds) {
  const double none = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(sphere_box_volume({{1, 2, 3}, 0.5}, {{-none, -none, 3}, {none, none, none}}),
                   sphere_volume(0.5) / 2);
}

TEST(SphereBox, IsTheBoxInsideTheSphereAndTheSphereInsideTheBox) {
  EXPECT_EQ(sphere_box_volume({{1, 1, 1}, 2.0}, {{0.5, 0.5, 0.5}, {1.5, 1, 1.25}}), 1.0 * 0.5 * 0.75);
  EXPECT_EQ(sphere_box_volume({{1, 1, 1}, 0.5}, {{0, 0, 0}, {2, 2, 2}}), sphere_volume(0.5));
  EXPECT_EQ(sphere_box_volume({{1, 1, 1}, 1.0}, {{0, 0, 0}, {2, 2, 2}}), sphere_volume(1.0));  // six tangents
}

TEST(SphereBox, IsZeroApartTangentOrEmpty) {
  const Sphere unit{{}, 1.0};
  EXPECT_EQ(sphere_box_volume(unit, {{1, -1, -1}, {2, 1, 1}}), 0.0);
  EXPECT_EQ(sphere_box_volume(unit, {{0.9, 0.9, -1}, {2, 2, 1}}), 0.0);
  EXPECT_EQ(sphere_box_volume(unit, {{0.6, 0.6, 0.6}, {2, 2, 2}}), 0.0);
  EXPECT_EQ(sphere_box_volume(unit, {{0, 0, 0}, {0, 1, 1}}), 0.0);
  EXPECT_EQ(sphere_box_volume(unit, {{0.5, 0, 0}, {0.2, 1, 1}}), 0.0);
  EXPECT_EQ(sphere_box_volume({{}, 0.0}, {{-1, -1, -1}, {1, 1, 1}}), 0.0);
}

TEST(SphereBox, DoesNotDependOnTheNamesOrSignsOfTheAxes) {
  Uniform uniform(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 a{uniform(-1, 0.2), uniform(-1, 0.2), uniform(-1, 0.2)};
    const Vec3 b{uniform(0.2, 1), uniform(0.2, 1), uniform(0.2, 1)};
    const Sphere unit{{}, 1.0};
    const double volume = sphere_box_volume(unit, {a, b});
    EXPECT_NEAR(sphere_box_volume(unit, {{a.z, a.x, a.y}, {b.z, b.x, b.y}}), volume, 4e-15);
    EXPECT_NEAR(sphere_box_volume(unit, {-b, -a}), volume, 4e-15);
  }
}

TEST(SphereBox, PartsOfAGridAddUpToTheSphere) {
  Uniform uniform(5);
  for (const int cells : {1, 2, 3, 7, 16}) {
    for (int trial = 0; trial < 20; ++trial) {
      const Sphere sphere{{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}, uniform(0.3, 2.0)};
      const double edge = 6.5 / cells, start = -3.25;
      double sum = 0.0;
      for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j)
          for (int k = 0; k < cells; ++k)
            sum += sphere_box_volume(
                sphere, {{start + i * edge, start + j * edge, start + k * edge},
                         {start + (i + 1) * edge, start + (j + 1) * edge, start + (k + 1) * edge}});
      EXPECT_NEAR(sum / sphere_volume(sphere.radius), 1.0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace pulvis::measures
