// SPDX-License-Identifier: Apache-2.0
#include "measures/coordination.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "packings.hpp"

namespace pulvis::measures {
namespace {

using packings::Faces;
const Container everywhere{.min = {-100, -100, -100}, .max = {100, 100, 100}};

TEST(Coordination, OfASimpleCubicPackingIsSix) {
  const auto [spheres, contacts] = packings::simple_cubic(4, 1.0, Faces::wrap);
  const Coordination result = coordination(spheres, contacts, {}, everywhere);
  EXPECT_EQ(result.mean, 6.0);
  EXPECT_EQ(result.mean_walls, 0.0);
  EXPECT_EQ(result.histogram, (std::vector<std::size_t>{0, 0, 0, 0, 0, 0, 64}));
}

TEST(Coordination, OfABodyCentredPackingIsEight) {
  const auto [spheres, contacts] = packings::body_centred(3, 1.0);
  const Coordination result = coordination(spheres, contacts, {}, everywhere);
  EXPECT_EQ(result.mean, 8.0);
  EXPECT_EQ(result.histogram.at(8), 54u);
}

TEST(Coordination, OfAFreeSimpleCubicBlockKnowsFacesEdgesAndCorners) {
  const std::uint32_t n = 5;
  const auto [spheres, contacts] = packings::simple_cubic(n, 1.0);
  const Coordination result = coordination(spheres, contacts, {}, everywhere);
  EXPECT_DOUBLE_EQ(result.mean.value(), 6.0 - 6.0 / n);
  EXPECT_EQ(result.histogram, (std::vector<std::size_t>{0, 0, 0, 8, 36, 54, 27}));
}

TEST(Coordination, CountsWallsApart) {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1}, {{2, 0, 0}, 1}};
  const std::vector<Contact> contacts{{0, 1}};
  const std::vector<std::uint32_t> walls{0, 0, 1};
  const Coordination result = coordination(spheres, contacts, walls, everywhere);
  EXPECT_EQ(result.mean, 1.0);
  EXPECT_EQ(result.mean_walls, 1.5);
}

TEST(Coordination, IsThatOfTheSpheresInTheDie) {
  const std::vector<Sphere> spheres{{{0.5, 0, 0}, 0.5}, {{1.5, 0, 0}, 0.5}, {{2.5, 0, 0}, 0.5}};
  const std::vector<Contact> contacts{{0, 1}, {1, 2}};
  const std::vector<std::uint32_t> walls{0, 2};
  const Container left{.min = {0, -1, -1}, .max = {2, 1, 1}};
  const Coordination result = coordination(spheres, contacts, walls, left);
  EXPECT_EQ(result.spheres, 2u);
  EXPECT_EQ(result.mean, 1.5);
  EXPECT_EQ(result.mean_walls, 0.5);
  EXPECT_EQ(result.histogram, (std::vector<std::size_t>{0, 1, 1}));
}

TEST(Coordination, CallsSpheresWithFewerThanFourContactsRattlers) {
  // A free cubic block of 5 along each edge: its 8 corners have three contacts.
  const auto [spheres, contacts] = packings::simple_cubic(5, 1.0);
  const Coordination free = coordination(spheres, contacts, {}, everywhere);
  EXPECT_EQ(free.rattlers, 8u);
  EXPECT_DOUBLE_EQ(free.rattler_share.value(), 8.0 / 125);
  EXPECT_DOUBLE_EQ(free.mean_without_rattlers.value(), (36 * 4 + 54 * 5 + 27 * 6) / 117.0);

  std::vector<std::uint32_t> floor;  // each sphere of the lowest layer also lies on the floor
  for (std::uint32_t i = 0; i < 25; ++i) floor.push_back(i);
  const Coordination on_floor = coordination(spheres, contacts, floor, everywhere);
  EXPECT_EQ(on_floor.rattlers, 4u);
  EXPECT_DOUBLE_EQ(on_floor.mean_without_rattlers.value(), (4 * 4 + 36 * 4 + 54 * 5 + 27 * 6 + 21) / 121.0);
}

TEST(Coordination, OfRattlersOnlyHasNoMeanWithoutThem) {
  const std::vector<Sphere> pair{{{0, 0, 0}, 1}, {{2, 0, 0}, 1}};
  const std::vector<Contact> contacts{{0, 1}};
  const Coordination result = coordination(pair, contacts, {}, everywhere);
  EXPECT_EQ(result.rattler_share, 1.0);
  EXPECT_FALSE(result.mean_without_rattlers.has_value());
}

TEST(Coordination, CanBeAskedOfAnyChoiceOfSpheres) {
  const auto [spheres, contacts] = packings::simple_cubic(5, 1.0);
  std::vector<std::uint8_t> lowest(125, 0);
  for (std::size_t i = 0; i < 25; ++i) lowest[i] = 1;
  const Coordination result = coordination(lowest, contacts, {});
  EXPECT_EQ(result.spheres, 25u);
  EXPECT_DOUBLE_EQ(result.mean.value(), (4 * 3 + 12 * 4 + 9 * 5) / 25.0);
}

TEST(Coordination, OfNothingHasNoMean) {
  const Coordination result = coordination({}, {}, {}, everywhere);
  EXPECT_EQ(result.spheres, 0u);
  EXPECT_FALSE(result.mean.has_value());
  EXPECT_FALSE(result.mean_walls.has_value());
  EXPECT_FALSE(result.rattler_share.has_value());
  EXPECT_TRUE(result.histogram.empty());
}

TEST(Coordination, RefusesContactsOfSpheresThatDoNotExist) {
  const std::vector<Sphere> one{{{}, 1}};
  const std::vector<Contact> contacts{{0, 1}};
  const std::vector<std::uint32_t> walls{1};
  EXPECT_THROW(coordination(one, contacts, {}, everywhere), std::out_of_range);
  EXPECT_THROW(coordination(one, {}, walls, everywhere), std::out_of_range);
}

}  // namespace
}  // namespace pulvis::measures
