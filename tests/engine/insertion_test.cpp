// SPDX-License-Identifier: Apache-2.0
// Getting powder in: counts, masses, places, rates.
#include "engine/insertion/source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/base/failure.hpp"
#include "tests/engine/sources.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

TEST(Pack, GivesExactlyTheNumberAskedFor) {
  for (const SizeKind kind : kinds)
    for (const std::uint64_t count : {0u, 1u, 777u}) {
      SourceModel m = source(SourceModel::Kind::pack, kind, box_region({0, 0, 0}, {0.03, 0.03, 0.03}));
      m.target_count = count;
      EXPECT_EQ(draw_pack(m, cube(0.03, false)).size(), count);
    }
}

TEST(Pack, MeetsTheMassToWithinHalfTheSmallestParcel) {
  for (const SizeKind kind : kinds)
    for (int k = 0; k < 25; ++k) {
      SourceModel m = source(SourceModel::Kind::pack, kind, box_region({0, 0, 0}, {0.03, 0.03, 0.03}));
      m.target_mass = 1e-5 * std::pow(1.37, k) * (k == 0 ? 0.0 : 1.0);  // from nothing to 20 g
      const auto parcels = draw_pack(m, cube(0.03, false), {}, static_cast<std::uint64_t>(k));
      const double smallest = m.density * sphere_volume(0.5 * m.sizes->smallest());
      EXPECT_LE(std::fabs(total_mass(parcels) - *m.target_mass), 0.5 * smallest * (1 + 1e-9))
          << "distribution " << static_cast<int>(kind) << ", " << *m.target_mass << " kg";
      for (const Parcel& p : parcels) {
        EXPECT_GE(p.radius, 0.5 * m.sizes->smallest() * (1 - 1e-15));
        EXPECT_LE(p.radius, 0.5 * m.sizes->largest() * (1 + 1e-15));
        EXPECT_NEAR(p.mass, m.density * sphere_volume(p.radius), 1e-14 * p.mass);
      }
    }
}

TEST(Pack, HasNoOverlapsAndWholeSpheresInItsRegion) {
  for (const Region& region : {box_region({0.001, 0.002, 0.003}, {0.021, 0.012, 0.033}), tilted_cylinder()})
    for (const SizeKind kind : kinds) {
      SourceModel m = source(SourceModel::Kind::pack, kind, region);
      const double volume =
          region.shape == Region::Shape::box ? 6e-6 : 3.14159 * region.radius * region.radius * region.height;
      m.target_mass = 0.15 * volume * m.density;
      const Box box = cube(0.05, false);
      const auto parcels = draw_pack(m, box);
      EXPECT_EQ(overlaps(parcels, {}, box), 0u);
      for (const Parcel& p : parcels) ASSERT_TRUE(inside(p, region));
    }
}

TEST(Pack, KeepsClearOfWhatIsPresentAlsoAcrossPeriodicBoundaries) {
  const Box box = cube(0.02, true);
  Parcels present;
  // Large spheres with their centres on the boundary, so that half of each sticks out on the other side.
  for (int k = 0; k < 8; ++k) {
    const Vec3 at{(k & 1) ? 0.0 : 0.0199, (k & 2) ? 0.004 : 0.012, (k & 4) ? 0.0001 : 0.01};
    present.body.push_back(scenes::parcel(static_cast<std::uint32_t>(k), at, 1.6e-3, 1000.0));
  }
  SourceModel m =
      source(SourceModel::Kind::pack, SizeKind::uniform, box_region({0, 0, 0}, {0.02, 0.02, 0.02}));
  m.target_mass = 0.17 * 8e-6 * m.density;
  const auto parcels = draw_pack(m, box, present);
  EXPECT_GT(parcels.size(), 600u);
  EXPECT_EQ(overlaps(parcels, present.body, box), 0u);
}

TEST(Pack, DependsOnTheSeedAndOnNothingElse) {
  SourceModel m = source(SourceModel::Kind::pack, SizeKind::lognormal, tilted_cylinder());
  m.target_count = 100;
  const auto a = draw_pack(m, cube(0.05, false)), b = draw_pack(m, cube(0.05, false)),
             other = draw_pack(m, cube(0.05, false), {}, 2);
  for (std::size_t k = 0; k < 100; ++k) {
    EXPECT_EQ(a[k].position, b[k].position);
    EXPECT_NE(a[k].position, other[k].position);
  }
}

