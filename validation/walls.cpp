// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/laws/time_limits.hpp"
#include "validation/chapters.hpp"
#include "validation/collisions.hpp"
#include "validation/law_scene.hpp"
#include "validation/meshes.hpp"
#include "validation/references/law_list.hpp"
#include "validation/sums.hpp"
#include "validation/worst.hpp"

namespace pulvis::validation {
namespace {

constexpr double radius = 1e-3;
const scenes::Stuff stuff{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, 0.02};

/// A rectangle, as a shape or as triangles.
struct Face {
  Vec3 corner, along, across;
};

/// Everything lies aslant, gravity too, so that roundings differ from triangle to triangle.
const Rigid aslant = Rigid::rotation(0.13, {}, {0.48, 0.6, 0.64});

/// A sphere thrown at a wall of faces; a single face stands for a plane. It keeps rolling: where it stood still,
/// constant_torque would take its direction from roundings.
struct Trial {
  std::string name;
  std::vector<Face> faces;
  Parcel start;
  double duration;  ///< s
  std::uint32_t cells[2] = {6, 5};
  bool shaken = false;    ///< the wall moves to and fro and swings
  double gravity = 9.81;  ///< m/s^2
};

Vec3 falling(double height) { return {-0.004, -0.003, height}; }

std::vector<Trial> trials() {
  const double s = 0.012, h = 1.5e-3, rest = 0.9998e-3;
  const auto sphere = [](const Vec3& at, const Vec3& velocity, const Vec3& spin) {
    return scenes::parcel(0, at, radius, stuff.density, velocity, spin);
  };
  const Face flat{{-0.01, -0.01, 0}, {0.02, 0, 0}, {0, 0.02, 0}};
  return {
      {"a flat wall, thrown on it",
       {flat},
       sphere(falling(2e-3), {0.08, 0.05, -0.2}, {150, -200, 250}),
       0.03},
      {"a corner, thrown into it",
       {{{0, 0, 0}, {s, 0, 0}, {0, s, 0}},
        {{0, 0, 0}, {0, s, 0}, {0, 0, s}},
        {{0, 0, 0}, {0, 0, s}, {s, 0, 0}}},
       sphere({2e-3, 2.3e-3, 1.7e-3}, {-0.15, -0.12, -0.1}, {150, -200, 250}),
       0.03},
      // Along the edge it also moves and spins, so that friction there has work to do.
      {"an edge, rolling over it",
       {{{-s, -s / 2, 0}, {s, 0, 0}, {0, s, 0}}, {{0, -s / 2, 0}, {0, 0, -s}, {0, s, 0}}},
       sphere({-1.5e-3, -1e-3, rest}, {0.1, 0.03, 0}, {0, 100, 20}),
       0.03},
      {"a step, rolling down it",
       {{{-s, -s / 2, h}, {s, 0, 0}, {0, s, 0}},
        {{0, -s / 2, h}, {0, 0, -h}, {0, s, 0}},
        {{0, -s / 2, 0}, {s, 0, 0}, {0, s, 0}}},
       sphere({-1.2e-3, 0.3e-3, h + rest}, {0.12, -0.02, 0}, {10, 120, -20}),
       0.04},
      // Triangles of 2 mm, at 5 g: under its mere weight an undamped sphere sinks in so little (2e-7 m) that the
      // roundings of 10,000 places would show. It slides at first and then rolls.
      {"a thousand triangles, sliding and rolling over them",
       {{{-0.02, -0.02, 0}, {0.04, 0, 0}, {0, 0.04, 0}}},
       sphere({-0.015, -0.012, rest}, {0.4, 0.35, 0}, {-260, 300, 5}),
       0.04,
       {25, 20},
       false,
       50.0},
      {"a flat wall that shakes and swings",
       {flat},
       sphere(falling(radius), {0.05, 0.05, -0.05}, {150, -200, 250}),
       0.03,
       {6, 5},
       true},
  };
}

void add_faces(Model& m, const Trial& t, bool triangles, std::uint64_t number) {
  if (triangles) {
    Draw draw(number, 91);
    std::vector<TriangleMesh> parts;
    for (const Face& f : t.faces)
      parts.push_back(
          scenes::random_triangles(f.corner, f.along, f.across, t.cells[0], t.cells[1], 0.24, draw));
    TriangleMesh mesh = scenes::joined(parts);
    for (Vec3& p : mesh.points) p = aslant.turn(p);
    scenes::add_mesh(m, std::move(mesh));
  } else if (t.faces.size() == 1) {
    const Vec3 normal = cross(t.faces[0].along, t.faces[0].across);
    scenes::add_wall(
        m, plane_surface("plane", aslant.turn(t.faces[0].corner), aslant.turn(normal / norm(normal))));
  } else {
    for (const Face& f : t.faces)
      scenes::add_wall(
          m, rectangle_surface("face", aslant.turn(f.corner), aslant.turn(f.along), aslant.turn(f.across)));
  }
}

Simulation begin(const Trial& t, const laws::Law& law, double dt, bool triangles, std::uint64_t number) {
  Model m = scenes::one_pair(with_every_property(stuff, stuff), scenes::parts_of(law), {-0.06, -0.06, -0.06},
                             {0.06, 0.06, 0.06}, dt, radius, radius);
  m.body_force.gravity = aslant.turn({0, 0, -t.gravity});
  add_faces(m, t, triangles, number);
  if (t.shaken) {
    m.motions = {{motions::Sine{{2e-4, 60.0, 0.0}, aslant.turn({0.6, 0, 0.8})}},
                 {motions::Swing{{0.002, 45.0, 0.0}, aslant.turn({-0.01, 0, 0}), aslant.turn({0, 1, 0})}}};
    m.walls.bodies[0].motions = {0, 1};
  }
  Parcel start = t.start;
  start.position = aslant.turn(start.position);
  start.velocity = aslant.turn(start.velocity);
  start.spin = aslant.turn(start.spin);
  Simulation s(m, scenes::state_of(m, {start}), 1);
  for (std::size_t k = 0; k < m.motions.size(); ++k) s.start_motion(k);
  return s;
}

/// What is compared: path (place over the radius, velocity and spin over their largest), force and torque over the
/// run, and steps with different numbers of contacts.
enum Quantity { path, force, torque, contacts, quantities };
constexpr std::array<const char*, quantities> quantity_names{
    "path and spin", "force over the run", "torque over the run", "steps with different contacts"};
using Difference = std::array<double, quantities>;

/// Runs a trial with shapes and with triangles side by side.
Difference compare_walls(const Trial& t, const laws::Law& law, double dt, std::uint64_t number) {
  Simulation one = begin(t, law, dt, false, number), two = begin(t, law, dt, true, number);
  Difference worst{};
  Scaled place, speed, turning, push, twist;
  bool touched = false;
  const auto steps = static_cast<int>(t.duration / dt);
  for (int k = 0; k < steps; ++k) {
    one.step();
    two.step();
    if (one.state().parcels.size() == 0 || two.state().parcels.size() == 0) {
      raise(worst[path], NAN);  // it escaped
      return worst;
    }
    const Parcel &p = one.state().parcels.body[0], &q = two.state().parcels.body[0];
    const Load &a = one.state().parcels.load[0], &b = two.state().parcels.load[0];
    place.add(p.position, q.position);
    speed.add(p.velocity, q.velocity);
    turning.add(p.spin, q.spin);
    const std::size_t now = scenes::touching(one.walls());
    worst[contacts] += now != scenes::touching(two.walls());
    push.add(a.force, b.force);
    twist.add(a.torque, b.torque);
    touched |= now > 0;
  }
  raise(worst[path], touched ? place.difference / radius : NAN);
  raise(worst[path], speed.of_largest());
  raise(worst[path], turning.of_largest());
  raise(worst[force], push.of_mean());
  raise(worst[torque], twist.of_mean());
  return worst;
}

/// What a case would be given, s.
double automatic_step(const laws::Law& law) {
  return scenes::automatic_step(
      law, with_every_property(stuff, stuff), {}, stuff.density * sphere_volume(radius), radius, 0.3,
      laws::rayleigh_time(radius, stuff.density, stuff.young_modulus, stuff.poisson_ratio));
}

/// The worst of all laws, each with triangles of its own, at dt = `share` of the contact time.
void add_rows(Findings& f, const Trial& t, double share, Curve& curve) {
  Difference worst{}, automatic{};
  std::array<std::string, quantities> of;
  const double mass = stuff.density * sphere_volume(radius);
  const double contact_time =
      laws::hertz_contact_time(mass, radius, with_every_property(stuff, stuff).effective_modulus, 0.3);
  const std::vector<laws::Law>& list = laws_to_test();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double coarse = automatic_step(list[k]);
    const double fine = std::min(share * contact_time, coarse);
    const Difference one = compare_walls(t, list[k], fine, k), other = compare_walls(t, list[k], coarse, k);
    for (std::size_t q = 0; q < quantities; ++q) {
      if (one[q] > worst[q]) of[q] = name_of(list[k]);
      raise(worst[q], one[q]);
      raise(automatic[q], other[q]);
    }
    curve.x.push_back(static_cast<double>(k + 1));
    curve.y.push_back(std::max(one[path], 1e-18));
  }
  for (std::size_t q = 0; q < quantities; ++q) {
    Row& row =
        f.compare(fmt::format("{}: {}, worst of {} laws", t.name, quantity_names[q], list.size()),
                  of[q].empty() ? "the same wall as shapes" : "the same wall as shapes; worst: " + of[q], 0.0,
                  worst[q], Compare::bound, q == contacts ? 0.0 : 1e-9);
    row.automatic = automatic[q];
  }
}

}  // namespace

void triangulated_walls(Findings& f, Effort effort) {
  Figure figure{"walls",
                "Triangles against shapes: largest difference of path and spin",
                "number of the law",
                "difference",
                {}};
  figure.log_y = true;
  for (const Trial& t : trials()) {
    Curve curve{t.name, {}, {}, true};
    add_rows(f, t, effort == Effort::quick ? 1e-2 : 1e-3, curve);
    figure.curves.push_back(std::move(curve));
  }
  f.figure(std::move(figure));
}

}  // namespace pulvis::validation
