// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "validation/chapters.hpp"
#include "validation/collisions.hpp"
#include "validation/sums.hpp"

namespace pulvis::validation {
namespace {

constexpr int per_edge = 6;
constexpr double smallest = 0.8e-3, largest = 1.2e-3;  // m, radii
constexpr double edge = per_edge * 2.45e-3;            // m; the spheres fill 0.3 of the box
constexpr double rms_speed = 0.2;                      // m/s
constexpr double density = 2500.0, young_modulus = 5e6, poisson_ratio = 0.3;

/// Two of the smallest spheres that meet at the rms speed: the shortest contact time of the gas but for the fast.
scenes::Collision shortest_collision() {
  scenes::Collision c;
  const scenes::Stuff stuff{density, young_modulus, poisson_ratio, 1.0, 0.0, 0.0, 0.0};
  c.material = scenes::material_pair(stuff, stuff);
  c.parts = {"hertz", "none", "none", "none", {}};
  c.radius = smallest;
  c.density = density;
  c.speed = rms_speed;
  return c;
}

/// Spheres on a lattice with room between them, with normally distributed velocities and no momentum.
Simulation start(double dt) {
  const scenes::Collision c = shortest_collision();
  Model m = scenes::one_pair(c.material, c.parts, {0, 0, 0}, {edge, edge, edge}, dt, smallest, largest);
  m.body_force.gravity = {};
  for (bool& periodic : m.domain.periodic) periodic = true;
  std::mt19937_64 random(1);
  const auto unit = [&random] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&unit] {
    return std::sqrt(-2.0 * std::log(unit())) * std::cos(2.0 * std::numbers::pi * unit());
  };
  std::vector<Parcel> parcels;
  for (int k = 0; k < per_edge * per_edge * per_edge; ++k) {
    const Vec3 cell{0.5 + k % per_edge, 0.5 + k / per_edge % per_edge, 0.5 + k / (per_edge * per_edge)};
    parcels.push_back(scenes::parcel(static_cast<std::uint32_t>(k), (edge / per_edge) * cell,
                                     smallest + (largest - smallest) * unit(), density,
                                     {normal(), normal(), normal()}));
  }
  Vec3 momentum;
  double mass = 0.0, squares = 0.0;
  for (const Parcel& p : parcels) momentum += p.mass * p.velocity, mass += p.mass;
  for (Parcel& p : parcels) {
    p.velocity -= (1.0 / mass) * momentum;
    squares += dot(p.velocity, p.velocity);
  }
  const double scale = rms_speed / std::sqrt(squares / static_cast<double>(parcels.size()));
  for (Parcel& p : parcels) p.velocity = scale * p.velocity;
  return Simulation(m, scenes::state_of(m, parcels), 1);
}

/// Elastic energy of all contacts, J, from the positions alone: (2/5) (4/3) E* sqrt(R*) delta^(5/2) of each pair
/// of nearest images (H. Hertz, J. reine angew. Math. 92 (1882) 156-171, doi:10.1515/crll.1882.92.156).
double elastic_energy(const std::vector<Parcel>& spheres) {
  const double modulus = 0.5 * young_modulus / (1.0 - poisson_ratio * poisson_ratio);
  const auto nearest = [](double d) { return d - edge * std::round(d / edge); };
  double sum = 0.0;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      const Vec3 d = spheres[i].position - spheres[j].position;
      const double x = nearest(d.x), y = nearest(d.y), z = nearest(d.z);
      const double reach = spheres[i].radius + spheres[j].radius, squared = x * x + y * y + z * z;
      if (squared >= reach * reach) continue;
      const double overlap = reach - std::sqrt(squared);
      const double radius = spheres[i].radius * spheres[j].radius / reach;
      sum += 8.0 / 15.0 * modulus * std::sqrt(radius) * overlap * overlap * std::sqrt(overlap);
    }
  return sum;
}

/// What became of the energy.
struct History {
  Curve total, elastic;  // over the time in contact times; total: less 1 at the start, elastic: share
  double drift = 0.0;    // largest deviation from the start, relative
  double share = 0.0;    // largest elastic share: that the spheres do collide
};

History energy_of(double dt, int steps, std::string label) {
  constexpr int samples = 500;
  Simulation s = start(dt);
  History h{{std::move(label), {}, {}, false}, {"elastic share", {}, {}, false}};
  const double first = scenes::kinetic_energy(s.state().parcels), unit = shortest_collision().contact_time();
  for (int sample = 1; sample <= samples; ++sample) {
    for (int k = 0; k < steps / samples; ++k) s.step();
    const double elastic = elastic_energy(s.state().parcels.body);
    const double total = scenes::kinetic_energy(s.state().parcels) + elastic;
    h.total.x.push_back(s.time() / unit);
    h.total.y.push_back(total / first - 1.0);
    h.elastic.x.push_back(s.time() / unit);
    h.elastic.y.push_back(elastic / total);
    h.share = std::max(h.share, elastic / total);
    h.drift = std::max(h.drift, std::fabs(total / first - 1.0));
  }
  return h;
}

}  // namespace

void gas(Findings& f, Effort effort) {
  const scenes::Collision c = shortest_collision();
  const int steps = effort == Effort::quick ? 200000 : 1000000;
  const double dt = c.contact_time() / 100.0, automatic = scenes::automatic_step(c);
  const History fine = energy_of(dt, steps, "dt = t_c/100");
  const History coarse = energy_of(automatic, static_cast<int>(steps * dt / automatic),
                                   fmt::format("automatic dt = t_c/{:.0f}", c.contact_time() / automatic));
  Row& row = f.compare(
      fmt::format(
          "largest deviation of the energy in {} steps of t_c/100, relative (elastic share up to {:.1f} %)",
          steps, 100.0 * fine.share),
      "conservation of energy", 0.0, fine.drift, Compare::bound, 1e-4);
  row.automatic = coarse.drift;
  f.figure({"gas-energy",
            "Kinetic and elastic energy of a frictionless elastic gas",
            "time / contact time",
            "energy / energy at the start - 1",
            {coarse.total, fine.total}});
  f.figure({"gas-elastic-share",
            "Elastic share of the energy",
            "time / contact time",
            "elastic energy / energy",
            {fine.elastic}});
}

}  // namespace pulvis::validation
