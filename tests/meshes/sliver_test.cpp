// SPDX-License-Identifier: Apache-2.0
#include "meshes/slivers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/mending.hpp"
#include "meshes/mesh_words.hpp"
#include "shapes.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

constexpr double mm = 1e-3;

void expect_closed_cube(const MendedMesh& cube) {
  EXPECT_TRUE(cube.report.watertight) << describe(cube.report, "cube");
  EXPECT_EQ(cube.report.crowded_edges.count, 0u);
  EXPECT_EQ(cube.report.slivers_kept, 0u);
  EXPECT_EQ(cube.report.shells, 1u);
  EXPECT_NEAR(cube.report.volume.value_or(0), 512e-9, 1e-5 * 512e-9);
  for (const auto& corners : cube.mesh.triangles)
    EXPECT_GT(height_of(cube.mesh.points, corners), cube.report.weld_distance);
}

/// Replaces facet `number` (a, b, c) of `soup` by the fan from `c` over a, through, b; the sliver (a,
/// through, b) closes the gap to the neighbour across a b.
void insert_cap(TriangleSoup& soup, std::size_t number, const Vec3& through) {
  const auto [a, b, c] = soup.triangles[number];
  soup.triangles[number] = {a, through, c};
  soup.triangles.push_back({through, b, c});
  soup.triangles.push_back({a, b, through});
}

TEST(Slivers, ANeedleCollapsesAndTheCubeStaysClosed) {
  auto soup = cube_soup();
  // The corner (8, 8, 8) becomes two of 5 nm apart: facet 11 keeps the old one, a needle fills the gap.
  const Vec3 corner{8, 8, 8}, beside{8 - 5e-6, 8, 8};
  const auto [a, b, c] = soup.triangles[11];
  ASSERT_EQ(b, corner);
  soup.triangles[11] = {a, beside, c};
  soup.triangles.push_back({a, corner, beside});
  soup.triangles.push_back({corner, c, beside});
  const auto cube = mend(soup, mm);
  expect_closed_cube(cube);
  EXPECT_EQ(cube.report.slivers, 2u);
  EXPECT_EQ(cube.report.points_welded, 1u);
  EXPECT_EQ(cube.report.points, 8u);
}

TEST(Slivers, ACapGoesBySplittingItsNeighbour) {
  for (const double off : {0.0, 1e-6, -1e-6}) {
    auto soup = cube_soup();
    const auto [a, b, c] = soup.triangles[10];
    insert_cap(soup, 10, 0.7 * a + 0.3 * b + Vec3{0, off, 0});
    const auto cube = mend(soup, mm);
    expect_closed_cube(cube);
    EXPECT_EQ(cube.report.slivers + cube.report.degenerate, 1u);
    EXPECT_EQ(cube.report.points, 9u);
    EXPECT_EQ(cube.report.triangles, 14u);
    EXPECT_EQ(cube.report.open_edges.count, 0u);
  }
}

TEST(Slivers, CapsUponCapsGoToo) {
  for (std::uint64_t trial = 0; trial < 300; ++trial) {
    validation::Draw draw(trial);
    auto soup = cube_soup();
    const int caps = 1 + static_cast<int>(draw.between(0, 12));
    for (int k = 0; k < caps; ++k) {
      const auto number =
          static_cast<std::size_t>(draw.between(0, static_cast<double>(soup.triangles.size())));
      const auto [a, b, c] = soup.triangles[number];
      const double share = draw.between(0.1, 0.9);
      // Caps may be cut from caps; corners then lie on a line within the weld distance, 14e-6.
      insert_cap(soup, number, (1 - share) * a + share * b + draw.vector(1e-7));
    }
    const auto cube = mend(soup, mm);
    EXPECT_TRUE(cube.report.watertight) << "trial " << trial << ": " << describe(cube.report, "cube");
    EXPECT_NEAR(cube.report.volume.value_or(0), 512e-9, 1e-5 * 512e-9) << "trial " << trial;
    EXPECT_EQ(cube.report.slivers_kept, 0u);
  }
}

TEST(Slivers, AFanOfAThousandCapsOnOneEdgeGoes) {
  auto soup = cube_soup();
  for (int k = 0; k < 1000; ++k) {
    const auto [a, b, c] = soup.triangles[10];
    insert_cap(soup, 10, 0.997 * b + 0.003 * a);  // ever closer to b
  }
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.watertight) << describe(cube.report, "cube");
  EXPECT_NEAR(cube.report.volume.value_or(0), 512e-9, 1e-5 * 512e-9);
}

TEST(Slivers, ACapWithoutNeighbourLeavesTheOthersAlone) {
  auto soup = cube_soup();
  soup.triangles.push_back({Vec3{20, 0, 0}, {22, 0, 0}, {21, 1e-6, 0}});
  expect_closed_cube(mend(soup, mm));
}

TEST(Slivers, AKnotOfSliversIsGivenUpInBoundedTime) {
  // All on one line, so that each split makes more of them.
  validation::Draw draw(1);
  auto soup = cube_soup();
  std::vector<Vec3> line;
  for (int k = 0; k < 200; ++k) line.push_back({20 + draw.between(0, 1), draw.between(0, 1e-7), 0});
  for (int t = 0; t < 200'000; ++t) {
    const auto any = [&] { return line[static_cast<std::size_t>(draw.between(0, 200))]; };
    soup.triangles.push_back({any(), any(), any()});
  }
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.slivers_kept == 0 || !warnings_of(cube.report, "knot.stl").empty());
  EXPECT_GE(cube.report.triangles, 12u);
}

// A globe of 70,000 triangles, ever thinner towards its poles.
TriangleSoup globe(double radius) {
  constexpr int rows = 100, columns = 350;
  TriangleSoup soup{"globe.stl", {}};
  const auto point = [&](int i, int j) {
    if (i % rows == 0) return Vec3{0, 0, i == 0 ? radius : -radius};
    const double polar = M_PI * i / rows, around = 2 * M_PI * (j % columns) / columns;
    return radius *
           Vec3{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      if (i > 0) soup.triangles.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
      if (i < rows - 1) soup.triangles.push_back({point(i, j + 1), point(i + 1, j), point(i + 1, j + 1)});
    }
  return soup;
}

TEST(Slivers, AGlobeStaysClosedHoweverCoarseTheWeldDistance) {
  for (const double share : {1e-6, 1e-3, 5e-3, 2e-2}) {
    const auto mended = mend(globe(10.0), mm, {.weld_distance = share * 10 * mm});
    EXPECT_EQ(mended.report.open_edges.count, 0u) << share;
    EXPECT_NEAR(mended.report.volume.value_or(0), 4.0 / 3.0 * M_PI * 1e-6, 1e-2 * 4e-6) << share;
    EXPECT_EQ(mended.report.slivers > 0, share > 1e-4) << share;
    EXPECT_EQ(warnings_of(mended.report, "globe").size(), mended.report.slivers_kept > 0 ? 1u : 0u);
  }
}

TEST(Slivers, ALowTriangleAboveTheWeldDistanceStays) {
  auto soup = cube_soup();
  const auto [a, b, c] = soup.triangles[10];
  insert_cap(soup, 10, 0.7 * a + 0.3 * b + Vec3{0, 0.001, 0});
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_EQ(cube.report.triangles, 14u);
  EXPECT_EQ(cube.report.slivers, 0u);
}

}  // namespace
}  // namespace pulvis
