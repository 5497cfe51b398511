// SPDX-License-Identifier: Apache-2.0
// Packs: how full they get, what they say when they are too full, and that nothing but the source matters.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/base/failure.hpp"
#include "engine/insertion/filled_map.hpp"
#include "tests/engine/sources.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

/// Lognormal diameters, the largest `ratio` times the smallest.
SourceModel wide_pack(double ratio, double edge) {
  SourceModel m =
      source(SourceModel::Kind::pack, SizeKind::single, box_region({0, 0, 0}, {edge, edge, edge}));
  SizeLaw law;
  law.kind = ratio > 1.0 ? SizeKind::lognormal : SizeKind::single;
  law.diameter = 1e-3;
  law.geometric_deviation = 1.5;
  law.smallest = 1e-3 / std::sqrt(ratio);
  law.largest = 1e-3 * std::sqrt(ratio);
  m.sizes.emplace(law);
  return m;
}

double solid_of(const std::vector<Parcel>& parcels) {
  double sum = 0.0;
  for (const Parcel& p : parcels) sum += sphere_volume(p.radius);
  return sum;
}

std::vector<Parcel> drawn(const SourceModel& m, const Box& box, const Parcels& present, int threads) {
  SourceState state;
  return draw_parcels(m, state, 7, 3, 0, 1e-5, present, box, nothing_in_the_way, threads);
}

void expect_same(const std::vector<Parcel>& a, const std::vector<Parcel>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].position, b[k].position) << k;
    ASSERT_EQ(a[k].radius, b[k].radius) << k;
    ASSERT_EQ(a[k].mass, b[k].mass) << k;
  }
}

std::string refusal(const SourceModel& m, const Box& box, const Parcels& present = {}) {
  try {
    draw_pack(m, box, present);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    return failure.what();
  }
  return "";
}

/// The number before `unit`, where `after` ends.
double number_after(const std::string& text, const std::string& after) {
  const std::size_t at = text.find(after);
  EXPECT_NE(at, std::string::npos) << after << " in " << text;
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + after.size()));
}

TEST(Packing, IsTheSameForAnyNumberOfThreadsAndAnyOrderOfTheStore) {
  const Box box = cube(0.02, true);
  SourceModel bed = wide_pack(2.0, 0.02);
  bed.target_mass = 0.1 * 8e-6 * bed.density;
  Parcels present;
  present.body = draw_pack(bed, box);
  SourceModel m = wide_pack(5.0, 0.02);
  m.target_mass = 0.2 * 8e-6 * m.density;
  const auto reference = drawn(m, box, present, 1);
  ASSERT_GT(reference.size(), 1000u);
  EXPECT_EQ(overlaps(reference, present.body, box), 0u);
  Parcels shuffled = present;
  for (std::size_t k = shuffled.size() - 1; k > 0; --k)
    std::swap(shuffled.body[k], shuffled.body[k * 7919 % (k + 1)]);
  for (const int threads : {1, 2, 5}) {
    expect_same(reference, drawn(m, box, present, threads));
    expect_same(reference, drawn(m, box, shuffled, threads));
  }
}

TEST(Packing, OfManyEqualSpheresIsTheSameForAnyNumberOfThreads) {
  // Full enough for the map of filled voxels, and for several tries of each sphere in a round.
  SourceModel m = wide_pack(1.0, 0.025);
  m.target_count = static_cast<std::uint64_t>(0.32 * 1.5625e-5 / sphere_volume(0.5e-3));
  const Box box = cube(0.025, false);
  const auto reference = drawn(m, box, {}, 1);
  EXPECT_EQ(overlaps(reference, {}, box), 0u);
  for (const int threads : {2, 5}) expect_same(reference, drawn(m, box, {}, threads));
}

