// SPDX-License-Identifier: Apache-2.0
// Laws that pull across a gap, through the whole engine: the near lists must know of them in time, before the bodies
// touch and after they parted, also when the lists are rebuilt on the way.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/scene.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 1e-3, density = 2500.0;

laws::MaterialPair wet() {
  laws::MaterialPair m;
  m.effective_modulus = 5e6;
  m.effective_shear_modulus = 2e6;
  m.surface_tension = 0.072;
  m.liquid_content = 1e-3;
  m.hamaker_constant = 1e-11;  // strong and far, to be seen on spheres of this size
  m.shortest_gap = 1e-6;
  m.longest_gap = 1e-4;
  return m;
}

/// Two spheres, or one and a wall, that move apart or together at a constant pace (too heavy to be slowed).
struct Draw {
  Simulation simulation;
  bool at_wall;

  static Draw of(const char* cohesion, const laws::Choices& choices, bool at_wall, double gap, double speed) {
    LawParts parts;
    parts.damping = parts.sliding = parts.rolling = "none";
    parts.cohesion = cohesion;
    parts.choices = choices;
    Model m = one_pair(wet(), parts, {-1, -1, -1}, {1, 1, 1}, 1e-5, radius, radius);
    m.body_force.gravity = {};
    std::vector<Parcel> parcels = {parcel(0, {0, 0, radius + gap}, radius, 1e9 * density, {0, 0, speed})};
    if (at_wall)
      add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
    else
      parcels.push_back(parcel(1, {0, 0, -radius}, radius, 1e9 * density));
    return {Simulation(m, state_of(m, parcels), 1), at_wall};
  }
  double gap() const {
    const auto& body = simulation.state().parcels.body;
    return (body[0].id == 0 ? body[0] : body[1]).position.z - radius;
  }
  bool touches() const {
    return at_wall ? simulation.walls().slots() > 0 && simulation.walls().touching[0]
                   : simulation.pairs().slots() > 0 && simulation.pairs().touching[0];
  }
};

/// Gaps at which a contact began and ended while the bodies moved.
struct Seen {
  double began = -1.0, ended = -1.0;
};
Seen watch(Draw d, int steps) {
  Seen seen;
  bool before = d.touches();
  for (int k = 0; k < steps; ++k) {
    d.simulation.step();
    if (d.touches() && !before) seen.began = d.gap();
    if (!d.touches() && before) seen.ended = d.gap();
    before = d.touches();
  }
  EXPECT_GT(d.simulation.rebuilds(), 1u);
  return seen;
}

double bridge_length(bool at_wall) {
  const double r = at_wall ? 2.0 * radius : radius, content = 1e-3 * 4.0 / 3.0 * 3.14159265358979;
  const double third = std::cbrt(content * (at_wall ? 1.0 : 2.0) * radius * radius * radius);
  return third + 0.1 * third * third / r;
}

TEST(Reach, OfHamakerBeginsAndEndsAtTheLongestGap) {
  for (const bool at_wall : {false, true}) {
    EXPECT_NEAR(watch(Draw::of("hamaker", {}, at_wall, 3e-4, -0.02), 1200).began, 1e-4, 4e-7) << at_wall;
    EXPECT_NEAR(watch(Draw::of("hamaker", {}, at_wall, 1e-6, 0.02), 1200).ended, 1e-4, 4e-7) << at_wall;
  }
}

TEST(Reach, OfABridgeThatFormsOnTouchEndsAtItsRupture) {
  for (const char* bridge : {"capillary_willett", "capillary_soulie"})
    for (const bool at_wall : {false, true}) {
      const Seen apart = watch(Draw::of(bridge, {}, at_wall, -1e-6, 0.05), 1200);
      EXPECT_NEAR(apart.ended, bridge_length(at_wall), 1e-6) << bridge << at_wall;
      const Seen together = watch(Draw::of(bridge, {}, at_wall, 4e-4, -0.05), 1200);
      EXPECT_NEAR(together.began, 0.0, 1e-6) << bridge << at_wall;
    }
}

TEST(Reach, OfABridgeThatFormsOnApproachBeginsAtItsRupture) {
  laws::Choices choices;
  choices.bridges_form_on_approach = true;
  for (const bool at_wall : {false, true}) {
    const Seen seen = watch(Draw::of("capillary_willett", choices, at_wall, 4e-4, -0.05), 1000);
    EXPECT_NEAR(seen.began, bridge_length(at_wall), 1e-6) << at_wall;
  }
}

}  // namespace
