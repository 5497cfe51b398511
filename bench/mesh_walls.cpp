// SPDX-License-Identifier: Apache-2.0
// What a wall of triangles costs: a dense lattice of parcels in a box of six rectangles, in the same box of 10,092
// triangles, and in that box while it shakes. usage: mesh_walls [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "validation/meshes.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 1.25e-3, spacing = 1.998 * radius;
constexpr int per_side = 47;

Simulation prepare(bool triangles, bool moves) {
  Model m = one_material({}, {}, {-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2}, 1e-5, radius, radius);
  m.body_force.gravity = {0, 0, -9.81};
  const double half = 0.5 * spacing * per_side;
  Region box;
  box.min = {-half, -half, -half};
  box.max = {half, half, half};
  pulvis::validation::Draw draw(1, 99);
  if (triangles)
    add_mesh(m, random_box(box.min, box.max, 29, 0.24, draw));
  else
    for (const Surface& s : box_surfaces("box", box, {})) add_wall(m, s);
  motions::Sine sine;
  sine.wave = {1e-4, 50.0, -0.25};
  m.motions.push_back({sine});
  m.walls.bodies[0].motions = {0};
  std::vector<Parcel> parcels;
  for (int k = 0; k < per_side * per_side * per_side; ++k) {
    const auto at = [&](int i) { return (i - 0.5 * (per_side - 1)) * spacing; };
    const Vec3 place{at(k % per_side), at(k / per_side % per_side), at(k / per_side / per_side)};
    parcels.push_back(parcel(static_cast<std::uint32_t>(k), place + draw.vector(2e-6), radius, 2500));
  }
  Simulation s(m, state_of(m, parcels), 1);
  if (moves) s.start_motion(0);
  for (int k = 0; k < 50; ++k) s.step();
  return s;
}

double nanoseconds_per_step(Simulation& s, int steps) {
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < steps; ++k) s.step();
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / steps / static_cast<double>(s.state().parcels.size());
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
  Simulation shapes = prepare(false, false), mesh = prepare(true, false), shaken = prepare(true, true);
  std::vector<double> ratio, ratio_shaken;
  for (int round = 0; round < rounds; ++round) {
    const double a = nanoseconds_per_step(shapes, 100), b = nanoseconds_per_step(mesh, 100),
                 c = nanoseconds_per_step(shaken, 100);
    fmt::print("{} parcels: rectangles {:.1f} ns a particle-step, {} triangles {:.1f}, shaken {:.1f}\n",
               shapes.state().parcels.size(), a, mesh.model().walls.meshes[0].mesh().triangles.size(), b, c);
    ratio.push_back(b / a);
    ratio_shaken.push_back(c / a);
  }
  std::sort(ratio.begin(), ratio.end());
  std::sort(ratio_shaken.begin(), ratio_shaken.end());
  fmt::print("median ratio {:.3f}, shaken {:.3f}\n", ratio[ratio.size() / 2], ratio_shaken[ratio.size() / 2]);
  return 0;
}
