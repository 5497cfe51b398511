// SPDX-License-Identifier: Apache-2.0
// A wall of triangles does what the same wall as shapes does, for the same law.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

constexpr double radius = 1e-3, limit = 1e-9;

Model empty(const std::string& normal) {
  Stuff stuff{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, normal == "jkr" ? 0.02 : 0.0};
  LawParts parts;
  parts.normal = normal;
  return one_material(stuff, parts, {-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}, 2e-6, radius, radius);
}

/// A rectangle as a shape and as triangles.
struct Face {
  Vec3 corner, along, across;
};

Model of_shapes(const std::string& normal, const std::vector<Face>& faces) {
  Model m = empty(normal);
  for (const Face& f : faces) add_wall(m, rectangle_surface("face", f.corner, f.along, f.across));
  return m;
}

Model of_triangles(const std::string& normal, const std::vector<Face>& faces, std::uint64_t number) {
  Model m = empty(normal);
  Draw draw(number, 91);
  std::vector<TriangleMesh> parts;
  for (const Face& f : faces)
    parts.push_back(random_triangles(f.corner, f.along, f.across, 6, 5, 0.24, draw));
  add_mesh(m, joined(parts));
  return m;
}

struct Difference {
  double position = 0.0, velocity = 0.0, spin = 0.0, force = 0.0;  ///< relative
  std::size_t contacts = 0;                                        ///< steps with different numbers of them
};

/// Runs both and compares them at every step.
Difference compare(const Model& a, const Model& b, const Parcel& start, int steps) {
  Simulation one(a, state_of(a, {start}), 1), two(b, state_of(b, {start}), 1);
  Difference worst;
  double speed = norm(start.velocity), turning = norm(start.spin), push = start.mass * 9.81;
  const auto raise = [](double& most, double value) { most = std::max(most, value); };
  for (int k = 0; k < steps; ++k) {
    one.step();
    two.step();
    if (one.state().parcels.size() == 0 || two.state().parcels.size() == 0) {
      ADD_FAILURE() << "the sphere escaped at step " << k;
      break;
    }
    const Parcel &p = one.state().parcels.body[0], &q = two.state().parcels.body[0];
    const Vec3 &f = one.state().parcels.load[0].force, &g = two.state().parcels.load[0].force;
    raise(speed, norm(p.velocity));
    raise(turning, norm(p.spin));
    raise(push, norm(f));
    raise(worst.position, norm(p.position - q.position) / radius);
    raise(worst.velocity, norm(p.velocity - q.velocity) / speed);
    if (turning > 0.0) raise(worst.spin, norm(p.spin - q.spin) / turning);
    raise(worst.force, norm(f - g) / push);
    worst.contacts += one.snapshot().walls.size() != two.snapshot().walls.size();
  }
  return worst;
}

void expect_equal(const std::vector<Face>& faces, const Parcel& start, int steps) {
  for (const std::string normal : {"hertz", "jkr"})
    for (std::uint64_t number = 0; number < 5; ++number) {
      const Difference d =
          compare(of_shapes(normal, faces), of_triangles(normal, faces, number), start, steps);
      EXPECT_LT(d.position, limit) << normal << ", mesh " << number;
      EXPECT_LT(d.velocity, limit) << normal << ", mesh " << number;
      EXPECT_LT(d.spin, limit) << normal << ", mesh " << number;
      EXPECT_LT(d.force, limit) << normal << ", mesh " << number;
      EXPECT_EQ(d.contacts, 0u) << normal << ", mesh " << number;
    }
}

const std::vector<Face> plane{{{-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0}}};

TEST(TriangulatedWall, ActsAsThePlaneOnASphereThrownOnIt) {
  expect_equal(plane, parcel(0, {-0.004, -0.003, 2e-3}, radius, 2500, {0.08, 0.05, -0.2}, {30, -50, 80}),
               20000);
}

TEST(TriangulatedWall, ActsAsTheCornerOnASphereThrownIntoIt) {
  const double s = 0.012;
  expect_equal({{{0, 0, 0}, {s, 0, 0}, {0, s, 0}},
                {{0, 0, 0}, {0, s, 0}, {0, 0, s}},
                {{0, 0, 0}, {0, 0, s}, {s, 0, 0}}},
               parcel(0, {2e-3, 2.3e-3, 1.7e-3}, radius, 2500, {-0.15, -0.12, -0.1}, {30, -50, 80}), 20000);
}

