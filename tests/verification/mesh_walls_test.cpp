// SPDX-License-Identifier: Apache-2.0
// Walls of triangles that stand for curved ones; flat ones are compared by `pulvis validate --only walls`.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

constexpr double radius = 1e-3;

Model empty() {
  Stuff stuff{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, 0.0};
  return one_material(stuff, {}, {-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}, 2e-6, radius, radius);
}

/// Mantle of a cone (or cylinder) about the z axis as a mesh: `count` facets around, one along. The corners lie
/// on the mantle, or (`outside`) the middles of the facets do.
TriangleMesh faceted_cone(double radius_low, double radius_high, double height, std::uint32_t count) {
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k < count; ++k) {
    const double angle = 2.0 * pi * k / count;
    mesh.points.push_back({radius_low * std::cos(angle), radius_low * std::sin(angle), 0});
    mesh.points.push_back({radius_high * std::cos(angle), radius_high * std::sin(angle), height});
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a = 2 * k, b = 2 * ((k + 1) % count);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

/// Largest difference of the wall's force on a sphere held at 200 places near the mantle, over the force.
double force_error(double radius_low, double radius_high, std::uint32_t count) {
  const double height = 0.02;
  Model shape = empty(), mesh = empty();
  for (const Surface& s :
       frustum_surfaces("cone", {0, 0, 0}, {0, 0, 1}, radius_low, radius_high, height, {"base", "top"}))
    add_wall(shape, s);
  add_mesh(mesh, faceted_cone(radius_low, radius_high, height, count));
  EXPECT_EQ(mesh.walls.surfaces.size(), 1u);
  const double slant = std::hypot(height, radius_high - radius_low);
  double worst = 0.0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 93);
    const double angle = draw.between(0, 2 * pi), share = draw.between(0.2, 0.8);
    const double away = radius - 0.05 * radius;  // from the mantle, measured across it
    const double out = radius_low + share * (radius_high - radius_low) - away * height / slant;
    const Vec3 at{out * std::cos(angle), out * std::sin(angle),
                  share * height + away * (radius_high - radius_low) / slant};
    double force[2] = {};
    for (int which = 0; which < 2; ++which) {
      const Model& m = which == 0 ? shape : mesh;
      Simulation s(m, state_of(m, {parcel(0, at, radius, 1e12)}), 1);
      s.step();
      for (std::size_t f = 0; f < m.walls.surfaces.size(); ++f) force[which] += norm(s.force_on_surface(f));
    }
    worst = std::max(worst, std::abs(force[1] / force[0] - 1.0));
  }
  return worst;
}

TEST(FacetedWall, ApproachesCylinderAndConeAsTheSquareOfItsFacets) {
  for (const auto& [low, high] : {std::pair{8e-3, 8e-3}, std::pair{4e-3, 12e-3}}) {
    const double coarse = force_error(low, high, 128), fine = force_error(low, high, 512);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2.0, 0.1) << coarse << " " << fine;
    // F grows as overlap^1.5, and the middle of a facet lies R (pi/n)^2/2 nearer.
    const double nearer = high * (pi / 512) * (pi / 512) / 2.0;
    EXPECT_LT(fine, 1.1 * 1.5 * nearer / (0.05 * radius));
  }
}

/// Where a sphere is after it has swung in a lying trough for a while.
Vec3 after_swinging(const Model& m, int steps) {
  const double away = 8e-3 - radius;
  Simulation s(m, state_of(m, {parcel(0, {away * std::sin(1.0), -away * std::cos(1.0), 0.01}, radius, 2500)}),
               1);
  for (int k = 0; k < steps; ++k) s.step();
  return s.state().parcels.body[0].position;
}

TEST(FacetedWall, SwingsASphereAsTheCylinderDoesThatItApproaches) {
  const auto prepare = [](Model m) {
    m.body_force.gravity = {0, -9.81, 0};
    return m;
  };
  Model shape = prepare(empty());
  for (const Surface& s : frustum_surfaces("trough", {0, 0, 0}, {0, 0, 1}, 8e-3, 8e-3, 0.02, {"base", "top"}))
    add_wall(shape, s);
  const Vec3 exact = after_swinging(shape, 40000);
  double error[3];
  for (int k = 0; k < 3; ++k) {
    Model mesh = prepare(empty());
    add_mesh(mesh, faceted_cone(8e-3, 8e-3, 0.02, 128u << (2 * k)));
    error[k] = norm(after_swinging(mesh, 40000) - exact) / radius;
  }
  EXPECT_LT(error[1], error[0] / 4.0);
  EXPECT_LT(error[2], error[1] / 4.0);
  EXPECT_LT(error[2], error[0] / 256.0) << "second order over a factor of 16";
}

}  // namespace
