// SPDX-License-Identifier: Apache-2.0
// Laws that pull across a gap, through the whole engine: the near lists must know of them in time, before the bodies
// touch and after they parted, also when the lists are rebuilt on the way.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "validation/meshes.hpp"
#include "validation/sums.hpp"

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
  m.work_of_adhesion = 20.0;  // so that a contact stretches over several rebuilds
  return m;
}

/// What the first sphere moves away from or towards.
enum class Partner { sphere, plane, triangles };
constexpr Partner partners[] = {Partner::sphere, Partner::plane, Partner::triangles};

/// A law and where its contact should begin or end.
struct Pulling {
  LawParts parts{"hertz", "none", "none", "none", {}};
  double gap = 3e-4;     ///< m, at the start
  double speed = -0.05;  ///< m/s, apart
};

Pulling pulling(const char* cohesion, double gap, double speed) {
  Pulling p;
  p.parts.cohesion = cohesion;
  p.gap = gap;
  p.speed = speed;
  return p;
}

Simulation begin(const Pulling& p, Partner partner) {
  Model m = one_pair(wet(), p.parts, {-1, -1, -1}, {1, 1, 1}, 1e-5, radius, radius);
  m.body_force.gravity = {};
  // Too heavy to be slowed.
  std::vector<Parcel> parcels = {parcel(0, {0, 0, radius + p.gap}, radius, 1e9 * density, {0, 0, p.speed})};
  if (partner == Partner::sphere) parcels.push_back(parcel(1, {0, 0, -radius}, radius, 1e9 * density));
  if (partner == Partner::plane) add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
  if (partner == Partner::triangles) {
    validation::Draw draw(1, 95);
    add_mesh(m, random_triangles({-0.005, -0.005, 0}, {0.01, 0, 0}, {0, 0.01, 0}, 9, 8, 0.24, draw));
  }
  return Simulation(m, state_of(m, parcels), 1);
}

/// Gaps at which a contact began and ended while the bodies moved.
struct Seen {
  double began = -1.0, ended = -1.0;
};
Seen watch(const Pulling& p, Partner partner, int steps = 1200) {
  std::optional<Simulation> going(begin(p, partner));
  Seen seen;
  bool before = false;
  for (int k = 0; k < steps; ++k) {
    if (k % 100 == 99) {  // lists are made anew across the gap
      const Model model = going->model();
      State state = going->snapshot();
      going.emplace(model, std::move(state), 1);
    }
    Simulation& s = *going;
    s.step();
    const bool now = touching(s.pairs()) + touching(s.walls()) > 0;
    const double gap = parcel_with_id(s, 0).position.z - radius;
    if (now && !before) seen.began = gap;
    if (!now && before) seen.ended = gap;
    before = now;
  }
  return seen;
}

double bridge_length(Partner partner) {
  const bool wall = partner != Partner::sphere;
  const double r = wall ? 2.0 * radius : radius, content = 1e-3 * 4.0 / 3.0 * 3.14159265358979;
  const double third = std::cbrt(content * (wall ? 1.0 : 2.0) * radius * radius * radius);
  return third + 0.1 * third * third / r;
}

const char* const bridges[] = {"capillary_willett", "capillary_willett_closed", "capillary_rabinovich",
                               "capillary_soulie"};

TEST(Reach, OfHamakerBeginsAndEndsAtTheLongestGap) {
  for (const Partner partner : partners) {
    EXPECT_NEAR(watch(pulling("hamaker", 3e-4, -0.02), partner).began, 1e-4, 4e-7);
    EXPECT_NEAR(watch(pulling("hamaker", 1e-6, 0.02), partner).ended, 1e-4, 4e-7);
  }
}

TEST(Reach, OfABridgeThatFormsOnTouchEndsAtItsRupture) {
  for (const char* bridge : bridges)
    for (const Partner partner : partners) {
      EXPECT_NEAR(watch(pulling(bridge, -1e-6, 0.05), partner).ended, bridge_length(partner), 1e-6) << bridge;
      EXPECT_NEAR(watch(pulling(bridge, 4e-4, -0.05), partner, 1000).began, 0.0, 1e-6) << bridge;
    }
}

TEST(Reach, OfABridgeThatFormsOnApproachBeginsAtItsRupture) {
  for (const char* bridge : bridges)
    for (const Partner partner : partners) {
      Pulling p = pulling(bridge, 4e-4, -0.05);
      p.parts.choices.bridges_form_on_approach = true;
      EXPECT_NEAR(watch(p, partner, 1000).began, bridge_length(partner), 1e-6) << bridge;
    }
}

TEST(Reach, OfJkrEndsAtTheStretchOfRupture) {
  for (const Partner partner : partners) {
    Pulling p = pulling("none", -1e-6, 0.02);
    p.parts.normal = "jkr";
    const double reduced = partner == Partner::sphere ? 0.5 * radius : radius;
    // delta_c = (3/4) (pi^2 W^2 R/E^2)^(1/3)
    const double stretch = 0.75 * std::cbrt(9.8696044 * wet().work_of_adhesion * wet().work_of_adhesion *
                                            reduced / (wet().effective_modulus * wet().effective_modulus));
    EXPECT_GT(stretch, 2e-5);
    EXPECT_NEAR(watch(p, partner).ended, stretch, 4e-7);
    p.gap = 3e-4, p.speed = -0.02;
    EXPECT_NEAR(watch(p, partner, 1550).began, 0.0, 4e-7);
  }
}

}  // namespace
