// SPDX-License-Identifier: Apache-2.0
#include "meshes/mending.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "meshes/mesh_words.hpp"
#include "shapes.hpp"
#include "tests/output/failures.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

constexpr double mm = 1e-3;
constexpr double cube_volume = 512e-9;  // of the side 8 mm

void expect_sound_cube(const MendedMesh& cube) {
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_EQ(cube.report.points, 8u);
  EXPECT_EQ(cube.report.triangles, 12u);
  ASSERT_TRUE(cube.report.volume.has_value());
  EXPECT_NEAR(*cube.report.volume, cube_volume, 1e-12 * cube_volume);
  EXPECT_NEAR(cube.report.area, 6 * 64e-6, 1e-12 * 6 * 64e-6);
}

TEST(Mending, JoinsTheCornersOfACube) {
  const auto cube = mend(cube_soup(), mm);
  expect_sound_cube(cube);
  EXPECT_EQ(cube.report.shells, 1u);
  EXPECT_EQ(cube.report.points_welded, 0u);
  EXPECT_DOUBLE_EQ(cube.report.shortest_edge, 8e-3);
  EXPECT_EQ(cube.facets.front(), 1u);
  EXPECT_EQ(cube.facets.back(), 12u);
  EXPECT_EQ(describe(cube.report, "cube.stl"), "cube.stl: 8 x 8 x 8 mm, 12 triangles, watertight (512 mm^3)");
  EXPECT_TRUE(warnings_of(cube.report, "cube.stl").empty());
}

TEST(Mending, WeldsCornersThatRoundingHasParted) {
  validation::Draw draw(1);
  auto soup = cube_soup();
  for (auto& corners : soup.triangles)
    for (Vec3& corner : corners) corner += draw.vector(2e-6);  // the weld distance is 14e-6
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_EQ(cube.report.points, 8u);
  EXPECT_EQ(cube.report.points_welded, 36u - 8u);
  EXPECT_NEAR(*cube.report.volume, cube_volume, 1e-5 * cube_volume);
}

TEST(Mending, WeldsTheSamePointsWhateverTheOrderOfTheTriangles) {
  // A cloud so dense that most points have several others within the weld distance.
  validation::Draw draw(2);
  TriangleSoup soup{"cloud", {}};
  for (int t = 0; t < 500; ++t) soup.triangles.push_back({draw.vector(1), draw.vector(1), draw.vector(1)});
  const auto points_of = [](const MendedMesh& mesh) {
    std::set<std::array<double, 3>> points;
    for (const Vec3& p : mesh.mesh.points) points.insert({p.x, p.y, p.z});
    return points;
  };
  const MendingChoices coarse{.weld_distance = 0.1};
  const auto first = points_of(mend(soup, 1.0, coarse));
  std::reverse(soup.triangles.begin(), soup.triangles.end());
  for (auto& corners : soup.triangles) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  EXPECT_EQ(points_of(mend(soup, 1.0, coarse)), first);
  for (const auto& p : first)
    for (const auto& q : first) {
      const double apart = norm(Vec3{p[0] - q[0], p[1] - q[1], p[2] - q[2]});
      EXPECT_TRUE(p == q || apart > 0.1) << apart;
    }
}

