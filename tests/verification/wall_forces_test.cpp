// SPDX-License-Identifier: Apache-2.0
// What parcels do to walls and walls to parcels: nothing is gained or lost between them.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;
using pulvis::validation::Draw;

namespace {

constexpr double radius = 1e-3;

/// Parcels on a lattice in a box of triangles that turns and swings, next to a plane and a turning tube.
Model moving_box(Draw& draw) {
  Stuff stuff{2500.0, 5e6, 0.3, 0.6, 0.4, 0.1, 0.02};
  LawParts parts;
  parts.normal = "jkr";
  Model m = one_material(stuff, parts, {-0.04, -0.04, -0.04}, {0.04, 0.04, 0.04}, 2e-6, radius, radius);
  add_mesh(m, random_box({-0.0087, -0.0087, -0.0087}, {0.0087, 0.0087, 0.0087}, 4, 0.24, draw));
  m.walls.bodies[0].motions = {0, 1};
  m.motions = {{motions::Rotation{{0.002, 0, 0}, {0, 0.6, 0.8}, 5.0, 0.0}},
               {motions::Sine{{5e-4, 40.0, -0.25}, {1, 0, 0}}}};
  return m;
}

std::vector<Parcel> lattice(int count, Draw& draw) {
  std::vector<Parcel> parcels;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k) {
        const double step = 2.1 * radius, start = -0.5 * step * (count - 1);
        parcels.push_back(parcel(static_cast<std::uint32_t>(parcels.size()),
                                 {start + i * step, start + j * step, start + k * step}, radius, 2500,
                                 draw.vector(0.3), draw.vector(50)));
      }
  return parcels;
}

TEST(ForcesOnTriangles, BalanceTheMomentumOfThePowderAtEveryStep) {
  Draw draw(1, 97);
  const Model m = moving_box(draw);
  Simulation s(m, state_of(m, lattice(8, draw)), 1);
  s.start_motion(0);
  s.start_motion(1);
  const double mass = s.state().parcels.body[0].mass;
  const auto momentum = [&] {
    Vec3 sum;
    for (const Parcel& p : s.state().parcels.body) sum += p.mass * p.velocity;
    return sum;
  };
  // Sums by triangle, as somebody outside makes them.
  const auto wall_force = [&](double& size) {
    std::vector<Vec3> of_triangle(m.walls.meshes[0].mesh().triangles.size());
    const NearWalls& walls = s.walls();
    for (const std::uint32_t slot : s.wall_slots_by_id())
      if (walls.touching[slot]) of_triangle[walls.touched_facet[slot]] -= walls.load[slot].force;
    Vec3 sum;
    for (const Vec3& f : of_triangle) sum += f, size += norm(f);
    Vec3 of_surfaces;
    for (std::size_t k = 0; k < m.walls.surfaces.size(); ++k) of_surfaces += s.force_on_surface(k);
    EXPECT_LE(norm(sum - of_surfaces), 1e-12 * size);
    return sum;
  };
  const Vec3 weight = (mass * static_cast<double>(s.state().parcels.size())) * m.body_force.gravity;
  double size = 0.0;
  Vec3 before = momentum(), force_before{};
  double worst = 0.0, total = 0.0;
  for (int k = 0; k < 3000; ++k) {
    s.step();
    size = 0.0;
    const Vec3 force = wall_force(size);
    if (k > 0) {
      // Velocity Verlet: half of the force before, half of that after.
      const Vec3 gain = m.dt * (weight - 0.5 * (force + force_before));
      const double scale = m.dt * (norm(weight) + size) + 1e-12 * norm(before);
      worst = std::max(worst, norm(momentum() - before - gain) / scale);
      total += size;
    }
    before = momentum();
    force_before = force;
  }
  EXPECT_GT(total, 0.0);
  EXPECT_EQ(s.state().parcels.size(), 512u);
  EXPECT_LT(worst, 1e-9);
}

