// SPDX-License-Identifier: Apache-2.0
#include "measures/fill.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace pulvis::measures {
namespace {

TEST(Fill, CountsSpheresWhoseCentreIsInside) {
  const std::vector<Sphere> spheres{{{0, 0, 0.5}, 1}, {{0, 0, 2.5}, 1}, {{0, 0, 3.1}, 1}, {{1.5, 1.5, 1}, 1}};
  const std::vector<double> masses{1, 2, 4, 8};
  const Container box{.min = {-2, -2, 0}, .max = {2, 2, 3}};
  const Fill in_box = fill_inside(spheres, masses, box);
  EXPECT_EQ(in_box.mass, 11.0);
  EXPECT_EQ(in_box.count, 3u);

  const Container round{.shape = Container::Shape::cylinder, .radius = 2, .height = 3};
  const Fill in_cylinder = fill_inside(spheres, masses, round);
  EXPECT_EQ(in_cylinder.mass, 3.0);
  EXPECT_EQ(in_cylinder.count, 2u);
}

TEST(Fill, OfNothingIsNothing) {
  const Fill nothing = fill_inside({}, {}, Container{.max = {1, 1, 1}});
  EXPECT_EQ(nothing.mass, 0.0);
  EXPECT_EQ(nothing.count, 0u);
}

TEST(Fill, WantsOneMassForEachSphere) {
  const std::vector<Sphere> one{{{}, 1}};
  EXPECT_THROW(fill_inside(one, {}, Container{.max = {1, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
