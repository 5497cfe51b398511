// SPDX-License-Identifier: Apache-2.0
// How many contacts a sphere has where surfaces of a wall meet, and what happens to them on the way.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 1e-3;

Region unit_box() {
  Region box;
  box.min = {-0.01, -0.01, -0.01};
  box.max = {0.01, 0.01, 0.01};
  return box;
}

Model with_surfaces(const std::vector<Surface>& surfaces, const char* normal = "hertz") {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  stuff.restitution = 1.0;
  stuff.work_of_adhesion = 0.05;
  LawParts parts;
  parts.normal = normal;
  Model m = one_material(stuff, parts, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, 1e-6, radius, radius);
  m.body_force.gravity = {};
  for (const Surface& s : surfaces) add_wall(m, s);
  return m;
}

/// A sphere that nothing can stop or turn: it goes where the test sends it.
Parcel heavy(const Vec3& at, const Vec3& velocity = {}) { return parcel(0, at, radius, 1e15, velocity); }

std::size_t contacts_at(const std::vector<Surface>& surfaces, const Vec3& at) {
  const Model m = with_surfaces(surfaces);
  Simulation s(m, state_of(m, {heavy(at)}), 1);
  s.step();
  return touching(s.walls());
}

Vec3 force_at(const std::vector<Surface>& surfaces, const Vec3& at) {
  const Model m = with_surfaces(surfaces);
  Simulation s(m, state_of(m, {heavy(at)}), 1);
  s.step();
  Vec3 sum;
  for (std::size_t k = 0; k < surfaces.size(); ++k) sum += s.force_on_surface(k);
  return -sum;
}

TEST(SphereOutsideABox, HasOneContactAtEveryEdgeAndCorner) {
  const auto box = box_surfaces("box", unit_box(), {});
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const int out = std::abs(x) + std::abs(y) + std::abs(z);
        if (out == 0) continue;
        // A little inside the reach of the face, edge or corner that lies in this direction.
        const Vec3 direction = Vec3{1.0 * x, 1.0 * y, 1.0 * z} / std::sqrt(1.0 * out);
        const Vec3 at = Vec3{0.01 * x, 0.01 * y, 0.01 * z} + (0.999 * radius) * direction;
        EXPECT_EQ(contacts_at(box, at), 1u) << x << y << z;
        EXPECT_NEAR(norm(force_at(box, at) / norm(force_at(box, at)) - direction), 0.0, 1e-9) << x << y << z;
      }
}

TEST(SphereInsideABox, HasOneContactAtAFaceTwoAtAnEdgeThreeInACorner) {
  const auto box = box_surfaces("box", unit_box(), {});
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const double reach = 0.01 - 0.999 * radius;
        EXPECT_EQ(contacts_at(box, {reach * x, reach * y, reach * z}),
                  static_cast<std::size_t>(std::abs(x) + std::abs(y) + std::abs(z)));
      }
}

TEST(SphereOnTheRimOfAnOpenBox, HasOneContact) {
  const auto cup = box_surfaces("cup", unit_box(), {"+z"});
  EXPECT_EQ(contacts_at(cup, {0.01, 0.0, 0.01 + 0.999 * radius}), 1u);
  EXPECT_EQ(contacts_at(cup, {0.0102, 0.003, 0.01 + 0.9 * radius}), 1u);
  EXPECT_EQ(contacts_at(cup, {0.01, 0.01, 0.01 + 0.999 * radius}), 1u) << "where two walls end";
}

TEST(SphereInACylinder, HasTwoContactsInTheCornerAndOneOnTheRim) {
  Region r;
  r.shape = Region::Shape::cylinder;
  r.base = {0, 0, 0};
  r.axis = {0, 0, 1};
  r.radius = 0.01;
  r.height = 0.02;
  const auto cup = cylinder_surfaces("cup", r, {"top"});
  EXPECT_EQ(contacts_at(cup, {0.01 - 0.999 * radius, 0, 0.999 * radius}), 2u);
  EXPECT_EQ(contacts_at(cup, {0.003, 0, 0.999 * radius}), 1u);
  EXPECT_EQ(contacts_at(cup, {0, 0.01, 0.02 + 0.999 * radius}), 1u);
  EXPECT_EQ(contacts_at(cup, {0.0107 * std::sqrt(0.5), 0.0107 * std::sqrt(0.5), -0.0006}), 1u)
      << "outer edge of the base";
}

