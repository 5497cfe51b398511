// SPDX-License-Identifier: Apache-2.0
// The ledger of energy of many parcels: a tossed gas, a shaken filling, parcels and walls that go, other body forces.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "validation/draw.hpp"
#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using Term = kernels::EnergyTerm;

namespace {

constexpr double density = 2500.0;

Stuff sticky() {
  Stuff stuff;
  stuff.young_modulus = 2e6;
  stuff.work_of_adhesion = 0.02;
  return stuff;
}

LawParts law(const char* normal) {
  LawParts parts;
  parts.normal = normal;
  return parts;
}

/// Parcels on a lattice in a box of 9 mm, each with a velocity and a spin of its own.
std::vector<Parcel> tossed(std::uint32_t count, double speed, double spin) {
  std::vector<Parcel> parcels;
  for (std::uint32_t k = 0; k < count; ++k) {
    pulvis::validation::Draw draw(k, 61);
    const Vec3 at{(0.75 + 1.5 * (k % 6)) * 1e-3, (0.75 + 1.5 * (k / 6 % 6)) * 1e-3,
                  (0.75 + 1.5 * (k / 36)) * 1e-3};
    parcels.push_back(
        parcel(k, at, draw.between(0.3e-3, 0.6e-3), density, draw.vector(speed), draw.vector(spin)));
  }
  return parcels;
}

Model box_of_nine(const Stuff& stuff, const LawParts& parts, double dt) {
  Model m = one_material(stuff, parts, {0, 0, 0}, {0.009, 0.009, 0.009}, dt, 0.3e-3, 0.6e-3);
  m.energy_ledger = true;
  return m;
}

/// Walls on all faces of the box that are not periodic.
void enclose(Model& m) {
  for (int axis = 0; axis < 3; ++axis) {
    if (m.domain.periodic[axis]) continue;
    Vec3 inside{};
    inside[axis] = 1.0;
    add_wall(m, plane_surface("low", m.domain.min, inside));
    add_wall(m, plane_surface("high", m.domain.max, -inside));
  }
}

TEST(EnergyLedger, OfATossedGasCloses) {
  for (const char* normal : {"hertz", "jkr"}) {
    Model m = box_of_nine(sticky(), law(normal), 5e-6);
    m.body_force.gravity = {};
    m.domain.periodic[0] = m.domain.periodic[1] = m.domain.periodic[2] = true;
    Simulation s(m, state_of(m, tossed(200, 1.0, 500.0)), 1);
    const double energy = kinetic_energy(s.state().parcels);
    for (int k = 0; k < 8000; ++k) s.step();
    const EnergyBalance b = s.energy().value();
    EXPECT_NEAR(b.start, energy, 1e-12 * energy);
    EXPECT_NEAR(b.kinetic(), kinetic_energy(s.state().parcels), 1e-12 * energy);
    EXPECT_GT(b.lost(), 0.3 * energy);
    EXPECT_LT(std::abs(b.closing_share()), 1e-3) << normal;
  }
}

/// A heap that a pack fills, on a floor that shakes up and down, between walls at rest.
Model shaken_filling(const char* normal, double dt) {
  Model m =
      one_material(sticky(), law(normal), {-0.001, -0.001, -0.002}, {0.01, 0.01, 0.03}, dt, 0.5e-3, 0.5e-3);
  m.energy_ledger = true;
  m.walls.bodies.push_back({"floor", {0}});
  m.walls.bodies.push_back({"sides", {}});
  const auto wall = [&](const char* name, std::uint32_t body, const Vec3& point, const Vec3& inside) {
    Surface surface = plane_surface(name, point, inside);
    surface.body = body;
    m.walls.surfaces.push_back(surface);
  };
  wall("floor", 0, {0, 0, 0}, {0, 0, 1});
  wall("west", 1, {0, 0, 0}, {1, 0, 0});
  wall("east", 1, {0.009, 0, 0}, {-1, 0, 0});
  wall("south", 1, {0, 0, 0}, {0, 1, 0});
  wall("north", 1, {0, 0.009, 0}, {0, -1, 0});
  constexpr double frequency = 50.0;
  motions::Sine sine;
  sine.wave = {20.0 / square(2.0 * pi * frequency), frequency, -0.25};
  m.motions.push_back({sine});
  SourceModel pack;
  pack.name = "pack";
  pack.density = density;
  SizeLaw single;
  single.diameter = single.smallest = single.largest = 1e-3;
  pack.sizes = SizeSampler(single);
  pack.region.min = {0, 0, 0.001};
  pack.region.max = {0.009, 0.009, 0.02};
  pack.velocity = {0, 0, -0.3};
  pack.target_count = 300;
  m.sources.push_back(pack);
  return m;
}

std::vector<std::byte> account_of(const Simulation& s) { return save_state(s.snapshot()); }

TEST(EnergyLedger, OfAShakenFillingClosesAndHasWhatFallsAndWhatWallsDo) {
  for (const char* normal : {"hertz", "jkr"}) {
    const Model m = shaken_filling(normal, 5e-6);
    Simulation s(m, Simulation::initial_state(m), 1);
    s.open_source(0);
    for (int k = 0; k < 8000; ++k) s.step();
    s.start_motion(0);
    for (int k = 0; k < 12000; ++k) s.step();
    const EnergyBalance b = s.energy().value();
    double height = 0.0;
    for (const Parcel& p : s.state().parcels.body) height += p.mass * 9.81 * p.position.z;
    EXPECT_NEAR(b.potential, height, 1e-12 * height);
    EXPECT_GT(b.inserted, 2.0 * height);
    EXPECT_GT(b[Term::walls], 0.02 * b.put_through());
    EXPECT_LT(std::abs(b.closing_share()), 1e-3) << normal << ' ' << b.closing_share();
    EXPECT_GT(b[Term::elastic], 0.0);
    if (normal == std::string("jkr")) {
      EXPECT_LT(b[Term::cohesive], 0.0);
      EXPECT_GT(b[Term::touch], 0.0);
    }
  }
}

TEST(EnergyLedger, ConvergesWithTheTimeStep) {
  // What does not close is of the steps in which contacts begin and end.
  const auto share = [](double dt) {
    const Model m = shaken_filling("hertz", dt);
    Simulation s(m, Simulation::initial_state(m), 1);
    s.open_source(0);
    for (int k = 0; k < static_cast<int>(0.03 / dt); ++k) s.step();
    return std::abs(s.energy()->closing_share());
  };
  const double coarse = share(2e-5), fine = share(5e-6);
  EXPECT_LT(fine, 0.25 * coarse);
}

TEST(EnergyLedger, IsTheSameForThreadsSkinsSavingAndInstructionSets) {
  struct Chosen {  // for as long as the simulation lives: its kernels are chosen when it is made
    explicit Chosen(const char* set) {
      if (set) ::setenv("PULVIS_INSTRUCTION_SET", set, 1);
    }
    ~Chosen() { ::unsetenv("PULVIS_INSTRUCTION_SET"); }
  };
  const auto run = [](int threads, double skin, bool saved, const char* set) {
    const Chosen chosen(set);
    Model m = shaken_filling("jkr", 1e-5);
    m.skin = skin;
    Simulation s(m, Simulation::initial_state(m), threads);
    s.open_source(0);
    s.start_motion(0);
    for (int k = 0; k < 1500; ++k) s.step();
    const auto finish = [](Simulation& last) {
      for (int k = 0; k < 1500; ++k) last.step();
      return last.energy().value();
    };
    if (!saved) return finish(s);
    Simulation again(m, load_state(account_of(s)), threads);
    return finish(again);
  };
  const EnergyBalance one = run(1, 1.0, false, nullptr);
  EXPECT_GT(one.put_through(), 0.0);
  for (const EnergyBalance& other :
       {run(3, 1.0, false, nullptr), run(1, 2.0, false, nullptr), run(2, 0.5, true, nullptr),
        run(1, 1.0, false, "baseline"), run(1, 1.0, false, "avx2")}) {
    EXPECT_EQ(other.of, one.of);
    EXPECT_EQ(other.kinetic(), one.kinetic());
    EXPECT_EQ(other.closing_error(), one.closing_error());
  }
}

TEST(EnergyLedger, ChangesNoBitOfTheMotion) {
  std::string hash[2];
  for (const bool with : {false, true}) {
    Model m = shaken_filling("jkr", 1e-5);
    m.energy_ledger = with;
    Simulation s(m, Simulation::initial_state(m), 2);
    s.open_source(0);
    s.start_motion(0);
    for (int k = 0; k < 2000; ++k) s.step();
    hash[with] = s.hash();
    EXPECT_EQ(s.energy().has_value(), with);
  }
  EXPECT_EQ(hash[0], hash[1]);
}

TEST(EnergyLedger, HasWhatEscapesAndWhatGoesWithAWall) {
  Model m = shaken_filling("jkr", 5e-6);
  m.domain.min.z = -0.004;
  Simulation s(m, Simulation::initial_state(m), 1);
  s.open_source(0);
  for (int k = 0; k < 12000; ++k) s.step();
  const double at_rest = s.energy()->closing_share();
  EXPECT_LT(std::abs(at_rest), 1e-3);
  s.set_absent(0, true);  // the floor: all fall out of the domain
  const EnergyBalance without = s.energy().value();
  EXPECT_NE(without.removed, 0.0) << "contacts with the floor had energy";
  EXPECT_NEAR(without.closing_share(), at_rest, 1e-3) << "stored energy is that of the step before";
  for (int k = 0; k < 20000; ++k) s.step();
  const EnergyBalance b = s.energy().value();
  EXPECT_GT(s.state().ledger.escaped, 250u);  // some stick to the sides
  EXPECT_LT(std::abs(b.closing_share()), 1e-3) << b.closing_share();
}

TEST(EnergyLedger, OfAFallIsExact) {
  Model m = box_of_nine(sticky(), law("hertz"), 1e-5);
  m.domain.max = {0.1, 0.1, 0.1};
  Simulation s(m, state_of(m, {parcel(0, {0.05, 0.05, 0.05}, 5e-4, density, {0.1, 0.2, 0.3}, {10, 20, 30})}),
               1);
  for (int k = 0; k < 4000; ++k) s.step();
  const EnergyBalance b = s.energy().value();
  EXPECT_GT(b.kinetic(), 0.0);
  EXPECT_LT(std::abs(b.closing_error()), 1e-12 * b.kinetic());
}

TEST(EnergyLedger, OfOtherBodyForcesHasTheirWork) {
  // Gravity that turns with time, gravity along a periodic axis, and a frame that rotates ever faster.
  Model table = box_of_nine(sticky(), law("hertz"), 5e-6);
  table.body_force.times = {0.0, 0.02};
  table.body_force.table = {{0, 0, -9.81}, {9.81, 0, 0}};
  Model periodic = box_of_nine(sticky(), law("hertz"), 5e-6);
  periodic.domain.periodic[2] = true;
  Model rotating = box_of_nine(sticky(), law("hertz"), 5e-6);
  rotating.body_force.rotation = 8.0;
  rotating.body_force.ramp = 0.03;
  rotating.body_force.point = {0.0045, 0.0045, 0.1};
  rotating.body_force.axis = {0, 1, 0};
  for (Model m : {table, periodic, rotating}) {
    enclose(m);
    Simulation s(m, state_of(m, tossed(150, 0.3, 100.0)), 1);
    for (int k = 0; k < 6000; ++k) s.step();
    const EnergyBalance b = s.energy().value();
    EXPECT_FALSE(b.has_potential);
    EXPECT_EQ(b.potential, 0.0);
    EXPECT_GT(std::abs(b.body_forces), 0.05 * b.start);
    EXPECT_LT(std::abs(b.closing_share()), 2e-3) << b.body_forces / b.start << ' ' << b.closing_share();
  }
}

}  // namespace
