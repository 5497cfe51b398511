// SPDX-License-Identifier: Apache-2.0
#include "measures/wall_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <span>

#include "engine/base/failure.hpp"
#include "surfaces.hpp"

namespace pulvis::measures {
namespace {

using namespace surfaces;
using packings::Uniform;

const Vec3 low{-3, -4, -2}, high{5, 3, 6};  // a domain
constexpr std::uint32_t no_facet = WallTiling::no_facet;

std::vector<WallTile> tiles_of(const WallTiling& tiling) {
  return {tiling.tiles().begin(), tiling.tiles().end()};
}
std::vector<WallTile> tiles_of(const Surface& surface, double edge) {
  return tiles_of(WallTiling(walls_of(surface), low, high, edge));
}

double total_area(const std::vector<WallTile>& tiles) {
  return std::accumulate(tiles.begin(), tiles.end(), 0.0,
                         [](double sum, const WallTile& tile) { return sum + tile.area; });
}

/// Throws points at all surfaces, evenly by area, and expects that each tile gets its share of them and has
/// its centre in their middle. `off`: how far the points are moved away from where they hit, m.
void expect_fair_shares(const WallTiling& tiling, const Sampler& sample, double off = 0.0) {
  const auto tiles = tiles_of(tiling);
  const double whole = total_area(tiles);
  const int count = 400 * static_cast<int>(tiles.size()) + 20000;
  std::vector<double> hits(tiles.size(), 0.0);
  std::vector<Vec3> sum(tiles.size());
  Uniform uniform(11);
  for (int i = 0; i < count; ++i) {
    const Hit hit = sample(uniform);
    const Vec3 away{uniform(-off, off), uniform(-off, off), uniform(-off, off)};
    const std::uint32_t tile = tiling.tile_of(hit.surface, hit.facet, hit.point + away);
    ASSERT_LT(tile, tiles.size());
    ASSERT_EQ(tiles[tile].surface, hit.surface);
    hits[tile] += 1.0;
    sum[tile] += hit.point;
  }
  double chi_square = 0.0;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const double expected = count * tiles[t].area / whole;
    chi_square += square(hits[t] - expected) / expected;
    // A tile is about as wide as the root of its area, two or three times that if it is long.
    const double spread = root(tiles[t].area / hits[t]);
    EXPECT_LT(norm(sum[t] / hits[t] - tiles[t].centre), 6.0 * spread);
  }
  const double freedom = static_cast<double>(tiles.size()) - 1.0;
  EXPECT_LT(chi_square, freedom + 5.0 * root(2.0 * freedom) + 1e-9);
}

void expect_unit_normals(const std::vector<WallTile>& tiles) {
  for (const WallTile& tile : tiles) EXPECT_NEAR(norm(tile.normal), 1.0, 1e-14);
}

/// On the map: rows of equal v, in each of which u goes up in equal steps.
void expect_widths(const std::vector<WallTile>& tiles, double edge) {
  std::map<double, std::vector<double>> rows;
  for (const WallTile& tile : tiles) rows[tile.v].push_back(tile.u);
  double before = -std::numeric_limits<double>::infinity();
  for (const auto& [v, row] : rows) {
    EXPECT_GE(v - before, edge * (1 - 1e-8));
    before = v;
    for (std::size_t k = 1; k < row.size(); ++k) EXPECT_GE(row[k] - row[k - 1], edge * (1 - 1e-8));
  }
}

TEST(WallTiles, OfEveryShapeHaveItsAreaInWhicheverWayItIsTurned) {
  for (const Shape& shape : shapes())
    for (const double edge : {0.07, 0.3, 1.0, 20.0}) {
      const auto tiles = tiles_of(shape.surface, edge);
      EXPECT_NEAR(total_area(tiles) / shape.area, 1.0, 1e-12) << shape.surface.name << " " << edge;
      expect_unit_normals(tiles);
    }
}

TEST(WallTiles, OfEveryShapeAreAtLeastAnEdgeWide) {
  for (const Shape& shape : shapes())
    for (const double edge : {0.07, 0.1, 0.3}) {
      const auto tiles = tiles_of(shape.surface, edge);
      EXPECT_GT(tiles.size(), 10u);
      EXPECT_LT(static_cast<double>(tiles.size()), 1.01 * shape.area / square(edge) + 1.0);
      expect_widths(tiles, edge);
    }
}

TEST(WallTiles, OfEveryShapeGetPointsByTheirArea) {
  for (const Shape& shape : shapes())
    for (const double edge : {0.11, 0.35, 0.9}) {
      SCOPED_TRACE(shape.surface.name);
      expect_fair_shares(WallTiling(walls_of(shape.surface), low, high, edge), shape.sample);
    }
}

TEST(WallTiles, OfEveryShapeForgiveAPointAMillionthOffTheSurface) {
  for (const Shape& shape : shapes()) {
    SCOPED_TRACE(shape.surface.name);
    expect_fair_shares(WallTiling(walls_of(shape.surface), low, high, 0.35), shape.sample, 1e-6);
  }
}

TEST(WallTiles, OfASurfaceSmallerThanAnEdgeAreOne) {
  for (const Shape& shape : shapes()) {
    const auto tiles = tiles_of(shape.surface, 20.0);
    ASSERT_EQ(tiles.size(), 1u) << shape.surface.name;
    EXPECT_NEAR(tiles[0].area / shape.area, 1.0, 1e-12);
  }
  EXPECT_EQ(tiles_of(disc_surface("", {}, {0, 0, 1}, 0.9, 0.0), 1.0).size(), 1u);
  EXPECT_EQ(tiles_of(sphere_surface("", {}, 0.3), 1.0).size(), 1u);
}

TEST(WallTiles, OfARectangleAreWhereTheyShouldBe) {
  const Surface wall = rectangle_surface("", {1, 2, 3}, {0.6, 0, 0}, {0, 0.25, 0});
  const auto tiles = tiles_of(wall, 0.1);
  ASSERT_EQ(tiles.size(), 12u);  // six edges long but for rounding; 0.25 has room for two
  EXPECT_NEAR(norm(tiles[0].centre - Vec3{1.05, 2.0625, 3}), 0.0, 1e-15);
  EXPECT_NEAR(norm(tiles[11].centre - Vec3{1.55, 2.1875, 3}), 0.0, 1e-15);
  EXPECT_EQ(tiles[11].normal, (Vec3{0, 0, 1}));
  EXPECT_NEAR(tiles[11].u, 0.25, 1e-15);
  EXPECT_NEAR(tiles[11].v, 0.0625, 1e-15);
}

TEST(WallTiles, OfACylinderFaceOutwardAndUnrollFromThePerpendicular) {
  const Vec3 axis = unit({1, 2, 3}), base{0.5, -0.2, 0.1};
  const Surface wall = frustum_surfaces("", base, axis, 1.0, 1.0, 2.0, {"base", "top"})[0];
  const WallTiling tiling(walls_of(wall), low, high, 0.3);
  EXPECT_EQ(tiling.tiles().size(), 6u * 20u);
  for (const WallTile& tile : tiling.tiles()) {
    const Vec3 outward =
        std::cos(tile.u) * perpendicular(axis) + std::sin(tile.u) * cross(axis, perpendicular(axis));
    EXPECT_NEAR(norm(tile.normal - outward), 0.0, 1e-14);
    const double shortened = std::sin(pi / 20) / (pi / 20);
    EXPECT_NEAR(norm(tile.centre - (base + tile.v * axis + shortened * outward)), 0.0, 1e-14);
    const std::uint32_t mine = tiling.tile_of(0, no_facet, base + tile.v * axis + outward);
    EXPECT_EQ(&tiling.tiles()[mine], &tile);
  }
}

TEST(WallTiles, OfADiscMeetWhereTheirSectorsEnd) {
  const Vec3 axis{0, 0, 1}, ahead = perpendicular(axis), aside = cross(axis, ahead);
  const WallTiling tiling(walls_of(disc_surface("", {}, axis, 1.0, 0.9)), low, high, 0.1);
  const auto count = static_cast<std::uint32_t>(tiling.tiles().size());
  EXPECT_EQ(count, 59u);  // 2 pi 0.95 / 0.1
  for (std::uint32_t k = 0; k < count; ++k)
    for (const double off : {-1e-7, 1e-7}) {
      const double angle = 2 * pi * k / count + off;
      const Vec3 point = 0.95 * std::cos(angle) * ahead + 0.95 * std::sin(angle) * aside;
      EXPECT_EQ(tiling.tile_of(0, no_facet, point), (off < 0.0 ? k + count - 1 : k) % count);
    }
  const WallTiling whole(walls_of(disc_surface("", {}, axis, 1.0, 0.0)), low, high, 0.3);
  EXPECT_EQ(whole.tile_of(0, no_facet, {}), 0u);  // where there is no angle
}

TEST(WallTiles, OfAConeLeanAsItDoes) {
  const Surface wall = frustum_surfaces("", {}, {0, 0, 1}, 0.0, 3.0, 4.0, {"top"})[0];
  const auto tiles = tiles_of(wall, 0.5);
  EXPECT_EQ(tiles[0].normal, (Vec3{0, 0, -1}));  // the tip has room for one tile all round
  for (const WallTile& tile : std::span(tiles).subspan(1)) {
    EXPECT_GT(dot(tile.normal, tile.centre - Vec3{0, 0, tile.centre.z}), 0.0);
    EXPECT_LT(tile.normal.z, -0.6 + 1e-12);  // a mean over a sector leans a little more
    EXPECT_GT(tile.normal.z, -0.68);
  }
  const auto whole = tiles_of(wall, 20.0);
  EXPECT_NEAR(norm(whole[0].normal - Vec3{0, 0, -1}), 0.0, 1e-15);
  EXPECT_NEAR(norm(whole[0].centre - Vec3{0, 0, 8.0 / 3.0}), 0.0, 1e-14);
}

TEST(WallTiles, OfAPlaneFillWhatTheDomainCutsOutOfIt) {
  const auto floor = tiles_of(plane_surface("", {0, 0, 1}, {0, 0, 1}), 0.5);
  EXPECT_EQ(floor.size(), 16u * 14u);
  EXPECT_NEAR(total_area(floor), 56.0, 56.0 * 1e-12);
  expect_widths(floor, 0.5);
  for (const WallTile& tile : floor) EXPECT_NEAR(tile.area, 0.25, 1e-12);

  // Through the middle of a cube, at right angles to its diagonal: a regular hexagon, 3/4 sqrt(3) in area.
  const Surface slope = plane_surface("", {0.5, 0.5, 0.5}, unit({1, 1, 1}));
  for (const double edge : {0.05, 0.2, 5.0}) {
    const WallTiling tiling(walls_of(slope), {0, 0, 0}, {1, 1, 1}, edge);
    EXPECT_NEAR(total_area(tiles_of(tiling)), 0.75 * root(3.0), 1e-12);
    for (const WallTile& tile : tiling.tiles()) EXPECT_GE(tile.area, 0.499 * least(square(edge), 2.0));
    expect_fair_shares(tiling, [&](Uniform& uniform) {
      for (;;) {
        Vec3 p{uniform(0, 1), uniform(0, 1), 0.0};
        p.z = 1.5 - p.x - p.y;
        if (p.z >= 0.0 && p.z <= 1.0) return Hit{0, no_facet, p};
      }
    });
  }
}

TEST(WallTiles, OfAPlaneOnAFaceOfTheDomainFillItAndOutsideAreNone) {
  EXPECT_NEAR(total_area(tiles_of(plane_surface("", {9, 9, -2}, {0, 0, 1}), 0.7)), 56.0, 1e-10);
  EXPECT_NEAR(total_area(tiles_of(plane_surface("", {9, 9, 6 + 1e-14}, {0, 0, -1}), 0.7)), 56.0, 1e-10);
  const WallTiling nothing(walls_of(plane_surface("", {0, 0, 7}, {0, 0, 1})), low, high, 0.7);
  EXPECT_TRUE(nothing.tiles().empty());
  EXPECT_EQ(nothing.tile_of(0, no_facet, {0, 0, 7}), WallTiling::no_tile);
  const WallTiling floor(walls_of(plane_surface("", {0, 0, -2}, {0, 0, 1})), low, high, 0.7);
  EXPECT_EQ(floor.tile_of(0, no_facet, {-99, -99, -2}), floor.tile_of(0, no_facet, {-2.99, -3.99, -2}));
}

TEST(WallTiles, OfAMeshedRectangleAreThoseOfTheRectangle) {
  const Surface shape = rectangle_surface("", {1, 2, 3}, {1.7, 0, 0}, {0, 0.9, 0});
  for (const int fineness : {1, 7, 30})
    for (const double edge : {0.13, 0.3, 2.0}) {
      const auto expected = tiles_of(shape, edge);
      const Walls walls = walls_of(sheet(fineness, fineness + 1, [](double s, double t) {
        return Vec3{1 + 1.7 * s, 2 + 0.9 * t, 3};
      }));
      const WallTiling tiling(walls, low, high, edge);
      ASSERT_EQ(tiling.tiles().size(), expected.size());
      for (const WallTile& tile : expected) {
        const WallTile& same = tiling.tiles()[tiling.tile_of(0, no_facet, tile.centre)];
        EXPECT_NEAR(same.area / tile.area, 1.0, 1e-12);
        EXPECT_NEAR(norm(same.centre - tile.centre), 0.0, 1e-13);
        EXPECT_NEAR(norm(same.normal - tile.normal), 0.0, 1e-14);
      }
      for (const double off : {0.0, 1e-6}) expect_fair_shares(tiling, sampler_of(walls), off);
    }
}

TEST(WallTiles, OfPatchesHaveTheirAreaAndGetPointsByIt) {
  for (const TriangleMesh& mesh : {tilted_sheet(), faceted_cylinder(1.0, 2.0, 37, 9), faceted_sphere(1.0, 24),
                                   faceted_cylinder(0.2, 3.0, 24, 1)}) {
    const Walls walls = walls_of(mesh);
    for (const double edge : {0.11, 0.3, 0.8, 9.0}) {
      SCOPED_TRACE(edge);
      const WallTiling tiling(walls, low, high, edge);
      EXPECT_NEAR(total_area(tiles_of(tiling)) / area_of(mesh), 1.0, 1e-11);
      expect_unit_normals(tiles_of(tiling));
      for (const WallTile& tile : tiling.tiles())
        EXPECT_GE(tile.area, 0.499 * least(square(edge), 2.0 * area_of(mesh)));
      for (const double off : {0.0, 1e-6}) expect_fair_shares(tiling, sampler_of(walls), off);
      for (const double off : {0.0, 1e-6}) expect_fair_shares(tiling, without_facets(sampler_of(walls)), off);
    }
    EXPECT_EQ(WallTiling(walls, low, high, 9.0).tiles().size(), walls.surfaces.size());
  }
}

TEST(WallTiles, OfAPatchThroughTheEdgesOfCellsJoinThoughTheyShareNoFace) {
  // Upright and at 45 degrees to the grid, whose cells it crosses along their diagonals.
  const Walls walls = walls_of(sheet(1, 1, [](double s, double t) { return Vec3{4 * s, 4 * s, 0.3 * t}; }));
  const auto tiles = tiles_of(WallTiling(walls, low, high, 1.0));
  EXPECT_NEAR(total_area(tiles), 1.2 * root(2.0), 1e-14);
  EXPECT_GT(tiles.size(), 1u);
  for (const WallTile& tile : tiles) EXPECT_GT(tile.area, 0.5);
}

TEST(WallTiles, OfAFacetedCylinderFaceOutwardAndAreUnrolled) {
  const Walls walls = walls_of(faceted_cylinder(1.0, 2.0, 90, 20));
  ASSERT_EQ(walls.surfaces.size(), 1u);
  const auto tiles = tiles_of(WallTiling(walls, low, high, 0.25));
  EXPECT_GT(tiles.size(), 150u);
  for (const WallTile& tile : tiles) {
    const Vec3 outward = unit({tile.centre.x, tile.centre.y, 0.0});
    EXPECT_GT(dot(tile.normal, outward), 0.99);
    EXPECT_GE(tile.u, 0.0);
    EXPECT_LE(tile.u, 2.0 * pi);
    EXPECT_NEAR(tile.v, tile.centre.z - 1.0, 1e-12);
  }
}

TEST(WallTiles, OfThePatchesOfABoxAreThoseOfItsFaces) {
  const Walls walls = walls_of(meshed_box({0, 0, 0}, {1.0, 0.7, 0.4}));
  ASSERT_EQ(walls.surfaces.size(), 6u);
  const WallTiling tiling(walls, low, high, 0.1);
  EXPECT_EQ(tiling.tiles().size(), 2u * (70 + 40 + 28));
  for (const WallTile& tile : tiling.tiles()) EXPECT_NEAR(tile.area, 0.01, 1e-14);
  expect_fair_shares(tiling, sampler_of(walls), 1e-6);
}

TEST(WallTiles, OfSeveralSurfacesStandInTheirOrder) {
  Walls walls = walls_of(faceted_cylinder(1.0, 2.0, 37, 9));
  walls.surfaces.insert(walls.surfaces.begin(), sphere_surface("ball", {}, 1.0));
  walls.surfaces.push_back(rectangle_surface("lid", {}, {1, 0, 0}, {0, 1, 0}));
  const WallTiling tiling(walls, low, high, 0.3);
  EXPECT_TRUE(std::ranges::is_sorted(tiling.tiles(), {}, &WallTile::surface));
  EXPECT_EQ(tiling.tile_of(2, no_facet, {9, 9, 0}) + 1, tiling.tiles().size());
  EXPECT_EQ(tiling.tiles()[tiling.tile_of(1, 0, {1, 0, 0})].surface, 1u);
  EXPECT_EQ(tiling.tiles()[tiling.tile_of(1, no_facet, {50, 0, 0})].surface, 1u);  // far off: the nearest
}

TEST(WallTiles, RefuseAnEdgeThatMakesNoSense) {
  const Walls walls = walls_of(sphere_surface("ball", {}, 1.0));
  for (const double edge : {0.0, -1.0, 1e-6, std::nan("")})
    EXPECT_THROW(WallTiling(walls, low, high, edge), Failure);
}

}  // namespace
}  // namespace pulvis::measures