TEST(SphereOverTheSeamOfTwoFaces, HasOneContact) {
  const std::vector<Surface> floor{rectangle_surface("a", {-0.01, -0.01, 0}, {0.01, 0, 0}, {0, 0.02, 0}),
                                   rectangle_surface("b", {0, -0.01, 0}, {0.01, 0, 0}, {0, 0.02, 0})};
  for (const double beside : {0.0, 1e-6, -1e-6, 1e-14})
    EXPECT_EQ(contacts_at(floor, {beside, 0.001, 0.999 * radius}), 1u) << beside;
}

TEST(SphereThatLeavesPastAnEdge, IsSeenToCrossTheFaceItWentThrough) {
  Model m = with_surfaces({rectangle_surface("plate", {-0.01, -0.01, 0}, {0.01, 0, 0}, {0, 0.02, 0})});
  // In one step from above the plate to below it and beyond its edge.
  Simulation s(m, state_of(m, {heavy({-5e-5, 0, 2e-5}, {100, 0, -100})}), 1);
  s.step();
  EXPECT_EQ(s.state().ledger.escaped, 1u);
}

TEST(SphereThatWraps, FindsTheFloorAtTheOtherEnd) {
  // A floor of one plate, of two plates and of triangles, across a periodic axis.
  for (const int kind : {0, 1, 2}) {
    std::vector<Surface> floor;
    if (kind == 0) floor = {rectangle_surface("a", {-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0})};
    if (kind == 1)
      floor = {rectangle_surface("a", {-0.01, -0.01, 0}, {0.01, 0, 0}, {0, 0.02, 0}),
               rectangle_surface("b", {0, -0.01, 0}, {0.01, 0, 0}, {0, 0.02, 0})};
    Model m = with_surfaces(floor);
    m.domain.min.x = -0.01;
    m.domain.max.x = 0.01;
    m.domain.periodic[0] = true;
    pulvis::validation::Draw draw(1, 108);
    if (kind == 2)
      add_mesh(m, random_triangles({-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0}, 8, 8, 0.2, draw));
    Simulation s(m, state_of(m, {heavy({0.0099, 0, 0.999 * radius}, {0.1, 0, 0})}), 1);
    for (int k = 0; k < 2000; ++k) {
      s.step();
      ASSERT_EQ(touching(s.walls()), 1u) << "floor " << kind << ", step " << k;
    }
    EXPECT_LT(s.state().parcels.body[0].position.x, 0.0);
  }
}

TEST(SphereAtTwoBodies, TouchesBoth) {
  Model m = with_surfaces({plane_surface("floor", {0, 0, 0}, {0, 0, 1})});
  m.walls.bodies.push_back({"plate", {}});
  m.walls.surfaces.push_back(plane_surface("plate", {0, 0, 0}, {0, 0, 1}));
  m.walls.surfaces.back().body = 1;
  Simulation s(m, state_of(m, {heavy({0, 0, 0.999 * radius})}), 1);
  s.step();
  EXPECT_EQ(touching(s.walls()), 2u);
}

/// Pushes a sphere across the top of a box and over its edge at a constant height, and calls look(simulation)
/// at each step. The overlap with the top is `overlap`; from the edge on it shrinks.
template <class Look>
void push_over_the_edge(const char* normal, double start, double overlap, int from_axis, Look&& look) {
  const Model m = with_surfaces(box_surfaces("box", unit_box(), {}), normal);
  Vec3 at{0, 0, 0.01 + radius - overlap}, velocity{};
  at[from_axis] = start;
  velocity[from_axis] = start < 0 ? -0.05 : 0.05;
  // It first sinks in, so that also an adhesive contact begins, and then leaves.
  Simulation s(m, state_of(m, {heavy(at, velocity)}), 1);
  for (int k = 0; k < 60000; ++k) {
    s.step();
    if (!look(s)) return;
  }
}

