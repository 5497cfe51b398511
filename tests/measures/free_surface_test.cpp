// SPDX-License-Identifier: Apache-2.0
#include "measures/free_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine/base/failure.hpp"
#include "packings.hpp"

namespace pulvis::measures {
namespace {

const Container die{.min = {0, 0, 0}, .max = {8, 4, 10}};

/// Columns of one sphere in each square metre, the pile at x = i being i + 1 spheres high; all joined.
packings::Packing staircase() {
  packings::Packing packing;
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::uint32_t i = 0; i < 8; ++i)
      for (std::uint32_t k = 0; k <= i; ++k) {
        packing.spheres.push_back({{i + 0.5, j + 0.5, k + 0.5}, 0.5});
        const auto count = static_cast<std::uint32_t>(packing.spheres.size());
        if (count > 1) packing.contacts.push_back({count - 2, count - 1});
      }
  return packing;
}

TEST(FreeSurface, OfAStaircaseIsAStaircase) {
  const auto [spheres, contacts] = staircase();
  const FreeSurface surface = free_surface(spheres, contacts, die, 1.0);
  ASSERT_EQ(surface.along_first.count(), 8u);
  ASSERT_EQ(surface.along_second.count(), 4u);
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(surface.height(i, j), static_cast<double>(i + 1));
  EXPECT_EQ(surface.cluster_size, spheres.size());
  EXPECT_DOUBLE_EQ(surface.mean, 4.5);
  EXPECT_DOUBLE_EQ(surface.roughness, std::sqrt(63.0 / 12.0));  // of the numbers 1 to 8
}

TEST(FreeSurface, OfATiltedSheetFollowsItsPlane) {
  // A grid of spheres on the plane z = 1 + 0.3 x + 0.1 y, finer than the columns: the highest of a column is
  // the one with the largest x and y in it.
  std::vector<Sphere> spheres;
  std::vector<Contact> contacts;
  for (std::uint32_t j = 0; j < 40; ++j)
    for (std::uint32_t i = 0; i < 80; ++i) {
      const double x = 0.1 * i + 0.05, y = 0.1 * j + 0.05;
      spheres.push_back({{x, y, 1 + 0.3 * x + 0.1 * y}, 0.06});
      const auto count = static_cast<std::uint32_t>(spheres.size());
      if (count > 1) contacts.push_back({count - 2, count - 1});
    }
  const FreeSurface surface = free_surface(spheres, contacts, die, 2.1);
  ASSERT_EQ(surface.along_first.count(), 4u);
  ASSERT_EQ(surface.along_second.count(), 2u);
  EXPECT_EQ(surface.along_first.part(), 2.0);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = 2.0 * static_cast<double>(i + 1) - 0.05, y = 2.0 * static_cast<double>(j + 1) - 0.05;
      EXPECT_NEAR(surface.height(i, j), 1.06 + 0.3 * x + 0.1 * y, 1e-12);
    }
  EXPECT_NEAR(surface.mean, 1.06 + 0.3 * 4.95 + 0.1 * 2.95, 1e-12);
  EXPECT_NEAR(surface.roughness, std::sqrt(0.6 * 0.6 * 1.25 + 0.2 * 0.2 * 0.25), 1e-12);
}

TEST(FreeSurface, KnowsSlopesAndTiltOfAStaircaseAndOfASheet) {
  const auto [spheres, contacts] = staircase();
  const FreeSurface stairs = free_surface(spheres, contacts, die, 1.0);
  EXPECT_NEAR(stairs.slope_first, 1.0, 1e-12);
  EXPECT_NEAR(stairs.slope_second, 0.0, 1e-12);
  EXPECT_NEAR(stairs.tilt, std::numbers::pi / 4, 1e-12);

  std::vector<Sphere> row;
  std::vector<Contact> joined;
  for (std::uint32_t i = 0; i < 32; ++i) {  // one in the middle of each column
    const double x = 0.5 + i % 8, y = 0.5 + i / 8;
    row.push_back({{x, y, 2 - 0.25 * x + 0.125 * y}, 0.5});
    if (i > 0) joined.push_back({i - 1, i});
  }
  const FreeSurface sheet = free_surface(row, joined, die, 1.0);
  EXPECT_NEAR(sheet.slope_first, -0.25, 1e-12);
  EXPECT_NEAR(sheet.slope_second, 0.125, 1e-12);
  EXPECT_NEAR(sheet.tilt, std::atan(std::sqrt(5.0) / 8), 1e-12);
}

