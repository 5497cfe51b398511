// SPDX-License-Identifier: Apache-2.0
#include "single_contact/collision.hpp"

#include <gtest/gtest.h>

#include "single_contact/adhesion.hpp"
#include "tests/single_contact/sample_contacts.hpp"
#include "validation/collisions.hpp"

using namespace pulvis;
using namespace pulvis::testing;
using namespace pulvis::single_contact;

namespace {

TEST(Collision, WithoutCohesionGivesTheRestitutionAskedFor) {
  for (const char* normal : {"hertz", "hooke"})
    for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0})
      for (const double speed : {0.001, 0.05, 1.0}) {
        laws::MaterialPair m = sample_material();
        m.restitution = e;
        const Collision c = collide(contact_of(normal, "none", m), speed);
        EXPECT_FALSE(c.sticks);
        EXPECT_NEAR(c.restitution, e, 0.005 * e) << normal << " " << speed;
      }
}

TEST(Collision, OfElasticHertzHasItsOverlapAndDuration) {
  const Collision c = collide(contact_of("hertz").undamped(), 0.05);
  const double overlap = laws::hertz_largest_overlap(reduced_mass, reduced_radius, effective, 0.05);
  EXPECT_NEAR(c.largest_overlap, overlap, 1e-5 * overlap);
  const double time = laws::hertz_contact_time(reduced_mass, reduced_radius, effective, 0.05);
  EXPECT_NEAR(c.duration, time, 2e-3 * time) << "ends within a step after separation";
}

TEST(Collision, WithoutDampingLosesTheWorkOfATouchUnderEveryLaw) {
  for (const auto& [name, damped] : all_contacts()) {
    const Contact contact = damped.undamped();
    if (contact.remembers()) continue;
    const double lost = adhesion(contact).lost_work;
    for (const double speed : {0.02, 0.05, 0.3}) {
      const Collision c = collide(contact, speed);
      const double rest = 1.0 - lost / (0.5 * contact.mass() * speed * speed);
      ASSERT_FALSE(c.is_crushed) << name;
      EXPECT_EQ(c.sticks, rest <= 0.0) << name << " at " << speed;
      EXPECT_NEAR(c.restitution, std::sqrt(std::max(rest, 0.0)), 2e-3) << name << " at " << speed;
    }
  }
}

TEST(Collision, OfLawsThatYieldLosesTheAreaBetweenTheBranches) {
  for (const char* normal : {"luding", "edinburgh"}) {
    const Contact contact = contact_of(normal).undamped();
    const Collision c = collide(contact, 0.05);
    const Adhesion a = adhesion(contact, contact.pressing(c.largest_overlap));
    const double kinetic = 0.5 * contact.mass() * 0.05 * 0.05;
    EXPECT_NEAR(c.restitution, std::sqrt(1.0 - a.lost_work / kinetic), 2e-3) << normal;
  }
}

// Two molybdenum spheres of 4.6 um at 0.05 m/s, e = 0.5, E = 1e7 Pa, integrated independently.
TEST(Collision, UnderJkrAndSjkr2ShowsTheReferenceValues) {
  const Collision jkr = collide(contact_of("jkr"), 0.05);
  EXPECT_NEAR(jkr.restitution, 0.4698, 0.001 * 0.4698);
  EXPECT_NEAR(jkr.largest_overlap / radius, 0.008920, 0.0005 * 0.008920);
  EXPECT_NEAR(jkr.duration, 1.753e-6, 0.002 * 1.753e-6);
  laws::Choices on_contact_radius;
  on_contact_radius.damping_on_jkr_radius = true;
  EXPECT_NEAR(collide(contact_of("jkr", "none", sample_material(), on_contact_radius), 0.05).restitution,
              0.385, 5e-4);
  for (const auto& [density, e] : {std::pair{1e4, 0.4831}, {2e4, 0.4645}, {1e5, 0.1962}}) {
    laws::MaterialPair m = sample_material();
    m.cohesion_energy_density = density;
    EXPECT_NEAR(collide(contact_of("hertz", "sjkr2_reduced_radius", m), 0.05).restitution, e, 0.0025 * e)
        << density;
  }
}

TEST(Collision, AtAFixedStepTendsToThatOfShortSteps) {
  for (const char* normal : {"hertz", "jkr", "hooke", "luding"}) {
    const Contact contact = contact_of(normal);
    const Collision fine = collide(contact, 0.05);
    const auto miss = [&](double steps) {
      return std::abs(collide(contact, 0.05, fine.duration / steps).restitution - fine.restitution);
    };
    EXPECT_LT(miss(10000), 2e-3) << normal;
    EXPECT_LT(miss(10000), 0.5 * miss(20)) << normal;
  }
}

