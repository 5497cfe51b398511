// SPDX-License-Identifier: Apache-2.0
// Parcels that leave, numbers that are none, and the ledger.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "engine/base/failure.hpp"
#include "tests/engine/sticky_scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

Model soft_box(double dt = 1e-5) {
  Stuff stuff;
  stuff.young_modulus = 1e5;
  Model m = one_material(stuff, {}, {0, 0, 0}, {0.1, 0.1, 0.1}, dt, 1e-3, 2e-3);
  m.body_force.gravity = {};
  return m;
}

void expect_balanced(const State& s) {
  EXPECT_EQ(s.ledger.inserted, s.parcels.size() + s.ledger.removed + s.ledger.escaped);
  double present = 0.0;
  for (const Parcel& p : s.parcels.body) present += p.mass;
  EXPECT_NEAR(s.ledger.inserted_mass, present + s.ledger.removed_mass + s.ledger.escaped_mass,
              1e-13 * s.ledger.inserted_mass);
  EXPECT_EQ(s.ledger.escaped, s.escapes.size());
}

TEST(EscapeFromTheDomain, IsCountedWithIdTimePlaceAndSpeed) {
  const Model m = soft_box();
  Simulation s(m,
               state_of(m, {parcel(4, {0.0995, 0.05, 0.05}, 1e-3, 2500.0, {5, 0, 0}),
                            parcel(9, {0.05, 0.05, 0.05}, 1e-3, 2500.0)}),
               1);
  for (int k = 0; k < 20; ++k) s.step();
  ASSERT_EQ(s.state().escapes.size(), 1u);
  const Escape& e = s.state().escapes[0];
  EXPECT_EQ(e.id, 4u);
  EXPECT_EQ(e.through, "domain");
  // 0.5 mm at 5 m/s and 50 um a step: on the rim after ten steps, outside after eleven at the latest.
  EXPECT_NEAR(e.time, 1.05e-4, 0.06e-4);
  EXPECT_GT(e.position.x, 0.1);
  EXPECT_EQ(e.velocity, (Vec3{5, 0, 0}));
  ASSERT_EQ(s.state().parcels.size(), 1u);
  EXPECT_EQ(s.state().parcels.body[0].id, 9u);
  expect_balanced(s.state());
}

TEST(EscapeFromTheDomain, DoesNotHappenAcrossAPeriodicBoundary) {
  Model m = soft_box();
  m.domain.periodic[0] = m.domain.periodic[1] = m.domain.periodic[2] = true;
  Simulation s(m, state_of(m, {parcel(4, {0.0995, 0.05, 0.0003}, 1e-3, 2500.0, {5, 0, -3})}), 1);
  for (int k = 0; k < 2000; ++k) s.step();
  ASSERT_EQ(s.state().parcels.size(), 1u);
  const Vec3 x = s.state().parcels.body[0].position;
  EXPECT_NEAR(x.x, 0.0995, 1e-12);  // once around
  EXPECT_NEAR(x.z, 0.0403, 1e-12);
  expect_balanced(s.state());
}

TEST(EscapeThroughAWall, IsCountedWithTheWallsName) {
  // So soft and fast that the contact cannot stop it; still far below half a radius a step.
  Model m = soft_box();
  Stuff jelly;
  jelly.young_modulus = 1e3;
  m.classes = ContactClasses(1);
  m.classes.set(0, 0, contact_class(material_pair(jelly, jelly), {}));
  Region box;
  box.min = {0.02, 0.02, 0.02};
  box.max = {0.08, 0.08, 0.08};
  for (Surface& surface : box_surfaces("die", box, {})) add_wall(m, surface);
  m.motions.clear();
  Simulation s(m,
               state_of(m, {parcel(0, {0.05, 0.05, 0.05}, 1e-3, 2500.0, {0, -10, 0}),
                            parcel(1, {0.05, 0.06, 0.05}, 1e-3, 2500.0)}),
               1);
  for (int k = 0; k < 1000 && s.state().escapes.empty(); ++k) s.step();
  ASSERT_EQ(s.state().escapes.size(), 1u);
  const Escape& e = s.state().escapes[0];
  EXPECT_EQ(e.id, 0u);
  EXPECT_EQ(e.through, "die.-y");
  EXPECT_LT(e.position.y, 0.02);
  EXPECT_GT(e.position.y, 0.02 - 10 * m.dt) << "noticed in the step it happens";
  EXPECT_NEAR(e.time, s.time(), 1e-15);
  expect_balanced(s.state());
  for (int k = 0; k < 100; ++k) s.step();
  EXPECT_EQ(s.state().parcels.size(), 1u);
}

