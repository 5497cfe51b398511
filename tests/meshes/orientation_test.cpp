// SPDX-License-Identifier: Apache-2.0
#include "meshes/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/mending.hpp"
#include "meshes/mesh_words.hpp"
#include "shapes.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

void turn(std::array<Vec3, 3>& corners) { std::swap(corners[1], corners[2]); }

TEST(Orientation, TurnsTheOneFacetThatDisagrees) {
  auto soup = cube_soup();
  turn(soup.triangles[5]);
  const auto cube = mend(soup, 1e-3);
  EXPECT_EQ(cube.report.turned, 1u);
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_NEAR(cube.report.volume.value_or(0), 512e-9, 1e-12 * 512e-9);
  EXPECT_NE(describe(cube.report, "a").find("mended: 1 triangle turned round"), std::string::npos);
}

TEST(Orientation, TurnsRandomMixturesAndInsideOutBodiesOutward) {
  for (std::uint64_t trial = 0; trial < 100; ++trial) {
    validation::Draw draw(trial);
    auto soup = cube_soup();
    std::uint64_t turned = 0;
    const double share = draw.between(0, 1);
    for (auto& corners : soup.triangles)
      if (draw.chance(share)) turn(corners), ++turned;
    const auto cube = mend(soup, 1e-3);
    EXPECT_EQ(cube.report.turned, turned);
    EXPECT_NEAR(cube.report.volume.value_or(0), 512e-9, 1e-12 * 512e-9);
  }
}

TEST(Orientation, KeepsACavityACavity) {
  for (const bool inside_out : {false, true}) {
    auto soup = box_soup({2, 2, 2}, {6, 6, 6});
    for (auto& corners : soup.triangles) turn(corners);
    append(soup, cube_soup());
    if (inside_out)
      for (auto& corners : soup.triangles) turn(corners);
    turn(soup.triangles[0]);
    const auto hollow = mend(soup, 1e-3);
    EXPECT_EQ(hollow.report.turned, inside_out ? 23u : 1u);
    EXPECT_NEAR(hollow.report.volume.value_or(0), (512 - 64) * 1e-9, 1e-18);
    EXPECT_EQ(hollow.report.shells, 2u);
  }
}

TEST(Orientation, KeepsWhatMostTrianglesOfAnOpenSurfaceSay) {
  auto soup = cube_soup();
  soup.triangles.resize(10);  // without its lid
  for (auto& corners : soup.triangles) turn(corners);
  turn(soup.triangles[4]);
  turn(soup.triangles[7]);
  const auto vessel = mend(soup, 1e-3);
  EXPECT_EQ(vessel.report.turned, 2u);
  EXPECT_EQ(vessel.report.open_edges.count, 4u);
}

TEST(Orientation, ReportsASurfaceOfOneSide) {
  TriangleSoup band{"band.stl", {}};
  constexpr int n = 24;
  const auto point = [](int k, double across) {
    const double around = 2 * M_PI * k / n, tilt = 0.5 * around;
    const double r = 10 + across * std::cos(tilt);
    return Vec3{r * std::cos(around), r * std::sin(around), across * std::sin(tilt)};
  };
  for (int k = 0; k < n; ++k) add_quad(band, point(k, -1), point(k, 1), point(k + 1, 1), point(k + 1, -1));
  const auto mended = mend(band, 1e-3);
  EXPECT_EQ(mended.report.not_orientable, 1u);
  EXPECT_EQ(mended.report.holes, 1u);
  EXPECT_EQ(warnings_of(mended.report, "band.stl").at(1),
            "band.stl: a surface has one side only (1 edge whose two triangles cannot agree which side is "
            "outside): "
            "pictures may be wrong");
}

TEST(Orientation, FindsTheVolumeOfTwoCubesThatTouchAlongAnEdge) {
  auto soup = cube_soup();
  append(soup, box_soup({8, 8, 0}, {16, 16, 8}));
  const auto cubes = mend(soup, 1e-3);
  EXPECT_EQ(cubes.report.crowded_edges.count, 1u);
  EXPECT_TRUE(cubes.report.watertight);
  EXPECT_NEAR(cubes.report.volume.value_or(0), 1024e-9, 1e-20);
}

TEST(AgreementSets, KnowWhoAgreesWithWhomHoweverTheyWereJoined) {
  validation::Draw draw(1);
  constexpr std::uint32_t count = 2000;
  std::vector<bool> side(count);
  for (std::uint32_t k = 0; k < count; ++k) side[k] = draw.chance(0.5);
  AgreementSets sets(count);
  for (int trial = 0; trial < 80000; ++trial) {
    const auto a = static_cast<std::uint32_t>(draw.between(0, count));
    const auto b = static_cast<std::uint32_t>(draw.between(0, count));
    if (a % 4 != b % 4) continue;
    EXPECT_TRUE(sets.join(a, b, side[a] != side[b]));
    const auto place_a = sets.find(a), place_b = sets.find(b);
    EXPECT_EQ(place_a.first, place_b.first);
    EXPECT_EQ(place_a.opposite != place_b.opposite, side[a] != side[b]);
  }
  for (std::uint32_t k = 0; k < count; ++k) EXPECT_EQ(sets.find(k).first, k % 4);
  EXPECT_FALSE(sets.join(0, 4, side[0] == side[4]));
}

}  // namespace
}  // namespace pulvis
