// SPDX-License-Identifier: Apache-2.0
#include "measures/fill.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "packings.hpp"

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

TEST(FillState, OfASimpleCubicPackingIsThatOnPaper) {
  const auto [spheres, contacts] = packings::simple_cubic(4, 0.5);
  const std::vector<double> masses(64, 3.0);
  const Container die{.max = {2, 2, 5}};
  const FillState state = fill_state(spheres, masses, free_surface(spheres, contacts, die, 1.0), die);
  EXPECT_NEAR(state.volume, 8.0, 1e-12);
  EXPECT_NEAR(state.ratio, 0.4, 1e-12);
  EXPECT_NEAR(state.mass, 192.0, 1e-12);
  EXPECT_NEAR(state.density.value(), 24.0, 1e-12);
}

TEST(FillState, LeavesOutWhatStillFallsAndWhatStandsAboveTheDie) {
  auto [spheres, contacts] = packings::simple_cubic(4, 0.5);
  std::vector<double> masses(64, 3.0);
  const Container low{.max = {2, 2, 1}};
  const FillState heaped = fill_state(spheres, masses, free_surface(spheres, contacts, low, 1.0), low);
  EXPECT_EQ(heaped.ratio, 1.0);
  EXPECT_NEAR(heaped.density.value(), 24.0, 1e-12);

  const Container die{.max = {2, 2, 5}};
  spheres.push_back({{1, 1, 3}, 0.25});
  masses.push_back(100.0);
  EXPECT_NEAR(fill_state(spheres, masses, free_surface(spheres, contacts, die, 1.0), die).density.value(),
              24.0, 1e-12);
}

TEST(FillState, OfAnEmptyDieHasNoDensity) {
  const Container die{.max = {2, 2, 5}};
  const FillState state = fill_state({}, {}, free_surface({}, {}, die, 1.0), die);
  EXPECT_EQ(state.ratio, 0.0);
  EXPECT_FALSE(state.density.has_value());
  const std::vector<Sphere> one{{{}, 1}};
  EXPECT_THROW(fill_state(one, {}, free_surface({}, {}, die, 1.0), die), std::invalid_argument);
}

TEST(Fill, WantsOneMassForEachSphere) {
  const std::vector<Sphere> one{{{}, 1}};
  EXPECT_THROW(fill_inside(one, {}, Container{.max = {1, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
