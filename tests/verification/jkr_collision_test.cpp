// SPDX-License-Identifier: Apache-2.0
// Adhesive collisions and separation, at steps of at most a hundredth of the stretch at rupture.
#include <gtest/gtest.h>

#include "validation/collisions.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

/// Two molybdenum parcels of alpha x 4.6 um, softened to 10 MPa; W grows with alpha so that stresses are
/// similar.
Collision molybdenum(double alpha, double speed, const char* damping) {
  Collision c;
  c.material = on_rigid_plane(1e7, 0.3, 0.5, 0.0);
  c.material.effective_modulus *= 0.5;
  c.material.effective_shear_modulus *= 0.5;
  c.material.work_of_adhesion = 2e-4 * alpha;
  c.parts = {"jkr", damping, "none", "none", {}};
  c.radius = 2.3e-6 * alpha;
  c.density = 10200;
  c.speed = speed;
  const double stretch =
      laws::jkr_stretch(c.reduced_radius(), c.material.effective_modulus, c.material.work_of_adhesion);
  c.dt = 0.01 * stretch / speed;
  return c;
}

TEST(AdhesiveCollision, OfCoarseGrainedMolybdenumIsThatOfTheGrains) {
  // delta_max/R = 0.008920, e_out = 0.4698, t_c = 1.753 us alpha, for any alpha (integrated independently);
  // the damping from the Hertz stiffness at the same overlap, none at negative overlap.
  for (const double alpha : {1.0, 10.0, 50.0})
    for (const double phase : {0.2, 0.7}) {
      Collision c = molybdenum(alpha, 0.05, "restitution");
      c.phase = phase;
      const Outcome o = collide(c);
      ASSERT_TRUE(o.separated);
      EXPECT_NEAR(o.largest_overlap / c.radius / 0.008920, 1.0, 1e-2) << alpha;
      EXPECT_NEAR(o.speed / c.speed / 0.4698, 1.0, 1e-2) << alpha;
      EXPECT_NEAR(o.duration / (1.753e-6 * alpha), 1.0, 1e-2) << alpha;
      if (phase == 0.2) {
        RecordProperty("overlap_" + std::to_string(static_cast<int>(alpha)),
                       std::to_string(o.largest_overlap / c.radius));
        RecordProperty("restitution_" + std::to_string(static_cast<int>(alpha)),
                       std::to_string(o.speed / c.speed));
      }
    }
}

TEST(AdhesiveCollision, WithDampingOnTheJkrRadiusLosesMore) {
  // S_n = 2 E* a down to rupture: e_out = 0.385, delta_max/R = 0.008623 (same source).
  Collision c = molybdenum(1.0, 0.05, "restitution");
  c.parts.choices.damping_on_jkr_radius = true;
  const Outcome o = collide(c);
  ASSERT_TRUE(o.separated);
  EXPECT_NEAR(o.speed / c.speed / 0.385, 1.0, 1e-2);
  EXPECT_NEAR(o.largest_overlap / c.radius / 0.008623, 1.0, 1e-2);
}

TEST(AdhesiveCollision, WithoutAdhesionIsHertz) {
  // delta_max/R = 0.008716, t_c = 1.638 us alpha, e_out = 0.5.
  for (const double alpha : {1.0, 100.0}) {
    Collision c = molybdenum(alpha, 0.05, "restitution");
    c.parts.normal = "hertz";
    const Outcome o = collide(c);
    EXPECT_NEAR(o.largest_overlap / c.radius / 0.008716, 1.0, 1e-3);
    EXPECT_NEAR(o.speed / c.speed, 0.5, 5e-4);
    EXPECT_NEAR(o.duration / (1.638e-6 * alpha), 1.0, 1e-3);
  }
}

TEST(PullOff, OfASphereLiftedSlowlyOffAWallTakesThreeHalvesPiWTimesR) {
  Stuff stuff;
  stuff.young_modulus = 5e6;
  stuff.work_of_adhesion = 0.05;
  const double radius = 1e-3, modulus = material_pair(stuff, stuff).effective_modulus;
  const double stretch = laws::jkr_stretch(radius, modulus, 0.05),
               pull_off = laws::jkr_pull_off(radius, 0.05);
  Model m = one_material(stuff, {"jkr", "none", "total_spring", "elastic_plastic", {}}, {-0.1, -0.1, -0.1},
                         {0.1, 0.1, 0.1}, 1e-5, radius, radius);
  m.body_force.gravity = {};
  add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
  // Too heavy for the force to change its speed: the position is prescribed.
  const double speed = stretch / 2000.0 / m.dt;
  Simulation s(m, state_of(m, {parcel(0, {0, 0, radius - 0.5 * stretch}, radius, 1e15, {0, 0, speed})}), 1);
  double largest = 0.0, last = 0.0;
  std::uint64_t steps = 0;
  for (; steps < 10000; ++steps) {
    s.step();
    if (!s.walls().touching[0]) break;
    last = s.force_on_surface(0).z;
    largest = std::max(largest, last);
  }
  EXPECT_NEAR(largest / pull_off, 1.0, 1e-4);
  EXPECT_NEAR(static_cast<double>(steps), 3000.0, 2.0)
      << "from half the stretch inside to the whole stretch outside";
  EXPECT_NEAR(last / pull_off, 5.0 / 9.0, 0.02) << "the last force before rupture";
  RecordProperty("error_e9", std::to_string(1e9 * (largest / pull_off - 1.0)));
}

}  // namespace
