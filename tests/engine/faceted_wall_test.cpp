// SPDX-License-Identifier: Apache-2.0
// Meshes as walls: nearest points, patches, passing through, and the same bits however they are found.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

TriangleMesh soup(std::size_t count, Draw& draw) {
  TriangleMesh mesh;
  for (std::uint32_t t = 0; t < count; ++t) {
    const Vec3 centre = draw.vector(1.0);
    for (int k = 0; k < 3; ++k) mesh.points.push_back(centre + draw.vector(0.3));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

/// The smallest distance over a fine grid on the triangle: never below the true one.
double sampled_distance(const TriangleMesh& mesh, std::uint32_t t, const Vec3& p) {
  constexpr int n = 60;
  double least_distance = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = double(i) / n, v = double(j) / n;
      const Vec3 q = (1 - u - v) * mesh.corner(t, 0) + u * mesh.corner(t, 1) + v * mesh.corner(t, 2);
      least_distance = std::min(least_distance, norm(q - p));
    }
  return least_distance;
}

TEST(FacetedWall, FindsTheNearestPointOfATriangle) {
  for (std::uint64_t number = 0; number < 300; ++number) {
    Draw draw(number, 101);
    const FacetedWall wall(soup(1, draw), {});
    const Vec3 p = draw.vector(1.5);
    const NearestPoint nearest = wall.nearest(0, p);
    const double distance = norm(nearest.point - p), sampled = sampled_distance(wall.mesh(), 0, p);
    EXPECT_LE(distance, sampled + 1e-14) << number;
    EXPECT_GE(distance, sampled - 0.02) << number;
  }
}

TEST(BoxTree, MissesNoTriangleThatIsNear) {
  Draw draw(1, 102);
  const FacetedWall wall(soup(2000, draw), {});
  for (int look = 0; look < 200; ++look) {
    const Vec3 p = draw.vector(1.2);
    const double far = draw.between(0.01, 0.4);
    std::vector<bool> seen(2000, false);
    wall.for_near(p, far, [&](std::uint32_t t) {
      EXPECT_FALSE(seen[t]) << "twice";
      seen[t] = true;
    });
    for (std::uint32_t t = 0; t < 2000; ++t) {
      const bool near = norm(wall.nearest(t, p).point - p) < far;
      EXPECT_TRUE(seen[t] || !near);
    }
  }
}

TEST(FacetedWall, GathersSmoothTrianglesIntoPatches) {
  Draw draw(2, 103);
  EXPECT_EQ(FacetedWall(random_box({0, 0, 0}, {1, 2, 3}, 5, 0.24, draw), {}).patches(), 6u);
  const auto turned = [&](Smoothness s) {
    // A tent: two faces that meet at 15 degrees.
    const double up = std::tan(7.5 * pi / 180.0);
    return FacetedWall(joined({random_triangles({-1, 0, 0}, {1, 0, up}, {0, 1, 0}, 4, 4, 0.2, draw),
                               random_triangles({0, 0, up}, {1, 0, -up}, {0, 1, 0}, 4, 4, 0.2, draw)}),
                       s)
        .patches();
  };
  EXPECT_EQ(turned({}), 1u);
  EXPECT_EQ(turned({10.0 * pi / 180.0, 0.0}), 2u);
  EXPECT_EQ(turned({20.0 * pi / 180.0, 0.1}), 1u) << "0.2 wide over 15 degrees: gentler than 0.1";
  EXPECT_GE(turned({20.0 * pi / 180.0, 10.0}), 2u) << "but not for a sphere of 10";
}

TEST(FacetedWall, LetsNothingThroughItsEdgesAndCorners) {
  // Ways from inside to outside of a closed box, many of them exactly through edges and corners.
  Draw draw(3, 104);
  const FacetedWall wall(random_box({-1, -1, -1}, {1, 1, 1}, 4, 0.24, draw), {});
  const auto crossings = [&](const Vec3& from, const Vec3& to) {
    int count = 0;
    for (std::uint32_t t = 0; t < wall.mesh().triangles.size(); ++t) count += wall.passed(t, from, to);
    return count;
  };
  for (const Vec3& corner : wall.mesh().points) {
    EXPECT_GE(crossings(0.5 * corner, 1.5 * corner), 1) << "through a corner of triangles";
    const Vec3 from = draw.vector(0.9), to = from + 5.0 * draw.direction();
    EXPECT_GE(crossings(from, to), 1);
    EXPECT_EQ(crossings(0.3 * from, 0.3 * from + draw.vector(0.1)), 0);
  }
  for (const auto& t : wall.mesh().triangles)
    for (unsigned k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (wall.mesh().points[t[k]] + wall.mesh().points[t[(k + 1) % 3]]);
      EXPECT_GE(crossings(0.5 * middle, 1.5 * middle), 1) << "through an edge";
    }
}

/// A floor and a wall joined by a fillet of this radius in so many facets; the corner is at the origin.
TriangleMesh filleted_corner(double fillet, int facets) {
  std::vector<Vec3> profile{{0.02, 0, 0}};
  for (int k = 0; k <= facets; ++k) {
    const double angle = 0.5 * pi * k / facets;
    profile.push_back({fillet * (1 - std::sin(angle)), 0, fillet * (1 - std::cos(angle))});
  }
  profile.push_back({0, 0, 0.02});
  std::vector<TriangleMesh> strips;
  Draw draw(4, 105);
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
    strips.push_back(random_triangles(profile[k] - Vec3{0, 0.01, 0}, profile[k + 1] - profile[k],
                                      {0, 0.02, 0}, 1, 4, 0.0, draw));
  return joined(strips);
}

TEST(SphereInAFillet, TouchesBothSidesIfItIsTooLargeForIt) {
  const double radius = 1e-3;
  for (const double fillet : {0.3e-3, 5e-3}) {
    Stuff stuff;
    Model m = one_material(stuff, {}, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 1e-6, radius, radius);
    m.body_force.gravity = {};
    add_mesh(m, filleted_corner(fillet, 9), false, {20.0 * pi / 180.0, radius});
    EXPECT_EQ(m.walls.surfaces.size() == 1, fillet > radius);
    const double off = 0.99 * radius;
    const Vec3 at = fillet > radius ? Vec3{fillet - (fillet - off) * std::sqrt(0.5), 0,
                                           fillet - (fillet - off) * std::sqrt(0.5)}
                                    : Vec3{off, 0, off};
    Simulation s(m, state_of(m, {parcel(0, at, radius, 1e12)}), 1);
    s.step();
    EXPECT_EQ(touching(s.walls()), fillet > radius ? 1u : 2u) << fillet;
  }
}

/// Cohesive parcels in a box of triangles that turns and swings, above a plane that is taken away.
Model turning_box(Draw& draw) {
  Stuff stuff{2500.0, 5e6, 0.3, 0.6, 0.4, 0.1, 0.02};
  LawParts parts;
  parts.normal = "jkr";
  Model m = one_material(stuff, parts, {-0.04, -0.04, -0.04}, {0.04, 0.04, 0.04}, 4e-6, 1e-3, 1e-3);
  add_mesh(m, random_box({-0.0087, -0.0087, -0.0087}, {0.0087, 0.0087, 0.0087}, 4, 0.24, draw));
  m.walls.bodies[0].motions = {0, 1};
  m.walls.bodies.push_back({"lid", {}});
  m.walls.surfaces.push_back(plane_surface("lid", {0, 0, 0.0086}, {0, 0, 1}));
  m.walls.surfaces.back().body = 1;
  motions::Sine sine;
  sine.wave = {5e-4, 40.0, -0.25};
  m.motions = {{motions::Rotation{{0.002, 0, 0}, {0, 0.6, 0.8}, 5.0, 0.0}}, {sine}};
  return m;
}

std::string hash_after(const Model& m, int threads, bool saved_between) {
  Draw draw(5, 106);
  std::vector<Parcel> parcels;
  for (int k = 0; k < 343; ++k) {
    const auto at = [](int i) { return (i - 3) * 2.1e-3; };
    parcels.push_back(parcel(static_cast<std::uint32_t>(k), {at(k % 7), at(k / 7 % 7), at(k / 49)}, 1e-3,
                             2500, draw.vector(0.3), draw.vector(50)));
  }
  Simulation s(m, state_of(m, parcels), threads);
  s.start_motion(0);
  for (int k = 0; k < 300; ++k) s.step();
  s.start_motion(1);
  s.set_absent(1, true);
  for (int k = 0; k < 300; ++k) s.step();
  s.stop_motion(0);
  if (!saved_between) {
    for (int k = 0; k < 300; ++k) s.step();
    EXPECT_EQ(s.state().parcels.size(), 343u);
    return s.hash();
  }
  Simulation again(m, load_state(save_state(s.snapshot())), threads);
  for (int k = 0; k < 300; ++k) again.step();
  return again.hash();
}

TEST(TurningMesh, GivesTheSameBitsForAnyThreadsSkinsAndWhenSaved) {
  Draw draw(6, 107);
  Model m = turning_box(draw);
  const std::string straight = hash_after(m, 1, false);
  EXPECT_EQ(hash_after(m, 3, false), straight);
  EXPECT_EQ(hash_after(m, 1, true), straight);
  m.skin = 0.5;
  EXPECT_EQ(hash_after(m, 2, false), straight);
  m.skin = 3.0;
  EXPECT_EQ(hash_after(m, 1, true), straight);
}

}  // namespace