TEST(Packing, IdsFollowTheNumbersAndNotTheOrderOfPlacing) {
  SourceModel m = wide_pack(3.0, 0.02);
  m.target_count = 500;
  const auto parcels = drawn(m, cube(0.02, false), {}, 2);
  for (std::size_t k = 0; k < parcels.size(); ++k)
    EXPECT_EQ(2.0 * parcels[k].radius, m.sizes->diameter(7, 3, k)) << "parcel " << k;
}

TEST(Packing, SaturatesWhereRandomPackingOfEqualSpheresDoes) {
  // Random sequential addition ends at a fraction of 0.384 without walls (Zhang and Torquato, Phys. Rev. E 88,
  // 053312 (2013), doi 10.1103/PhysRevE.88.053312); the last places are rare.
  const double edge = 0.02;
  SourceModel m = wide_pack(1.0, edge);
  // The region reaches beyond the periodic faces by a radius, so that they are no walls.
  m.region = box_region({-0.5e-3, -0.5e-3, -0.5e-3}, {edge + 0.5e-3, edge + 0.5e-3, edge + 0.5e-3});
  m.target_count = static_cast<std::uint64_t>(0.355 * edge * edge * edge / sphere_volume(0.5e-3));
  const Box box = cube(edge, true);
  EXPECT_EQ(overlaps(draw_pack(m, box), {}, box), 0u);
  m.target_count = static_cast<std::uint64_t>(0.39 * edge * edge * edge / sphere_volume(0.5e-3));
  EXPECT_NE(refusal(m, box), "");
}

TEST(Packing, ReachesMoreWithWideDistributionsForTheLargeArePlacedFirst) {
  for (const auto& [ratio, solids] : {std::pair(2.0, 0.38), std::pair(5.0, 0.42)}) {
    const double edge = 15e-3 * std::sqrt(ratio);
    SourceModel m = wide_pack(ratio, edge);
    m.target_mass = solids * edge * edge * edge * m.density;
    const Box box = cube(edge, false);
    const auto parcels = draw_pack(m, box);
    EXPECT_NEAR(solid_of(parcels), solids * edge * edge * edge, sphere_volume(0.5 * m.sizes->smallest()));
    EXPECT_EQ(overlaps(parcels, {}, box), 0u) << ratio;
  }
}

TEST(Packing, IsUniformAlongTheRegion) {
  SourceModel m = wide_pack(2.0, 0.04);
  m.target_mass = 0.25 * 6.4e-5 * m.density;
  double share[4] = {0, 0, 0, 0};
  const auto parcels = draw_pack(m, cube(0.04, false));
  for (const Parcel& p : parcels) share[static_cast<int>(p.position.z / 0.01)] += p.mass / *m.target_mass;
  // The outer quarters have a wall.
  EXPECT_NEAR(share[1], share[2], 0.01);
  EXPECT_NEAR(share[0], share[3], 0.01);
}

TEST(Packing, AdvisesWhatFitsForCountsAndMasses) {
  for (const double ratio : {1.0, 5.0})
    for (const bool by_mass : {false, true}) {
      SourceModel m = wide_pack(ratio, 0.015);
      const double region = 3.375e-6, mean = sphere_volume(0.5) * m.sizes->mean_cube();
      if (by_mass)
        m.target_mass = 0.7 * region * m.density;
      else
        m.target_count = static_cast<std::uint64_t>(0.7 * region / mean);
      const std::string message = refusal(m, cube(0.015, false));
      const double full = number_after(message, "parcels fill ");
      EXPECT_GT(full, 30.0) << message;
      EXPECT_LT(full, 50.0) << message;
      EXPECT_NE(message.find("are asked for"), std::string::npos) << message;
      EXPECT_GT(number_after(message, "make the region "), 1.4) << message;
      if (by_mass)
        m.target_mass = number_after(message.substr(message.find("ask for at most")), "parcels (");
      else
        m.target_count = static_cast<std::uint64_t>(number_after(message, "ask for at most about "));
      EXPECT_EQ(refusal(m, cube(0.015, false)), "") << "after " << message;
    }
}