TEST(FreeSurface, HasNoSlopeAlongAnAxisWithOneColumn) {
  const auto [spheres, contacts] = staircase();
  const FreeSurface row = free_surface(spheres, contacts, {.max = {8, 4, 10}}, 4.0);  // two columns
  ASSERT_EQ(row.heights, (std::vector<double>{4, 8}));
  EXPECT_DOUBLE_EQ(row.slope_first, 1.0);
  EXPECT_EQ(row.slope_second, 0.0);
  const FreeSurface one = free_surface(spheres, contacts, die, 100.0);
  EXPECT_EQ(one.tilt, 0.0);
  EXPECT_EQ(free_surface({}, {}, die, 1.0).tilt, 0.0);
}

TEST(FilledVolume, IsThatUnderTheStairsAndEndsAtTheDiesTop) {
  const auto [spheres, contacts] = staircase();
  const FreeSurface surface = free_surface(spheres, contacts, die, 1.0);
  EXPECT_NEAR(filled_volume(surface, die), 4.0 * 36, 1e-12);
  const Container low{.max = {8, 4, 3}};
  EXPECT_NEAR(filled_volume(surface, low), 4.0 * (1 + 2 + 6 * 3), 1e-12);
  EXPECT_EQ(filled_volume(free_surface({}, {}, die, 1.0), die), 0.0);
  EXPECT_THROW(filled_volume(surface, {.max = {7, 4, 10}}), std::invalid_argument);
  EXPECT_THROW(filled_volume(FreeSurface{}, die), std::invalid_argument);
}

TEST(FilledVolume, OfAFullCylinderIsItsVolumeThoughItsThinColumnsKnowNoHeight) {
  const Container round{.shape = Container::Shape::cylinder, .radius = 2, .height = 5};
  FreeSurface surface = free_surface({}, {}, round, 1.0);
  for (std::size_t c = 0; c < surface.heights.size(); ++c)
    surface.heights[c] = surface.areas[c] < 0.5 ? 0.0 : 6.0;
  EXPECT_NEAR(filled_volume(surface, round), volume(round), 1e-12);
  for (double& height : surface.heights) height = std::min(height, 2.0);
  EXPECT_NEAR(filled_volume(surface, round), 0.4 * volume(round), 1e-12);
}

TEST(FreeSurface, IgnoresWhatFliesAndClumpsApartFromTheBed) {
  auto [spheres, contacts] = staircase();
  const FreeSurface before = free_surface(spheres, contacts, die, 1.0);
  spheres.push_back({{0.5, 0.5, 9.0}, 0.5});  // a single one falling
  const auto clump = static_cast<std::uint32_t>(spheres.size());
  for (int i = 0; i < 5; ++i) spheres.push_back({{1.5, 1.5, 5.5 + i}, 0.5});
  for (std::uint32_t i = 0; i < 4; ++i) contacts.push_back({clump + i, clump + i + 1});
  const FreeSurface after = free_surface(spheres, contacts, die, 1.0);
  EXPECT_EQ(after.heights, before.heights);
  EXPECT_EQ(after.cluster_size, before.cluster_size);
}

TEST(FreeSurface, IgnoresPowderBesideTheDieHoweverMuch) {
  auto [spheres, contacts] = staircase();
  const FreeSurface before = free_surface(spheres, contacts, die, 1.0);
  for (int i = 0; i < 1000; ++i) {
    spheres.push_back({{-1.0, 2.0, 0.1 * i}, 0.5});
    const auto count = static_cast<std::uint32_t>(spheres.size());
    if (i > 0) contacts.push_back({count - 2, count - 1});
  }
  EXPECT_EQ(free_surface(spheres, contacts, die, 1.0).heights, before.heights);
}

