// SPDX-License-Identifier: Apache-2.0
// What a law makes of parcels alpha times larger than the grains they stand for.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "engine/laws/catalogue.hpp"
#include "validation/references/law.hpp"
#include "validation/references/law_list.hpp"

using namespace pulvis;
using namespace pulvis::validation;
using laws::Similarity;

namespace {

constexpr double alpha = 50.0;

/// A touch of parcels that corresponds to one of grains: lengths and times with alpha, masses with alpha^3.
laws::Touch for_parcels(laws::Touch t) {
  t.overlap *= alpha, t.radius *= alpha, t.radius_first *= alpha, t.radius_second *= alpha;
  t.mass *= std::pow(alpha, 3), t.mass_first *= std::pow(alpha, 3), t.mass_second *= std::pow(alpha, 3);
  t.spin = t.spin / alpha;
  t.shared_spin /= alpha;
  t.dt *= alpha;
  return t;
}

/// Largest difference of the dimensionless forces and torques over a few steps that press, slide, roll and twist.
double difference(const laws::Law& law, const RandomState& s) {
  const auto of_grains = law.mix(s.material, {}),
             of_parcels = law.mix(law.for_parcels(s.material, alpha, Similarity::stress), {});
  laws::Past grain{}, parcel{};
  double worst = 0.0;
  laws::Touch t = s.touch;
  for (int step = 0; step < 8; ++step) {
    const laws::Response a = law.evaluate(t, grain, of_grains),
                         b = law.evaluate(for_parcels(t), parcel, of_parcels);
    const double force = norm(a.force), torque = norm(a.roll_torque);
    if (a.touching != b.touching) return HUGE_VAL;
    if (force > 0.0) worst = std::fmax(worst, norm(b.force / (alpha * alpha) - a.force) / force);
    if (torque > 1e-9 * force * t.radius)  // else what rounding leaves of a limit of zero

      worst = std::fmax(worst, norm(b.roll_torque / std::pow(alpha, 3) - a.roll_torque) / torque);
    grain = a.history, parcel = b.history;
    t.was_touching = a.touching;
    t.overlap *= step < 4 ? 1.3 : 0.6;  // forwards and back
  }
  return worst;
}

TEST(Similarity, OfStressKeepsTheDimensionlessForcesAndTorquesOfEveryLaw) {
  for (const laws::Law& law : laws_to_test())
    for (std::uint64_t k = 0; k < 50; ++k)
      EXPECT_LT(difference(law, random_state(law, k)), 1e-7) << name_of(law) << k;
}

TEST(Similarity, ScalesEachNumberByTheRuleBesideIt) {
  laws::MaterialPair m;
  m.work_of_adhesion = m.surface_tension = m.liquid_viscosity = m.hamaker_constant = m.shortest_gap =
      m.longest_gap = m.normal_stiffness = m.characteristic_speed = m.cohesion_energy_density =
          m.liquid_content = m.contact_angle = m.effective_modulus = m.friction = 1.0;
  m.constant_pull = -1.0;
  const auto parcels = [&](const char* normal, const char* cohesion, Similarity similarity) {
    return laws::find_law(normal, "restitution", "total_spring", "none", cohesion)
        .for_parcels(m, 8.0, similarity);
  };
  EXPECT_EQ(parcels("jkr", "none", Similarity::stress).work_of_adhesion, 8.0);
  EXPECT_EQ(parcels("jkr", "none", Similarity::bond).work_of_adhesion, 64.0);
  EXPECT_EQ(parcels("jkr", "none", Similarity::none).work_of_adhesion, 1.0);
  EXPECT_EQ(parcels("jkr", "none", Similarity::stress).effective_modulus, 1.0);
  EXPECT_EQ(parcels("jkr", "none", Similarity::bond).friction, 1.0);
  EXPECT_EQ(parcels("hertz", "dmt", Similarity::bond).work_of_adhesion, 64.0);
  EXPECT_EQ(parcels("edinburgh", "none", Similarity::stress).constant_pull, -64.0);
  EXPECT_EQ(parcels("edinburgh", "none", Similarity::bond).constant_pull, -512.0);
  EXPECT_EQ(parcels("edinburgh", "none", Similarity::bond).work_of_adhesion, 64.0);
  EXPECT_EQ(parcels("hooke", "none", Similarity::stress).normal_stiffness, 8.0);
  EXPECT_EQ(parcels("hooke", "none", Similarity::bond).normal_stiffness, 8.0);
  EXPECT_EQ(parcels("hooke", "none", Similarity::none).normal_stiffness, 1.0);
  EXPECT_EQ(parcels("hooke", "none", Similarity::stress).characteristic_speed, 1.0);
  EXPECT_EQ(parcels("hertz", "sjkr", Similarity::stress).cohesion_energy_density, 1.0);
  EXPECT_NEAR(parcels("hertz", "sjkr", Similarity::bond).cohesion_energy_density, 2.0, 1e-14);
  EXPECT_EQ(parcels("hertz", "capillary_willett", Similarity::stress).surface_tension, 8.0);
  EXPECT_EQ(parcels("hertz", "capillary_willett", Similarity::bond).surface_tension, 64.0);
  EXPECT_EQ(parcels("hertz", "capillary_willett", Similarity::bond).liquid_viscosity, 8.0);
  EXPECT_EQ(parcels("hertz", "capillary_willett", Similarity::bond).liquid_content, 1.0);
  EXPECT_EQ(parcels("hertz", "hamaker", Similarity::stress).hamaker_constant, 512.0);
  EXPECT_EQ(parcels("hertz", "hamaker", Similarity::bond).hamaker_constant, 4096.0);
  EXPECT_EQ(parcels("hertz", "hamaker", Similarity::bond).shortest_gap, 8.0);
  EXPECT_EQ(parcels("hertz", "hamaker", Similarity::stress).longest_gap, 8.0);
}

TEST(Similarity, OfBondIsKnownToEveryLawButThoseWhosePullOffIsNoPowerOfANumber) {
  std::set<std::string> without;
  for (const auto& normal : laws::catalogue().normal)
    for (const auto& cohesion : laws::catalogue().cohesion) {
      const laws::Law law = laws::find_law(normal.name, "restitution", "total_spring", "none", cohesion.name);
      if (normal.adhesive && cohesion.acts) continue;  // such a law is refused
      EXPECT_EQ(law.why_not(Similarity::stress), "");
      EXPECT_EQ(law.why_not(Similarity::none), "");
      if (!law.why_not(Similarity::bond).empty())
        without.insert(std::string(normal.name) + " " + std::string(cohesion.name));
    }
  EXPECT_EQ(without, (std::set<std::string>{"luding none", "hooke sjkr", "hooke sjkr2_reduced_radius",
                                            "hooke sjkr2_twice_reduced_radius"}));
}

// One that it uses without naming it would have no rule.
TEST(Similarity, FindsEveryNumberWithAUnitOfLengthNamedByTheLawThatUsesIt) {
  double laws::MaterialPair::*const fields[] = {
      &laws::MaterialPair::work_of_adhesion,       &laws::MaterialPair::normal_stiffness,
      &laws::MaterialPair::constant_pull,          &laws::MaterialPair::surface_tension,
      &laws::MaterialPair::liquid_viscosity,       &laws::MaterialPair::hamaker_constant,
      &laws::MaterialPair::shortest_gap,           &laws::MaterialPair::longest_gap,
      &laws::MaterialPair::cohesion_energy_density};
  for (const laws::Law& law : laws_to_test())
    for (const auto field : fields) {
      bool named = false;
      for (const laws::PartEntry* part : law.parts())
        for (const laws::Parameter& p : part->parameters) named = named || p.value == field;
      if (named) continue;
      for (const laws::Choices& choices : choices_to_test) {
        laws::MaterialPair changed = random_state(law, 1).material;
        const auto before = law.mix(changed, choices);
        changed.*field = 3.0 * changed.*field + 1.0;
        EXPECT_EQ(law.mix(changed, choices), before) << name_of(law);
      }
    }
}

}  // namespace