TEST(SphereRollingOverAnEdge, HasOneContactUntilItLeaves) {
  for (const int axis : {0, 1})
    for (const double side : {1.0, -1.0}) {
      const double overlap = 1e-5;
      bool touched = true;
      push_over_the_edge("hertz", side * 0.0095, overlap, axis, [&](const Simulation& s) {
        const Vec3 x = s.state().parcels.body[0].position;
        const double beyond = std::max(std::fabs(x[axis]) - 0.01, 0.0),
                     distance = std::hypot(beyond, x.z - 0.01);
        const bool expected = distance < radius;
        EXPECT_EQ(touching(s.walls()), expected ? 1u : 0u) << "at " << x[axis];
        touched = expected;
        return touched && !::testing::Test::HasFailure();
      });
      EXPECT_FALSE(touched);
    }
}

TEST(SphereRollingOverAnEdge, KeepsItsTangentialSpring) {
  for (const int axis : {0, 1})
    for (const double side : {1.0, -1.0}) {
      const double overlap = 1e-5;
      double spring = 0.0;
      push_over_the_edge("hertz", side * 0.0095, overlap, axis, [&](const Simulation& s) {
        double now = 0.0;
        for (std::size_t k = 0; k < s.walls().slots(); ++k)
          if (s.walls().touching[k]) now = norm(s.walls().history[k].slide);
        const Vec3 x = s.state().parcels.body[0].position;
        const bool near_the_edge = std::fabs(std::fabs(x[axis]) - 0.01) < 1e-5;
        if (near_the_edge && spring > 0.0) {
          EXPECT_NEAR(now, spring, 0.05 * spring) << "at " << x[axis];
        }
        spring = now;
        return std::fabs(x[axis]) < 0.0101 && !::testing::Test::HasFailure();
      });
      EXPECT_GT(spring, 0.0);
    }
}

TEST(StretchedContact, IsCarriedOverAnEdgeAndBreaksByItsLaw) {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  stuff.work_of_adhesion = 0.05;
  const double modulus = material_pair(stuff, stuff).effective_modulus;
  const double stretch = laws::jkr_stretch(radius, modulus, 0.05);
  for (const int axis : {0, 1})
    for (const double side : {1.0, -1.0}) {
      const Model m = with_surfaces(box_surfaces("box", unit_box(), {}), "jkr");
      // It touches the top, is lifted to half the stretch it can bear, and then pushed over the edge.
      Vec3 at{0, 0, 0.01 + radius - 0.1 * stretch}, velocity{};
      at[axis] = side * 0.0095;
      velocity.z = 0.01;
      Simulation s(m, state_of(m, {heavy(at, velocity)}), 1);
      while (s.state().parcels.body[0].position.z < 0.01 + radius + 0.5 * stretch) s.step();
      ASSERT_EQ(touching(s.walls()), 1u);
      velocity = {};
      velocity[axis] = side * 0.05;
      s.state().parcels.body[0].velocity = velocity;
      for (int k = 0; k < 60000; ++k) {
        s.step();
        const Vec3 x = s.state().parcels.body[0].position;
        const double beyond = std::max(std::fabs(x[axis]) - 0.01, 0.0),
                     distance = std::hypot(beyond, x.z - 0.01);
        if (std::fabs(distance - radius - stretch) < 1e-9 * radius) continue;
        const bool expected = distance - radius < stretch;
        ASSERT_EQ(touching(s.walls()), expected ? 1u : 0u)
            << "gap " << (distance - radius) / stretch << " delta_c";
        if (!expected) break;
      }
    }
}

TEST(RestingSphere, PressesOnTheSurfaceItLiesOnAlone) {
  const auto box = box_surfaces("box", unit_box(), {});
  // Near the edge of the top the side face is within reach too, but its nearest point belongs to the top.
  const Vec3 near_edge{0.01 - 0.1 * radius, 0, 0.01 + 0.999 * radius}, middle{0, 0, 0.01 + 0.999 * radius};
  EXPECT_EQ(contacts_at(box, near_edge), 1u);
  EXPECT_NEAR(norm(force_at(box, near_edge) - force_at(box, middle)), 0.0,
              1e-9 * norm(force_at(box, middle)));
}

}  // namespace