TEST(FreeSurface, MayRiseAboveTheDie) {
  const std::vector<Sphere> spheres{{{1, 1, 9.8}, 0.5}, {{1, 1, 10.8}, 0.5}};
  const std::vector<Contact> contacts{{0, 1}};
  EXPECT_DOUBLE_EQ(free_surface(spheres, contacts, die, 4.0).height(0, 0), 11.3);
}

TEST(FreeSurface, OfNothingIsTheFloor) {
  const FreeSurface surface = free_surface({}, {}, die, 1.0);
  EXPECT_EQ(surface.heights, std::vector<double>(32, 0.0));
  EXPECT_EQ(surface.mean, 0.0);
  EXPECT_EQ(surface.roughness, 0.0);
  EXPECT_EQ(surface.cluster_size, 0u);
}

TEST(FreeSurface, DoesNotDependOnTheOrderOfContacts) {
  auto [spheres, contacts] = staircase();
  const FreeSurface before = free_surface(spheres, contacts, die, 1.0);
  std::reverse(contacts.begin(), contacts.end());
  for (Contact& contact : contacts) std::swap(contact.first, contact.second);
  EXPECT_EQ(free_surface(spheres, contacts, die, 1.0).heights, before.heights);
}

TEST(FreeSurface, IsMeasuredAgainstGravityWhicheverWayThatIs) {
  // The staircase turned: what was z is now -x, with the die's floor at x = 0.
  auto [spheres, contacts] = staircase();
  for (Sphere& sphere : spheres) sphere.centre = {-sphere.centre.z, sphere.centre.y, sphere.centre.x};
  const Container turned{.min = {-10, 0, 0}, .max = {0, 4, 8}, .up = {-1, 0, 0}};
  const FreeSurface surface = free_surface(spheres, contacts, turned, 1.0);
  EXPECT_DOUBLE_EQ(surface.mean, 4.5);
  EXPECT_DOUBLE_EQ(surface.roughness, std::sqrt(63.0 / 12.0));
}

TEST(FreeSurface, WeighsTheColumnsOfACylinderByTheirPartInside) {
  const Container round{.shape = Container::Shape::cylinder, .radius = 2, .height = 5};
  const std::vector<Sphere> spheres{{{0, 0, 1}, 0.5}};
  const FreeSurface surface = free_surface(spheres, {}, round, 4.0 / 3.0);
  ASSERT_EQ(surface.heights.size(), 9u);
  const double inner = 16.0 / 9.0, share = inner / (4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(surface.areas[4], inner);
  EXPECT_DOUBLE_EQ(surface.mean, 1.5 * share);
  EXPECT_NEAR(surface.roughness, 1.5 * std::sqrt(share * (1 - share)), 1e-14);
}

TEST(FreeSurface, LeavesColumnsMostlyOutsideACylinderOutOfItsMean) {
  const Container round{.shape = Container::Shape::cylinder, .radius = 2, .height = 5};
  const std::vector<Sphere> spheres{{{0.5, 0.5, 1}, 0.5}};
  const FreeSurface surface = free_surface(spheres, {}, round, 1.0);
  const double corner = std::numbers::pi / 3 - (std::sqrt(3.0) - 1);  // 0.315 of a square metre
  EXPECT_NEAR(surface.areas[0], corner, 1e-14);
  EXPECT_NEAR(surface.mean, 1.5 / (4 * std::numbers::pi - 4 * corner), 1e-14);
}

TEST(FreeSurface, RefusesBadInput) {
  const std::vector<Sphere> one{{{1, 1, 1}, 0.5}};
  const std::vector<Contact> missing{{0, 1}};
  EXPECT_THROW(free_surface(one, missing, die, 1.0), std::out_of_range);
  for (const double edge : {0.0, -1.0, 1e-300, std::nan("")})
    EXPECT_THROW(free_surface(one, {}, die, edge), Failure);
  const std::vector<Sphere> lost{{{std::nan(""), 1, 1}, 0.5}};
  EXPECT_THROW(free_surface(lost, {}, die, 1.0), Failure);
}

}  // namespace
}  // namespace pulvis::measures