TEST(TorqueOnABody, IsTheParcelsLossOfAngularMomentum) {
  // A sphere spins on the floor of a body: what the floor gets about any point, sphere and gravity lose.
  Stuff stuff{2500.0, 5e6, 0.3, 0.6, 0.4, 0.1, 0.0};
  Model m = one_material(stuff, {}, {-1, -1, -1}, {1, 1, 1}, 2e-6, radius, radius);
  m.body_force.gravity = {};
  add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  Simulation s(
      m, state_of(m, {parcel(0, {3e-3, 1e-3, 0.99 * radius}, radius, 2500, {0.1, 0.2, 0}, {5, 60, 7})}), 1);
  const auto angular = [&] {
    const Parcel& p = s.state().parcels.body[0];
    return p.mass * cross(p.position, p.velocity) + inertia(p) * p.spin;
  };
  const auto torque_on_wall = [&] {
    Vec3 sum;
    const NearWalls& w = s.walls();
    for (std::size_t slot = 0; slot < w.slots(); ++slot)
      if (w.touching[slot])
        sum -=
            cross(s.state().parcels.body[w.parcel[slot]].position, w.load[slot].force) + w.load[slot].torque;
    return sum;
  };
  s.step();
  const Vec3 start = angular();
  Vec3 given = 0.5 * m.dt * torque_on_wall();
  double scale = 0.0;
  for (int k = 0; k < 400; ++k) {
    s.step();
    const Vec3 t = torque_on_wall();
    given += m.dt * t;
    scale += m.dt * norm(t);
  }
  given -= 0.5 * m.dt * torque_on_wall();
  // The position moves within the half kicks: second order in the step.
  EXPECT_LT(norm(start - angular() - given), 1e-4 * scale);
  EXPECT_GT(scale, 0.0);
}

TEST(TurningBody, DragsASphereAlongAsATurntableDoes) {
  // A sphere that rolls without slipping on a turntable circles with 2/7 of its rate (solid sphere).
  Stuff stuff{2500.0, 5e6, 0.3, 0.6, 0.5, 0.0, 0.0};
  Model m = one_material(stuff, {}, {-1, -1, -1}, {1, 1, 1}, 2e-5, radius, radius);
  add_wall(m, disc_surface("table", {0, 0, 0}, {0, 0, 1}, 0.5, 0.0));
  m.walls.bodies[0].motions = {0};
  m.motions = {{motions::Rotation{{0, 0, 0}, {0, 0, 1}, 1.0, 0.0}}};
  const double weight = 2500 * sphere_volume(radius) * 9.81;
  const double rest =
      laws::hertz_overlap_under(weight, radius, material_pair(stuff, stuff).effective_modulus);
  // On a circle of radius r about the axis it moves at (2/7) Omega r and the table under it at Omega r: its
  // lowest point, which spin about x moves by omega_x R, must keep up with the table.
  const double turn = 2.0 * pi, rate = turn * 2.0 / 7.0, path = 0.05;
  Parcel p = parcel(0, {path, 0, radius - rest}, radius, 2500, {0, rate * path, 0});
  p.spin = {(turn - rate) * path / radius, 0, 0};
  State state = state_of(m, {p});
  state.parcels.load[0].force = {};
  Simulation s(m, state, 1);
  s.start_motion(0);
  const double seconds = 0.5;
  for (int k = 0; k < static_cast<int>(seconds / m.dt); ++k) s.step();
  const Vec3 x = s.state().parcels.body[0].position;
  EXPECT_NEAR(std::hypot(x.x, x.y), path, 0.01 * path);
  EXPECT_NEAR(std::atan2(x.y, x.x), rate * seconds, 0.01);
}

TEST(WallThatTurnsRound, IsTheSameAsAWorldThatTurnsTheOtherWay) {
  // A sphere pressed on a turning plane far from its axis sees what one sees on a plane that moves along.
  Stuff stuff{2500.0, 5e6, 0.3, 0.6, 0.5, 0.0, 0.0};
  const auto run = [&](bool turns) {
    Model m = one_material(stuff, {}, {-1e3, -1e3, -1}, {1e3, 1e3, 1}, 2e-6, radius, radius);
    add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
    m.walls.bodies[0].motions = {0};
    const double far = 500.0, speed = 0.05;
    if (turns)
      m.motions = {{motions::Rotation{{0, -far, 0}, {0, 0, 1}, -speed / far / (2 * pi), 0.0}}};
    else
      m.motions = {{motions::Translation{{speed, 0, 0}}}};
    Simulation s(m, state_of(m, {parcel(0, {0, 0, 0.999 * radius}, radius, 2500)}), 1);
    s.start_motion(0);
    for (int k = 0; k < 2000; ++k) s.step();
    return s.state().parcels.body[0].velocity;
  };
  EXPECT_NEAR(run(true).x, run(false).x, 1e-5 * 0.05);
}

}  // namespace