TEST(Packing, SaysWhatWasThereBefore) {
  SourceModel m = wide_pack(1.0, 0.01);
  Parcels present;
  present.body = {parcel(0, {0.005, 0.005, 0.005}, 4e-3, 1000.0)};
  m.target_count = 500;
  const std::string message = refusal(m, cube(0.01, false), present);
  EXPECT_NEAR(number_after(message, "beside "), 26.8, 0.05) << message;
}

TEST(Packing, KeepsItsWordAlsoWhereMoreIsAskedThanTheRegionHasVolume) {
  SourceModel m = wide_pack(1.0, 0.01);
  m.target_count = 1000000000000u;
  EXPECT_NE(refusal(m, cube(0.01, false)).find("1000000000000 parcels"), std::string::npos);
}

TEST(OverlapGrid, AgreesWithBruteForceForAllSizesAtOnce) {
  const Box box = cube(1.0, true);
  OverlapGrid grid({-0.1, 0.2, 0.0}, {0.8, 0.9, 1.1}, 0.2, box, 300);
  struct Ball {
    Vec3 centre;
    double radius;
  };
  const auto ball = [](std::uint32_t stream, std::uint64_t k) {
    const auto [x, y, z] = uniform_triple(1, stream, k, 0);
    return Ball{{x, y, z}, 0.2 * std::pow(0.01, uniform(1, stream, k, 1))};
  };
  std::vector<Ball> balls;
  for (std::uint64_t k = 0; k < 300; ++k) {
    balls.push_back(ball(0, k));
    grid.add(balls.back().centre, balls.back().radius);
  }
  std::size_t hits = 0;
  for (std::uint64_t k = 0; k < 3000; ++k) {
    Ball asked = ball(1, k);
    asked.radius *= 0.1;
    asked.centre =
        Vec3{-0.1, 0.2, 0.0} + Vec3{0.9 * asked.centre.x, 0.7 * asked.centre.y, 1.1 * asked.centre.z};
    // The whole sphere lies in the region, as those of a source do.
    for (int axis = 0; axis < 3; ++axis) {
      const double low[3] = {-0.1, 0.2, 0.0}, high[3] = {0.8, 0.9, 1.1};
      asked.centre[axis] =
          std::clamp(asked.centre[axis], low[axis] + asked.radius, high[axis] - asked.radius);
    }
    bool expected = false;
    for (const Ball& b : balls) {
      Vec3 d = b.centre - asked.centre;
      for (int axis = 0; axis < 3; ++axis) d[axis] -= std::round(d[axis]);
      expected = expected || norm(d) < b.radius + asked.radius;
    }
    hits += expected;
    EXPECT_EQ(grid.overlaps(asked.centre, asked.radius), expected) << k;
  }
  EXPECT_GT(hits, 300u);
  EXPECT_LT(hits, 2700u);
}

TEST(FilledMap, FillsNothingThatIsFreeAndMostOfWhatIsNot) {
  const Vec3 low{0, 0, 0}, high{0.05, 0.03, 0.02};
  OverlapGrid grid(low, high, 2e-3, cube(1.0, false), 50);
  for (std::uint64_t k = 0; k < 50; ++k) {
    const auto [x, y, z] = uniform_triple(2, 0, k, 0);
    grid.add({0.05 * x, 0.03 * y, 0.02 * z}, 1e-3 + 1e-3 * uniform(2, 0, k, 1));
  }
  FilledMap map(low, high, 1e-3);
  map.add(grid, 0, 2);
  std::size_t filled = 0, blocked = 0;
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const auto [x, y, z] = uniform_triple(3, 0, k, 0);
    const Vec3 centre{0.05 * x, 0.03 * y, 0.02 * z};
    const bool overlap = grid.overlaps(centre, 1e-3);
    if (map.filled(centre)) {
      EXPECT_TRUE(overlap);
      ++filled;
    }
    blocked += overlap;
  }
  EXPECT_GT(filled, blocked / 2);
}

}  // namespace