TEST(EscapeThroughAWall, IsNotClaimedForParcelsThatAreOutsideFromTheStart) {
  Model m = soft_box();
  Region box;
  box.min = {0.02, 0.02, 0.02};
  box.max = {0.08, 0.08, 0.08};
  for (Surface& surface : box_surfaces("die", box, {})) add_wall(m, surface);
  // One passes by outside, one bounces off the outside, one passes through the plane of a face beside it.
  Simulation s(m,
               state_of(m, {parcel(0, {0.018, 0.01, 0.05}, 1e-3, 2500.0, {0, 5, 0}),
                            parcel(1, {0.01, 0.05, 0.05}, 1e-3, 2500.0, {0.5, 0, 0}),
                            parcel(2, {0.0185, 0.06, 0.01}, 1e-3, 2500.0, {0, 0, 5})}),
               1);
  for (int k = 0; k < 1500; ++k) s.step();
  EXPECT_EQ(s.state().ledger.escaped, 0u);
  EXPECT_EQ(s.state().parcels.size(), 3u);
}

TEST(EscapeThroughAWall, LeavesTheForcesOnOtherWallsAsTheyWere) {
  // A bed rests on the floor while one parcel is shot through a plate above it.
  Model m = soft_box(2e-5);
  m.body_force.gravity = {0, 0, -9.81};
  add_wall(m, plane_surface("floor", {0, 0, 0.01}, {0, 0, 1}));
  Region plate;
  plate.min = {0.06, 0.06, 0.06};
  plate.max = {0.09, 0.09, 0.06001};
  for (Surface& surface : box_surfaces("plate", plate, {"-x", "+x", "-y", "+y", "+z"})) add_wall(m, surface);
  const double weight = 9.81 * 2500.0 * sphere_volume(2e-3);
  const double rest = laws::hertz_overlap_under(weight, 2e-3, laws::effective_modulus(1e5, 0.3, 1e5, 0.3));
  Simulation s(m,
               state_of(m, {parcel(0, {0.03, 0.03, 0.012 - rest}, 2e-3, 2500.0),
                            parcel(1, {0.07, 0.07, 0.05}, 1e-3, 2500.0, {0, 0, 20})}),
               1);
  s.step();
  const double before = s.force_on_surface(0).z;
  EXPECT_NEAR(before, -weight, 0.05 * weight);
  for (int k = 0; k < 100; ++k) {
    s.step();
    ASSERT_NEAR(s.force_on_surface(0).z, -weight, 0.05 * weight) << "at step " << s.state().step;
  }
  EXPECT_EQ(s.state().ledger.escaped, 1u);
}

TEST(Ledger, BalancesWhileARainFallsThroughAHole) {
  Model m = sticky_model();
  m.walls.surfaces.clear();
  m.walls.bodies.clear();
  m.motions.clear();
  Simulation s(m, state_of(m, sticky_parcels()), 2);
  s.open_source(0);
  for (int k = 0; k < 4000; ++k) {
    s.step();
    if (k % 50 == 0) expect_balanced(s.state());
  }
  EXPECT_EQ(s.state().ledger.inserted, 600u);
  EXPECT_GT(s.state().ledger.escaped, 450u);
  expect_balanced(s.state());
}

/// Steps until a Failure comes; returns its message.
std::string message_of_failure(Simulation& s, int steps) {
  try {
    for (int k = 0; k < steps; ++k) s.step();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::physics);
    return failure.what();
  }
  return "no failure";
}

TEST(NotANumber, IsNoticedAtOnceAndTheParcelNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity})
    for (int what = 0; what < 5; ++what) {
      Simulation s = sticky_start(2);
      go(s, 10);
      auto& parcels = s.state().parcels;
      Parcel& p = parcels.body[217];
      (what == 0   ? p.position.y
       : what == 1 ? p.velocity.x
       : what == 2 ? p.spin.z
       : what == 3 ? parcels.load[217].force.z
                   : parcels.load[217].torque.x) = bad;
      const std::string name = fmt::format("parcel {} ", p.id);
      EXPECT_NE(message_of_failure(s, 1).find(name), std::string::npos)
          << "field " << what << " was " << bad << ": " << message_of_failure(s, 1);
    }
}

TEST(TooFast, IsNoticedAndTheParcelNamed) {
  Simulation s = sticky_start(2);
  go(s, 10);
  Parcel& p = s.state().parcels.body[100];
  p.velocity = {0, 0, 0.51 * p.radius / s.model().dt};
  const std::string name = fmt::format("parcel {} ", p.id), message = message_of_failure(s, 1);
  EXPECT_NE(message.find(name), std::string::npos) << message;
  EXPECT_NE(message.find("half its radius"), std::string::npos) << message;
}

}  // namespace