TEST(TriangulatedWall, ActsAsTheEdgeOnASphereThatRollsOverIt) {
  // Along the edge it also moves and spins, so that friction there has work to do.
  const double s = 0.012;
  expect_equal({{{-s, -s / 2, 0}, {s, 0, 0}, {0, s, 0}}, {{0, -s / 2, 0}, {0, 0, -s}, {0, s, 0}}},
               parcel(0, {-1.5e-3, -1e-3, 0.999e-3}, radius, 2500, {0.05, 0.03, 0}, {0, 50, 20}), 30000);
}

TEST(TriangulatedWall, ActsAsTheStepOnASphereThatRollsDown) {
  const double s = 0.012, h = 1.5e-3;
  expect_equal({{{-s, -s / 2, h}, {s, 0, 0}, {0, s, 0}},
                {{0, -s / 2, h}, {0, 0, -h}, {0, s, 0}},
                {{0, -s / 2, 0}, {s, 0, 0}, {0, s, 0}}},
               parcel(0, {-1.2e-3, 0.3e-3, h + 0.9995e-3}, radius, 2500, {0.06, -0.02, 0}, {10, 60, -20}),
               40000);
}

TEST(TriangulatedWall, KeepsTheContactOfASphereOverAThousandTriangles) {
  // It slides first and then rolls: 20 mm over triangles of about 2 mm. All is turned aslant, so that roundings
  // differ from triangle to triangle.
  const Rigid turn = Rigid::rotation(0.13, {}, {0.48, 0.6, 0.64});
  for (const std::string normal : {"hertz", "jkr"}) {
    Model shape = empty(normal), mesh = empty(normal);
    add_wall(shape, plane_surface("plane", {0, 0, 0}, turn.turn({0, 0, 1})));
    Draw draw(7, 92);
    TriangleMesh flat = random_triangles({-0.02, -0.02, 0}, {0.04, 0, 0}, {0, 0.04, 0}, 25, 20, 0.24, draw);
    for (Vec3& point : flat.points) point = turn(point);
    add_mesh(mesh, flat);
    shape.body_force.gravity = mesh.body_force.gravity = turn.turn({0, 0, -9.81});
    ASSERT_EQ(mesh.walls.meshes[0].mesh().triangles.size(), 1000u);
    ASSERT_EQ(mesh.walls.surfaces.size(), 1u) << "one surface";
    const double weight = 2500 * sphere_volume(radius) * 9.81;
    Stuff stuff{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, 0.0};
    const double rest =
        laws::hertz_overlap_under(weight, radius, material_pair(stuff, stuff).effective_modulus);
    Parcel start = parcel(0, turn({-0.015, -0.012, radius - rest}), radius, 2500, turn.turn({0.3, 0.25, 0}),
                          turn.turn({0, 0, 5}));
    const Difference d = compare(shape, mesh, start, 50000);
    EXPECT_LT(d.position, limit) << normal;
    EXPECT_LT(d.velocity, limit) << normal;
    EXPECT_LT(d.spin, limit) << normal;
    EXPECT_LT(d.force, limit) << normal;
    EXPECT_EQ(d.contacts, 0u) << normal;
  }
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
  Model shape = empty("hertz"), mesh = empty("hertz");
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
  Model shape = prepare(empty("hertz"));
  for (const Surface& s : frustum_surfaces("trough", {0, 0, 0}, {0, 0, 1}, 8e-3, 8e-3, 0.02, {"base", "top"}))
    add_wall(shape, s);
  const Vec3 exact = after_swinging(shape, 40000);
  double error[3];
  for (int k = 0; k < 3; ++k) {
    Model mesh = prepare(empty("hertz"));
    add_mesh(mesh, faceted_cone(8e-3, 8e-3, 0.02, 128u << (2 * k)));
    error[k] = norm(after_swinging(mesh, 40000) - exact) / radius;
  }
  EXPECT_LT(error[1], error[0] / 4.0);
  EXPECT_LT(error[2], error[1] / 4.0);
  EXPECT_LT(error[2], error[0] / 256.0) << "second order over a factor of 16";
}

}  // namespace