TEST(Pack, SaysHowFullTheRegionIsWhenNoMoreFits) {
  SourceModel m =
      source(SourceModel::Kind::pack, SizeKind::single, box_region({0, 0, 0}, {0.01, 0.01, 0.01}));
  m.target_count = 100000;
  try {
    draw_pack(m, cube(0.01, false));
    FAIL() << "100,000 spheres of 1 mm cannot lie in 1 cm^3";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    const std::string message = failure.what();
    EXPECT_NE(message.find("funnel"), std::string::npos) << message;
    EXPECT_NE(message.find("too full"), std::string::npos) << message;
    // Random sequential packing of spheres ends at 38.4 % without walls; a wall layer costs some of it.
    const auto at = message.find(" %");
    ASSERT_NE(at, std::string::npos) << message;
    const double share = std::stod(message.substr(message.rfind(' ', at - 1) + 1));
    EXPECT_GT(share, 25.0) << message;
    EXPECT_LT(share, 40.0) << message;
  }
}

TEST(Pack, ThatIsWiderThanItsRegionIsRefusedToo) {
  SourceModel m =
      source(SourceModel::Kind::pack, SizeKind::single, box_region({0, 0, 0}, {0.0005, 0.01, 0.01}));
  m.target_count = 10;
  std::vector<Parcel> parcels;
  try {
    parcels = draw_pack(m, cube(0.01, false));
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::bad_case);
    return;
  }
  for (const Parcel& p : parcels) EXPECT_TRUE(inside(p, m.region)) << "a sphere sticks out of its region";
}

TEST(Sources, OpenedTogetherInOneRegionDoNotOverlap) {
  SourceModel m =
      source(SourceModel::Kind::pack, SizeKind::uniform, box_region({0, 0, 0}, {0.02, 0.02, 0.02}));
  m.target_mass = 0.1 * 8e-6 * m.density;
  Model model = scenes::one_material({}, {}, {0, 0, 0}, {0.02, 0.02, 0.02}, 1e-7, 0.25e-3, 1e-3);
  model.sources = {m, m};
  Simulation s(model, Simulation::initial_state(model), 1);
  s.open_source(0);
  s.open_source(1);
  s.step();
  EXPECT_GT(s.state().parcels.size(), 500u);
  EXPECT_EQ(overlaps(s.state().parcels.body, {}, model.domain), 0u);
}

/// Lets it rain for a while into empty space and reports the mass after each step.
void watch_rain(SizeKind kind, double rate, double speed, double duration) {
  SourceModel m = source(SourceModel::Kind::rain, kind, box_region({0, 0, 0.2}, {0.03, 0.03, 0.21}));
  m.velocity = {0, 0, -speed};
  m.rate = rate;
  m.target_mass = 1.0;
  Model model = scenes::one_material({}, {}, {0, 0, -0.5}, {0.03, 0.03, 0.22}, 2e-5, 0.25e-3, 1e-3);
  model.sources = {m};
  const double largest = m.density * sphere_volume(0.5 * m.sizes->largest());
  const std::uint64_t interval = rain_interval(m, model.dt);
  Simulation s(model, Simulation::initial_state(model), 1);
  for (int k = 0; k < 100; ++k) s.step();  // opened later than at the start
  s.open_source(0);
  const double start = s.time();
  const auto steps = static_cast<std::uint64_t>(duration / model.dt);
  for (std::uint64_t k = 0; k < steps; ++k) {
    s.step();
    const double due = rate * (s.time() - start), given = s.state().ledger.inserted_mass;
    // A look serves the interval until the next: the rain is ahead by up to that, never behind.
    const double ahead = rate * model.dt * static_cast<double>(interval);
    ASSERT_GT(given, due - 0.5 * largest * (1 + 1e-9)) << "at " << s.time();
    ASSERT_LT(given, due + ahead + 0.5 * largest * (1 + 1e-9)) << "at " << s.time();
    if ((k + 1) % interval == 0) {
      ASSERT_NEAR(given, due, 0.5 * largest * (1 + 1e-9)) << "at " << s.time();
    }
  }
  EXPECT_GT(s.state().ledger.inserted, 20u);
}

TEST(Rain, KeepsItsRateToWithinHalfAParcel) {
  watch_rain(SizeKind::single, 0.002, 0.5, 0.1);
  watch_rain(SizeKind::lognormal, 0.02, 0.5, 0.1);
  watch_rain(SizeKind::table, 0.1, 1.0, 0.1);
}

