// SPDX-License-Identifier: Apache-2.0
#include "output/picture_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pulvis {
namespace {

// A unit cube; `shared` corners or own ones for each triangle.
SurfaceMesh cube(bool shared) {
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.push_back(
        {static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
  if (shared) return mesh;
  SurfaceMesh own;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(own.points.size());
    for (const auto corner : triangle) own.points.push_back(mesh.points[corner]);
    own.triangles.push_back({first, first + 1, first + 2});
  }
  return own;
}

double length(const std::vector<Segment>& segments) {
  double sum = 0.0;
  for (const Segment& segment : segments) sum += norm(segment[1] - segment[0]);
  return sum;
}

double area(const std::vector<Vec3>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    sum += 0.5 * norm(cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
  return sum;
}

TEST(PictureGeometry, FindsTheTwelveEdgesOfACubeAndNoDiagonals) {
  for (const bool shared : {true, false}) {
    PictureRequest request;
    request.walls = cube(shared);
    const auto geometry = picture_geometry(request);
    EXPECT_NEAR(length(geometry.edges) * geometry.unit, 12.0, 1e-12);
    EXPECT_EQ(geometry.edges.size(), 12u);
  }
}

TEST(PictureGeometry, CutsWallsWhereThePlaneGoesThrough) {
  PictureRequest request;
  request.walls = cube(true);
  request.cut = CutPlane{{0.0, 0.25, 0.0}, {0.0, -3.0, 0.0}};  // takes away y < 0.25
  const auto geometry = picture_geometry(request);
  EXPECT_NEAR(area(geometry.wall_corners) * geometry.unit * geometry.unit, 1.0 + 4.0 * 0.75, 1e-12);
  EXPECT_NEAR(length(geometry.sections) * geometry.unit, 4.0, 1e-12);
  EXPECT_NEAR(length(geometry.edges) * geometry.unit, 4.0 + 4.0 * 0.75, 1e-12);
}

TEST(PictureGeometry, RemovesKeepsAndOpensSpheres) {
  PictureRequest request;
  request.cut = CutPlane{{0.0, 0.0, 0.0}, {0.0, 0.0, 2.0}};  // takes away z > 0
  request.spheres = {{{0, 0, 2e-6}, 1e-6, 0.1f},
                     {{0, 0, -2e-6}, 1e-6, 0.2f},
                     {{0, 0, 0.6e-6}, 1e-6, 0.3f},
                     {{5e-6, 0, -0.8e-6}, 1e-6, 0.4f}};
  const auto geometry = picture_geometry(request);
  EXPECT_EQ(geometry.sphere_values, (std::vector<float>{0.2f, 0.3f, 0.4f}));
  EXPECT_EQ(geometry.disc_values, (std::vector<float>{0.3f, 0.4f}));
  EXPECT_NEAR(geometry.discs[0].radius * geometry.unit, 0.8e-6, 1e-12);  // 3-4-5 triangles
  EXPECT_NEAR(geometry.discs[1].radius * geometry.unit, 0.6e-6, 1e-12);
  for (const Ball& disc : geometry.discs) EXPECT_NEAR(disc.z, geometry.cut->point.z, 1e-6);
}

TEST(PictureGeometry, FitsMicrometresIntoABallOfRadiusOne) {
  PictureRequest request;
  request.spheres = {{{1.0, 1.0, 1.0}, 1e-6, 0.0f}, {{1.0 + 1e-5, 1.0, 1.0}, 1e-6, 0.0f}};
  const auto geometry = picture_geometry(request);
  for (const Ball& sphere : geometry.spheres)
    EXPECT_LE(std::hypot(sphere.x, sphere.y, sphere.z) + sphere.radius, 1.0 + 1e-6);
  EXPECT_NEAR(geometry.mean_radius * geometry.unit, 1e-6, 1e-12);
}

TEST(PictureGeometry, RefusesSpheresThatMakeNoSense) {
  PictureRequest request;
  request.spheres = {{{0, 0, 0}, 0.0, 0.0f}};
  EXPECT_THROW(picture_geometry(request), std::invalid_argument);
  request.spheres = {{{std::numeric_limits<double>::quiet_NaN(), 0, 0}, 1.0, 0.0f}};
  EXPECT_THROW(picture_geometry(request), std::invalid_argument);
}

}  // namespace
}  // namespace pulvis