TEST(Collision, AtAFixedStepIsThatOfTheEngine) {
  const double dt = 3e-8;
  for (const char* normal : {"hertz", "jkr", "hooke", "luding", "edinburgh"})
    for (const char* cohesion : {"none", "dmt", "sjkr", "capillary_willett"}) {
      if (std::string(cohesion) != "none" && std::string(normal) != "hertz") continue;
      for (const bool at_wall : {false, true}) {
        scenes::LawParts parts;
        parts.normal = normal, parts.cohesion = cohesion;
        scenes::Collision scene{sample_material(), parts, radius, density, 0.06};
        scene.at_wall = at_wall;
        scene.dt = dt;
        const scenes::Outcome engine = scenes::collide(scene, 2000);
        const Collision alone = collide(
            contact_of(normal, cohesion, sample_material(), {}, at_wall ? grain_at_wall : grains), 0.06, dt);
        EXPECT_EQ(alone.sticks, !engine.separated) << normal << " " << cohesion << at_wall;
        EXPECT_NEAR(alone.largest_overlap, engine.largest_overlap, 1e-8 * engine.largest_overlap)
            << normal << " " << cohesion << at_wall;
        if (engine.separated) {
          EXPECT_NEAR(alone.restitution, engine.speed / 0.06, 1e-7) << normal << " " << cohesion << at_wall;
        }
      }
    }
}

// Few steps cannot follow a well that is much narrower than the way of one: energy comes out of nothing, or goes.
TEST(Collision, AtACoarseStepMissesAWellThatIsNarrow) {
  const Contact contact = contact_of("hertz", "hamaker").undamped();
  const Collision fine = collide(contact, 0.02), coarse = collide(contact, 0.02, fine.duration / 50);
  EXPECT_NEAR(fine.restitution, 1.0, 2e-3);
  EXPECT_GT(std::abs(coarse.restitution - 1.0), 0.01);
}

TEST(StickingSpeed, OfElasticJkrIsThatOfTheClosedForm) {
  const Contact contact = contact_of("jkr").undamped();
  const double expected = laws::jkr_sticking_speed(reduced_mass, reduced_radius, effective, work);
  const double speed = sticking_speeds(contact, 1.0).highest;
  EXPECT_NEAR(speed, expected, 1e-5 * expected);
  EXPECT_TRUE(collide(contact, 0.999 * speed).sticks) << "and collisions agree";
  EXPECT_FALSE(collide(contact, 1.001 * speed).sticks);
}

TEST(StickingSpeed, SeparatesCollisionsThatStickFromThoseThatDoNotUnderEveryLaw) {
  for (const auto& [name, contact] : all_contacts()) {
    const double reference = std::sqrt(2.0 * adhesion(contact, 5e-9).separation_work / contact.mass());
    const auto [lowest, speed] = sticking_speeds(contact, reference);
    EXPECT_EQ(speed > 0.0, reference > 0.0) << name;
    if (speed == 0.0) continue;
    if (std::isinf(speed)) {  // of the laws that yield, which may stick at any speed
      EXPECT_TRUE(contact.remembers()) << name;
      EXPECT_TRUE(collide(contact, 4096.0 * reference).sticks) << name;
      continue;
    }
    EXPECT_TRUE(collide(contact, 0.999 * speed).sticks) << name << " at " << speed;
    EXPECT_FALSE(collide(contact, 1.001 * speed).sticks) << name << " at " << speed;
    EXPECT_TRUE(lowest == 0.0 || contact.remembers()) << name;
  }
}

TEST(StickingSpeed, OfLudingHasALowerEndSinceSoftTouchesHardlyYield) {
  const Contact contact = contact_of("luding");
  const auto [lowest, highest] = sticking_speeds(contact, 0.05);
  ASSERT_GT(lowest, 0.0);
  ASSERT_GT(highest, lowest);
  EXPECT_FALSE(collide(contact, 0.999 * lowest).sticks);
  EXPECT_TRUE(collide(contact, 1.001 * lowest).sticks);
  EXPECT_TRUE(collide(contact, 0.999 * highest).sticks);
  EXPECT_FALSE(collide(contact, 1.001 * highest).sticks);
}

TEST(StickingSpeed, IsHigherWithDampingAndNoneWithoutAttraction) {
  const Contact dmt = contact_of("hertz", "dmt");
  const auto highest = [](const Contact& contact) { return sticking_speeds(contact, 0.01).highest; };
  EXPECT_EQ(highest(dmt.undamped()), 0.0);
  EXPECT_GT(highest(dmt), 0.0);
  EXPECT_GT(highest(contact_of("jkr")), highest(contact_of("jkr").undamped()));
  EXPECT_EQ(highest(contact_of("hertz")), 0.0);
}

TEST(Collision, ThatDrawsTheBodiesIntoEachOtherSaysSo) {
  laws::MaterialPair m = sample_material();
  m.normal_stiffness = 1.0;
  m.cohesion_energy_density = 1.01 / (2.0 * M_PI * reduced_radius);
  EXPECT_TRUE(collide(contact_of("hooke", "sjkr2_reduced_radius", m), 0.05).is_crushed);
}

}  // namespace