TEST(Rain, LeadsByLessThanAParcelWhenItIsThin) {
  // One parcel in ten intervals: the look ahead is a tenth of a parcel.
  const double parcel = 8000.0 * sphere_volume(0.5e-3);
  watch_rain(SizeKind::single, 0.1 * parcel / (1e-3 / 0.5), 0.5, 0.8);
}

TEST(Rain, EndsAtItsTargetAndFallsIntoItsRegionOnly) {
  for (const bool by_mass : {false, true}) {
    SourceModel m = source(SourceModel::Kind::rain, SizeKind::uniform,
                           box_region({0.005, 0.005, 0.05}, {0.025, 0.025, 0.06}));
    m.velocity = {0, 0, -1.0};
    m.rate = 0.05;
    if (by_mass)
      m.target_mass = 0.001;
    else
      m.target_count = 150;
    Model model = scenes::one_material({}, {}, {0, 0, -0.2}, {0.03, 0.03, 0.07}, 2e-5, 0.25e-3, 1e-3);
    model.body_force.gravity = {};
    model.sources = {m};
    Simulation s(model, Simulation::initial_state(model), 1);
    s.open_source(0);
    std::uint64_t known = 0;
    std::size_t touched = 0;
    for (int k = 0; k < 8000; ++k) {
      s.step();
      for (const Parcel& p : s.state().parcels.body)
        if (p.id >= known) {
          Parcel born = p;
          born.position -= model.dt * p.velocity;  // drawn before the step that moved it
          EXPECT_TRUE(inside(born, m.region));
        }
      known = s.state().ledger.inserted;
      for (const auto t : s.pairs().touching) touched += t;
    }
    EXPECT_TRUE(s.state().sources[0].done);
    EXPECT_EQ(touched, 0u) << "all fall at one speed: no two may ever meet";
    if (by_mass)
      EXPECT_NEAR(s.state().ledger.inserted_mass, 0.001,
                  0.5 * m.density * sphere_volume(0.25e-3) * (1 + 1e-9));
    else
      EXPECT_EQ(s.state().ledger.inserted, 150u);
  }
}

TEST(Rain, WaitsWhileItsRegionIsBlockedAndCatchesUpLater) {
  SourceModel m =
      source(SourceModel::Kind::rain, SizeKind::single, box_region({0, 0, 0}, {0.004, 0.004, 0.002}));
  m.velocity = {0, 0, -0.2};
  m.rate = 0.01;
  m.target_mass = 1.0;
  const Box box = cube(0.1, false);
  Parcels plug;
  plug.body = {scenes::parcel(0, {0.002, 0.002, 0.001}, 5e-3, 1000.0)};
  SourceState state;
  state.open = true;
  const std::uint64_t interval = rain_interval(m, 1e-5);
  EXPECT_TRUE(draw_parcels(m, state, 1, 0, 0, 1e-5, plug, box).empty());
  EXPECT_TRUE(draw_parcels(m, state, 1, 0, interval, 1e-5, plug, box).empty());
  EXPECT_FALSE(state.done);
  EXPECT_GE(draw_parcels(m, state, 1, 0, 2 * interval, 1e-5, {}, box).size(), 1u);
}

}  // namespace

TEST(Source, PutsNoParcelIntoAWallThatCrossesItsRegion) {
  const Vec3 edge{0.02, 0.02, 0.02};
  Model m = scenes::one_material({}, {}, {}, edge, 1e-6, 0.25e-3, 1e-3);
  scenes::add_wall(m, plane_surface("across", {0.01, 0, 0}, {1, 0, 0}));
  for (const auto kind : {SourceModel::Kind::pack, SourceModel::Kind::rain}) {
    Model with = m;
    with.sources.push_back(source(kind, SizeKind::uniform, box_region({0, 0, 0}, edge)));
    with.sources.back().target_count = 300;
    with.sources.back().rate = 1.0;
    Simulation simulation(with, Simulation::initial_state(with), 1);
    simulation.open_source(0);
    simulation.step();
    ASSERT_GT(simulation.state().parcels.size(), 50u);
    for (const Parcel& p : simulation.state().parcels.body)
      EXPECT_GE(std::abs(p.position.x - 0.01), p.radius * (1 - 1e-6)) << "parcel " << p.id;
  }
}