TEST(Mending, WeldsAcrossTheCellsOfItsGrid) {
  // A chain of pairs at all positions within a cell, each closer together than the weld distance.
  TriangleSoup soup{"pairs", {}};
  const MendingChoices choices{.weld_distance = 1e-3};
  for (int k = 0; k < 1000; ++k) {
    const double x = 0.01 * k + 1.37e-5 * k;
    soup.triangles.push_back({Vec3{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    soup.triangles.push_back({Vec3{x + 0.9e-3, 0, 0}, {x, -1, 0}, {x, 0, -1}});
  }
  EXPECT_EQ(mend(soup, 1.0, choices).report.points_welded, 1000u);
}

TEST(Mending, ToleratesThe32BitRoundingOfACubeFarFromTheOrigin) {
  auto soup = cube_soup();
  validation::Draw draw(3);
  for (auto& corners : soup.triangles)
    for (Vec3& corner : corners) {
      corner += Vec3{20000, -30000, 10000};
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] = static_cast<double>(static_cast<float>(corner[axis] + draw.between(-0.001, 0.001)));
    }
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_EQ(cube.report.points, 8u);
}

TEST(Mending, RemovesDuplicatesInAnyOrderOfTheirCorners) {
  auto soup = cube_soup();
  const auto [a, b, c] = soup.triangles[3];
  soup.triangles.insert(soup.triangles.end(), {{b, c, a}, {c, b, a}, {a, b, c}});
  const auto cube = mend(soup, mm);
  expect_sound_cube(cube);
  EXPECT_EQ(cube.report.duplicates, 3u);
  EXPECT_EQ(
      describe(cube.report, "cube.stl"),
      "cube.stl: 8 x 8 x 8 mm, 12 triangles, watertight (512 mm^3); mended: 3 duplicate triangles removed");
}

TEST(Mending, ReportsAMissingFacetAsAHole) {
  auto soup = cube_soup();
  soup.triangles.pop_back();  // (0, 0, 8), (8, 8, 8), (0, 8, 8)
  const auto cube = mend(soup, mm);
  EXPECT_FALSE(cube.report.watertight);
  EXPECT_FALSE(cube.report.volume.has_value());
  EXPECT_EQ(cube.report.open_edges.count, 3u);
  EXPECT_EQ(cube.report.holes, 1u);
  EXPECT_NEAR(cube.report.open_edges.length, (16 + std::sqrt(128.0)) * mm, 1e-12);
  EXPECT_EQ(cube.report.open_edges.place.z, 8 * mm);
  EXPECT_EQ(describe(cube.report, "cube.stl"), "cube.stl: 8 x 8 x 8 mm, 11 triangles, not watertight");
  const auto warnings = warnings_of(cube.report, "cube.stl");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "cube.stl: 1 hole of 3 open edges, 27.31 mm long in all, one of them at (0, 4, 8) mm: powder may "
            "escape "
            "there, unless it is the opening of a vessel");
}

TEST(Mending, CountsShellsAndHolesApart) {
  auto soup = cube_soup();
  append(soup, box_soup({20, 0, 0}, {21, 1, 1}));
  soup.triangles.erase(soup.triangles.begin());
  soup.triangles.pop_back();
  const auto two = mend(soup, mm);
  EXPECT_EQ(two.report.shells, 2u);
  EXPECT_EQ(two.report.holes, 2u);
  EXPECT_EQ(two.report.open_edges.count, 6u);
  EXPECT_NE(describe(two.report, "two.stl").find("22 triangles in 2 pieces, not watertight"),
            std::string::npos);
}

TEST(Mending, ReportsATJunction) {
  auto soup = cube_soup();
  // One of the triangles at the edge from (0, 0, 8) to (8, 0, 8) is split at its middle, its neighbour is
  // not.
  const Vec3 middle{4, 0, 8}, a = soup.triangles[10][0], b = soup.triangles[10][1], c = soup.triangles[10][2];
  soup.triangles[10] = {a, middle, c};
  soup.triangles.push_back({middle, b, c});
  const auto cube = mend(soup, mm);
  EXPECT_FALSE(cube.report.watertight);
  EXPECT_EQ(cube.report.open_edges.count, 3u);
  EXPECT_EQ(cube.report.open_edges.place.y, 0.0);
  EXPECT_EQ(cube.report.open_edges.place.z, 8 * mm);
}

TEST(Mending, ReportsEdgesOfMoreThanTwoTriangles) {
  auto soup = cube_soup();
  soup.triangles.push_back({Vec3{0, 0, 0}, {8, 0, 0}, {4, -5, 0}});
  const auto fin = mend(soup, mm);
  EXPECT_EQ(fin.report.crowded_edges.count, 1u);
  EXPECT_EQ(fin.report.crowded_edges.place, (Vec3{4 * mm, 0, 0}));
  EXPECT_EQ(fin.report.open_edges.count, 2u);
  EXPECT_EQ(fin.report.shells, 1u);
  EXPECT_EQ(warnings_of(fin.report, "fin.stl").at(1),
            "fin.stl: 1 edge of more than two triangles, one of them at (4, 0, 0) mm: surfaces cross or "
            "stand on each "
            "other there");
}

TEST(Mending, RefusesASurfaceWithoutArea) {
  TriangleSoup soup{"dust.stl", {}};
  const Vec3 p{1, 2, 3};
  soup.triangles.assign(2'000'000, {p, p, p});
  EXPECT_EQ(failure_of(Exit::bad_input, [&] { mend(soup, mm); }),
            "dust.stl: error: none of its 2000000 triangles has an area (corners closer together than "
            "7.15e-07 mm are "
            "one)\n  export the surface again, or check its unit");
  EXPECT_EQ(failure_of(Exit::bad_input,
                       [] {
                         mend({"none.stl", {}}, mm);
                       }),
            "none.stl: error: there is no triangle in it");
}

TEST(Mending, TakesMillionsOfDegenerateTrianglesInSeconds) {
  const Vec3 p{1, 2, 3}, q{4, 4, 4};
  validation::Draw draw(5);
  auto soup = cube_soup();
  for (int t = 0; t < 500'000; ++t) {
    soup.triangles.push_back({p, p, p});
    soup.triangles.push_back({p, q, p});
    const Vec3 r = draw.vector(1e-6);
    soup.triangles.push_back({r, draw.vector(1e-6), r});
    soup.triangles.push_back({q, q + draw.vector(1e-6), q + draw.vector(1e-6)});
  }
  const auto cube = mend(soup, mm);
  EXPECT_TRUE(cube.report.watertight);
  EXPECT_EQ(cube.report.points, 8u);
  EXPECT_NEAR(cube.report.volume.value_or(0), cube_volume, 1e-6 * cube_volume);
  EXPECT_EQ(cube.report.degenerate, 1'500'000u);
  EXPECT_EQ(cube.report.slivers, 500'000u);
  EXPECT_EQ(cube.report.triangles_read, 2'000'012u);
  EXPECT_EQ(describe(cube.report, "cube.stl").find("cube.stl: 8 x 8 x 8 mm, 12 triangles, watertight"), 0u);
  EXPECT_NE(describe(cube.report, "cube.stl").find("1,500,000 triangles without area removed"),
            std::string::npos);
}

TEST(Mending, MendsALargeSheetInSeconds) {
  const auto mesh = sheet(1000, 10.0, [](double x, double y) { return 0.1 * x * y; });
  TriangleSoup soup{"sheet.stl", {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    soup.triangles.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  const auto mended = mend(soup, mm);
  EXPECT_EQ(mended.report.points, 1001u * 1001u);
  EXPECT_EQ(mended.report.open_edges.count, 4000u);
  EXPECT_EQ(mended.report.holes, 1u);
  EXPECT_EQ(mended.report.turned, 0u);
}

TEST(Mending, SaysALargeSizePlainlySoThatAWrongUnitIsSeen) {
  const auto cube = mend(cube_soup(), 1.0);
  EXPECT_EQ(describe(cube.report, "cube.stl").substr(0, 35), "cube.stl: 8000 x 8000 x 8000 mm, 12");
  EXPECT_EQ(describe(mend(cube_soup(), 10.0).report, "cube.stl").substr(0, 38),
            "cube.stl: 80000 x 80000 x 80000 mm, 12");
  failure_of(Exit::bad_input, [] { mend(cube_soup(), 0.0); });
}

}  // namespace
}  // namespace pulvis
