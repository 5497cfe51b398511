// SPDX-License-Identifier: Apache-2.0
// Head-on Hertz impacts at dt = t_c/1000: peak, depth, duration, restitution.
#include <gtest/gtest.h>

#include "validation/collisions.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

Collision elastic(double modulus, double poisson, double density, double radius, double speed, bool at_wall) {
  Collision c;
  c.material = on_rigid_plane(modulus, poisson, 1.0, 0.0);
  if (!at_wall) {
    c.material.effective_modulus *= 0.5;
    c.material.effective_shear_modulus *= 0.5;
  }
  c.parts.rolling = "none";
  c.radius = radius;
  c.density = density;
  c.speed = speed;
  c.at_wall = at_wall;
  c.dt = c.contact_time() / 1000.0;
  return c;
}

TEST(ElasticImpact, HasThePeakDepthAndDurationOfHertz) {
  // delta_max = (15 m* v^2/(16 E* sqrt(R*)))^(2/5), F_max = 4/3 E* sqrt(R*) delta_max^(3/2),
  // t_c = 2.9432 delta_max/v; tests 1 to 3 of Chung and Ooi, Granul. Matter 13 (2011) 643.
  struct Printed {
    Collision collision;
    double force, overlap, duration;
  };
  double worst = 0.0;
  for (const Printed& p :
       {Printed{elastic(4.8e10, 0.20, 2800, 0.01, 20.0, false), 10696.9, 274.1e-6, 40.34e-6},
        Printed{elastic(2.0e10, 0.25, 2500, 0.01, 20.0, false), 7108.24, 368.3e-6, 54.20e-6},
        Printed{elastic(7.0e10, 0.30, 2699, 0.1, 0.2, true), 11369.9, 49.72e-6, 731.7e-6},
        Printed{elastic(4.0e10, 0.35, 1800, 0.1, 0.2, true), 7232.7, 52.12e-6, 767.1e-6},
        Printed{elastic(3.8e11, 0.23, 4000, 0.0025, 3.9, true), 615.35, 8.089e-6, 6.105e-6},
        Printed{elastic(1.0e11, 0.25, 7000, 0.0025, 3.9, true), 506.76, 17.19e-6, 12.97e-6}})
    for (const double phase : {0.01, 0.3, 0.7, 0.99}) {
      Collision c = p.collision;
      c.phase = phase;
      const Outcome o = collide(c);
      ASSERT_TRUE(o.separated);
      const double overlap =
          std::pow(15.0 * c.reduced_mass() * c.speed * c.speed /
                       (16.0 * c.material.effective_modulus * std::sqrt(c.reduced_radius())),
                   0.4);
      const double force =
          4.0 / 3.0 * c.material.effective_modulus * std::sqrt(c.reduced_radius()) * std::pow(overlap, 1.5);
      EXPECT_NEAR(o.largest_force / p.force, 1.0, 1e-3);
      EXPECT_NEAR(o.largest_overlap / p.overlap, 1.0, 1e-3);
      EXPECT_NEAR(o.duration / p.duration, 1.0, 1e-3);
      EXPECT_NEAR(o.speed / c.speed, 1.0, 1e-4);
      for (const double ratio :
           {o.largest_force / force, o.largest_overlap / overlap, o.duration / (2.94327 * overlap / c.speed)})
        worst = std::max(worst, std::fabs(ratio - 1.0));
    }
  EXPECT_LT(worst, 1e-3);
  RecordProperty("worst_e6", std::to_string(1e6 * worst));
}

TEST(DampedImpact, ShowsTheRestitutionAskedForBetweenSpheresAndAtWalls) {
  double worst = 0.0, worst_e = 0.0;
  for (const bool at_wall : {false, true})
    for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95})
      for (const double speed : {0.01, 0.5, 5.0}) {
        Collision c = elastic(1e8, 0.3, 2500, 1e-3, speed, at_wall);
        c.material.restitution = e;
        for (const double phase : {0.1, 0.6}) {
          c.phase = phase;
          const Outcome o = collide(c);
          ASSERT_TRUE(o.separated) << e;
          const double error = std::fabs(o.speed / speed / e - 1.0);
          EXPECT_LT(error, 1e-2) << "e = " << e << " at " << speed << " m/s, wall " << at_wall;
          if (error > worst) worst = error, worst_e = e;
        }
      }
  RecordProperty("worst_e6", std::to_string(1e6 * worst));
  RecordProperty("worst_at_restitution", std::to_string(worst_e));
}

TEST(DampedImpact, IsTheSameForAPairAndForAWallWithTheSameReducedMassAndRadius) {
  Collision wall = elastic(1e8, 0.3, 2500, 1e-3, 0.5, true);
  wall.material.restitution = 0.6;
  Collision pair = wall;
  pair.at_wall = false;
  pair.radius = 2e-3;                 // R* = 1 mm
  pair.density = 2500.0 * 2.0 / 8.0;  // m* = mass of the one at the wall
  const Outcome a = collide(wall), b = collide(pair);
  EXPECT_NEAR(a.largest_force / b.largest_force, 1.0, 1e-9);
  EXPECT_NEAR(a.speed / b.speed, 1.0, 1e-9);
  EXPECT_NEAR(a.duration / b.duration, 1.0, 1e-9);
}

}  // namespace
