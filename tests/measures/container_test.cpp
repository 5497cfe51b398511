// SPDX-License-Identifier: Apache-2.0
#include "measures/container.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/failure.hpp"

namespace pulvis::measures {
namespace {

constexpr double pi = std::numbers::pi;

Container box(Vec3 up) { return {.min = {1, 2, 3}, .max = {2, 4, 6}, .up = up}; }

Container cylinder(Vec3 up) {
  return {.shape = Container::Shape::cylinder,
          .base = {1, 1, 1},
          .axis = {0, 0.6, 0.8},
          .radius = 2,
          .height = 5,
          .up = up};
}

TEST(DieFrame, OfABoxWithUpAlongZIsTheBoxItself) {
  const DieFrame frame(box({0, 0, 9.81}));
  EXPECT_EQ(frame.origin(), (Vec3{1, 2, 3}));
  EXPECT_EQ(frame.size(), (Vec3{1, 2, 3}));
  EXPECT_EQ(frame.axes()[0], (Vec3{1, 0, 0}));
  EXPECT_EQ(frame.axes()[1], (Vec3{0, 1, 0}));
  EXPECT_EQ(frame.axes()[2], (Vec3{0, 0, 1}));
  EXPECT_EQ(DieFrame(box({})).axes(), frame.axes());  // no gravity
}

TEST(DieFrame, PutsTheFloorOppositeToUp) {
  for (const Vec3 up : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1},
                        Vec3{0, 0, -1}, Vec3{0.1, -0.2, 3}}) {
    const Container container = box(up);
    const DieFrame frame(container);
    const auto& axes = frame.axes();
    EXPECT_EQ(cross(axes[0], axes[1]), axes[2]);
    EXPECT_GT(dot(axes[2], up), 0.0);
    // All of the box has coordinates between zero and the size.
    EXPECT_EQ(norm(frame.to_local(frame.origin())), 0.0);
    const Vec3 opposite = container.min + container.max - frame.origin();
    EXPECT_EQ(frame.to_local(opposite), frame.size());
    EXPECT_EQ(frame.to_container(frame.size()), opposite);
    EXPECT_DOUBLE_EQ(frame.volume_inside({{}, frame.size()}), volume(container));
  }
}

TEST(DieFrame, StandsACylinderOnTheEndThatIsLow) {
  for (const double sign : {1.0, -1.0}) {
    const Container container = cylinder(sign * Vec3{0, 0, 9.81});
    const DieFrame frame(container);
    EXPECT_EQ(frame.axes()[2], sign * container.axis);
    const Vec3 low_end = sign > 0 ? container.base : container.base + 5.0 * container.axis;
    EXPECT_NEAR(norm(frame.to_local(low_end) - Vec3{2, 2, 0}), 0.0, 1e-15);
    EXPECT_DOUBLE_EQ(frame.volume_inside({{}, frame.size()}), volume(container));
    EXPECT_DOUBLE_EQ(frame.volume_inside({{2, 0, 1}, {4, 4, 2}}), 2 * pi);
    EXPECT_DOUBLE_EQ(frame.area_inside({{2, 0, 1}, {4, 4, 2}}), 2 * pi);
    EXPECT_TRUE(frame.inside_or_above({2, 2, 99}));
    EXPECT_FALSE(frame.inside_or_above({2, 2, -0.1}));
    EXPECT_FALSE(frame.inside_or_above({0.1, 0.1, 1}));
  }
}

TEST(DieFrame, LaysACylinderWhoseAxisIsAcross) {
  const Container container{
      .shape = Container::Shape::cylinder, .base = {0, 0, 0}, .axis = {1, 0, 0}, .radius = 1, .height = 4};
  const DieFrame frame(container);
  EXPECT_EQ(frame.size(), (Vec3{4, 2, 2}));
  EXPECT_EQ(frame.origin(), (Vec3{0, -1, -1}));
  EXPECT_DOUBLE_EQ(frame.volume_inside({{}, {4, 2, 1}}), 2 * pi);
  EXPECT_DOUBLE_EQ(frame.area_inside({{}, {2, 1, 1}}), 2.0);
  EXPECT_TRUE(frame.inside_or_above({1, 0.1, 5}));
  EXPECT_FALSE(frame.inside_or_above({1, 0.1, 0.1}));
  EXPECT_TRUE(frame.inside_or_above({1, 1, 0.1}));
}

TEST(Container, HasItsBoundaryInside) {
  EXPECT_TRUE(is_inside(box({0, 0, 1}), {1, 4, 5}));
  EXPECT_FALSE(is_inside(box({0, 0, 1}), {1, 4.001, 5}));
  const Container upright{.shape = Container::Shape::cylinder, .radius = 2, .height = 1};
  EXPECT_TRUE(is_inside(upright, {0, 2, 1}));
  EXPECT_FALSE(is_inside(upright, {1.5, 1.5, 0.5}));
  EXPECT_FALSE(is_inside(upright, {0, 0, 1.01}));
  EXPECT_FALSE(is_inside(upright, {0, 0, -0.01}));
}

TEST(Container, WithoutAnInsideIsRefused) {
  Container flat = box({0, 0, 1});
  flat.max.y = flat.min.y;
  EXPECT_THROW(DieFrame{flat}, Failure);
  Container endless = box({0, 0, 1});
  endless.max.x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(DieFrame{endless}, Failure);
  Container thin = cylinder({0, 0, 1});
  thin.radius = 0;
  EXPECT_THROW(DieFrame{thin}, Failure);
  Container skewed = cylinder({0, 0, 1});
  skewed.axis = {1, 1, 1};
  EXPECT_THROW(DieFrame{skewed}, Failure);
}

}  // namespace
}  // namespace pulvis::measures
