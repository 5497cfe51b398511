// SPDX-License-Identifier: Apache-2.0
#include "measures/flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "packings.hpp"

namespace pulvis::measures {
namespace {

using Ids = std::vector<std::uint32_t>;
using Places = std::vector<Vec3>;
const FlowSurface plane{.point = {0, 0, 1}, .normal = {0, 0, 2}};

/// What one parcel of mass 1 counts that goes from one place to another.
std::int64_t count(const FlowSurface& surface, const Vec3& from, const Vec3& to, const Vec3& period = {}) {
  FlowMeter meter(surface, period);
  meter.look(Ids{7}, Places{from}, std::vector<double>{1});
  meter.look(Ids{7}, Places{to}, std::vector<double>{1});
  return meter.flow().count();
}

TEST(Flow, CountsBothWaysAndTheNetMass) {
  FlowMeter meter(plane);
  const std::vector<double> masses{1, 2, 4};
  meter.look(Ids{3, 5, 8}, Places{{0, 0, 0}, {9, 9, 2}, {0, 0, 0}}, masses);
  EXPECT_EQ(meter.flow().count(), 0);
  const Flow now = meter.look(Ids{3, 5, 8}, Places{{0, 0, 3}, {9, 9, 0}, {1, 1, 0.9}}, masses);
  EXPECT_EQ(now.forward_count, 1u);
  EXPECT_EQ(now.backward_count, 1u);
  EXPECT_EQ(now.forward_mass, 1.0);
  EXPECT_EQ(now.backward_mass, 2.0);
  EXPECT_EQ(meter.flow().mass(), -1.0);
  const Flow later = meter.look(Ids{3, 5, 8}, Places{{0, 0, 3}, {9, 9, 0}, {1, 1, 1.1}}, masses);
  EXPECT_EQ(later.mass(), 4.0);
  EXPECT_EQ(meter.flow().mass(), 3.0);
  EXPECT_EQ(meter.flow().count(), 1);
}

TEST(Flow, CountsOnceWhoStopsOnTheSurface) {
  FlowMeter meter(plane);
  const std::vector<double> mass{1};
  for (const double z : {0.0, 1.0, 1.0, 2.0}) meter.look(Ids{0}, Places{{0, 0, z}}, mass);
  EXPECT_EQ(meter.flow().forward_count, 1u);
  EXPECT_EQ(meter.flow().backward_count, 0u);
  for (const double z : {1.0, 0.0}) meter.look(Ids{0}, Places{{0, 0, z}}, mass);
  EXPECT_EQ(meter.flow().backward_count, 1u);
  EXPECT_EQ(meter.flow().count(), 0);
}

TEST(Flow, DoesNotCountWhoIsNewOrGone) {
  FlowMeter meter(plane);
  meter.look(Ids{1, 4}, Places{{0, 0, 0}, {0, 0, 0}}, std::vector<double>{1, 1});
  meter.look(Ids{2, 4, 6}, Places{{0, 0, 5}, {0, 0, 0}, {0, 0, 5}}, std::vector<double>{1, 1, 1});
  EXPECT_EQ(meter.flow().count(), 0);
  meter.look(Ids{1, 4}, Places{{0, 0, 5}, {0, 0, 5}}, std::vector<double>{1, 1});
  EXPECT_EQ(meter.flow().count(), 1);
}

TEST(Flow, ThroughADiscEndsAtItsRim) {
  const FlowSurface disc{
      .shape = FlowSurface::Shape::disc, .point = {1, 1, 0}, .normal = {0, 0, -1}, .radius = 2};
  EXPECT_EQ(count(disc, {1, 1, 1}, {1, 1, -1}), 1);
  EXPECT_EQ(count(disc, {3, 1, 1}, {3, 1, -1}), 1);
  EXPECT_EQ(count(disc, {3.01, 1, 1}, {3.01, 1, -1}), 0);
  EXPECT_EQ(count(disc, {6, 1, 1}, {1, 1, -1}), 0);     // meets the plane at x = 3.5
  EXPECT_EQ(count(disc, {6, 1, 1}, {1, 1, -0.25}), 1);  // at x = 2
  EXPECT_EQ(count(disc, {6, 1, 0.25}, {1, 1, -1}), 0);  // at x = 5
}

TEST(Flow, ThroughNeighbouringParallelogramsIsCountedOnce) {
  FlowSurface left{.shape = FlowSurface::Shape::parallelogram,
                   .point = {0, 0, 0},
                   .edge_one = {1, 0, 0},
                   .edge_two = {0.5, 1, 0}};
  FlowSurface right = left;
  right.point = {1, 0, 0};
  const auto down = [&](const FlowSurface& s, double x, double y) { return count(s, {x, y, 1}, {x, y, -1}); };
  EXPECT_EQ(down(left, 0.7, 0.5), -1);
  EXPECT_EQ(down(left, 0.2, 0.5), 0);
  EXPECT_EQ(down(left, 1.2, 0.5), -1);
  EXPECT_EQ(down(left, 0.7, 1.01), 0);
  for (const double y : {0.0, 0.25, 0.5, 0.75}) {  // along the common edge
    EXPECT_EQ(down(left, 1 + 0.5 * y, y), 0);
    EXPECT_EQ(down(right, 1 + 0.5 * y, y), -1);
  }
}

TEST(Flow, TakesTheShortWayWhereSpaceIsPeriodic) {
  const FlowSurface middle{.point = {5, 0, 0}, .normal = {1, 0, 0}};
  EXPECT_EQ(count(middle, {9.9, 0, 0}, {0.1, 0, 0}), -1);
  EXPECT_EQ(count(middle, {9.9, 0, 0}, {0.1, 0, 0}, {10, 0, 0}), 0);
  EXPECT_EQ(count(middle, {4.9, 0, 0}, {5.1, 0, 0}, {10, 0, 0}), 1);
  for (const double x : {0.0, 0.05, 9.95}) {  // on both sides of the face
    const FlowSurface edge{.point = {x, 0, 0}, .normal = {1, 0, 0}};
    EXPECT_EQ(count(edge, {9.9, 0, 0}, {0.1, 0, 0}, {10, 0, 0}), 1) << x;
    EXPECT_EQ(count(edge, {0.1, 0, 0}, {9.9, 0, 0}, {10, 0, 0}), -1) << x;
  }
}

TEST(Flow, GoesOnFromASavedState) {
  packings::Uniform uniform(6);
  const Ids ids{1, 2, 3, 4, 5};
  const std::vector<double> masses{1, 2, 3, 4, 5};
  FlowMeter whole(plane), first(plane);
  for (int look = 0; look < 20; ++look) {
    Places places;
    for (int i = 0; i < 5; ++i) places.push_back({0, 0, uniform(0, 2)});
    whole.look(ids, places, masses);
    FlowMeter next(plane);
    next.restore(first.state());
    next.look(ids, places, masses);
    first = next;
  }
  EXPECT_GT(whole.flow().forward_count, 10u);
  EXPECT_EQ(first.flow().forward_mass, whole.flow().forward_mass);
  EXPECT_EQ(first.flow().backward_count, whole.flow().backward_count);
}

TEST(Flow, OfAFallingColumnIsItsRate) {
  // 1000 parcels, 0.01 m apart, fall at 1 m/s through a plane: one each 0.01 s.
  FlowMeter meter({.point = {0, 0, 0}, .normal = {0, 0, -1}});
  Ids ids;
  for (std::uint32_t i = 0; i < 1000; ++i) ids.push_back(i);
  const std::vector<double> masses(1000, 0.5);
  for (int step = 0; step <= 100; ++step) {
    Places places;
    for (int i = 0; i < 1000; ++i) places.push_back({0, 0, 0.01 * i + 0.005 - 0.025 * step});
    meter.look(ids, places, masses);
  }
  EXPECT_EQ(meter.flow().count(), 250);
  EXPECT_DOUBLE_EQ(meter.flow().mass(), 125.0);
}

TEST(Flow, RefusesBadInput) {
  EXPECT_THROW(FlowMeter({.normal = {}}), std::invalid_argument);
  EXPECT_THROW(FlowMeter({.shape = FlowSurface::Shape::disc}), std::invalid_argument);
  EXPECT_THROW(FlowMeter({.shape = FlowSurface::Shape::parallelogram, .edge_one = {1, 0, 0}}),
               std::invalid_argument);
  FlowMeter meter(plane);
  const std::vector<double> masses{1, 1};
  EXPECT_THROW(meter.look(Ids{2, 1}, Places(2), masses), std::invalid_argument);
  EXPECT_THROW(meter.look(Ids{1, 1}, Places(2), masses), std::invalid_argument);
  EXPECT_THROW(meter.look(Ids{1, 2}, Places(1), masses), std::invalid_argument);
  EXPECT_THROW(meter.look(Ids{1}, Places(1), masses), std::invalid_argument);
  EXPECT_THROW(meter.restore({{}, {1}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis::measures
