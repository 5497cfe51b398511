// SPDX-License-Identifier: Apache-2.0
// The integrator on problems with a smooth solution: how fast its error falls, and what it does to energy.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "validation/draw.hpp"
#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

constexpr double radius = 5e-3, density = 2500.0;

/// A sphere that stays in contact with a plane and swings on its springs: height, sliding and spin.
struct Swing {
  double restitution;
  laws::MaterialPair material;
  double mass = density * sphere_volume(radius);
  double rest;

  explicit Swing(double e) : restitution(e) {
    Stuff stuff;
    stuff.young_modulus = 5e6;
    stuff.restitution = e;
    stuff.friction = 50.0;  // never slips
    stuff.rolling_friction = 0.0;
    material = material_pair(stuff, stuff);
    rest = laws::hertz_overlap_under(mass * 9.81, radius, material.effective_modulus);
  }

  // x, v_x, z, v_z, omega_y, xi
  using Values = std::array<long double, 6>;
  Values start() const { return {0.0L, 2e-3L, static_cast<long double>(radius - rest), -3e-3L, 0.2L, 0.0L}; }

  /// The equations of motion, from the law: F_n = 4/3 E* sqrt(R) delta^1.5 + c_n v_n, F_t = -8 G* a xi - c_t
  /// v_t.
  Values slope(const Values& y) const {
    const long double delta = radius - y[2], a = std::sqrt(radius * delta),
                      modulus = material.effective_modulus, shear = material.effective_shear_modulus;
    const long double log_e = std::log(static_cast<long double>(restitution)),
                      pi = 3.14159265358979323846264L;
    const long double beta = log_e / std::sqrt(log_e * log_e + pi * pi),
                      factor = -2.0L * std::sqrt(5.0L / 6.0L) * beta;
    const long double c_n = factor * std::sqrt(2.0L * modulus * a * mass),
                      c_t = factor * std::sqrt(8.0L * shear * a * mass);
    const long double slip = y[1] - y[2] * y[4];
    const long double normal = 4.0L / 3.0L * modulus * a * delta - c_n * y[3];
    const long double tangential = -8.0L * shear * a * y[5] - c_t * slip;
    const long double inertia = 0.4L * mass * radius * radius;
    return {y[1], tangential / mass, y[3], normal / mass - 9.81L, -y[2] * tangential / inertia, slip};
  }

  /// Runge and Kutta's fourth order in long double with many steps.
  Values reference(long double duration) const {
    Values y = start();
    constexpr int steps = 20000;
    const long double h = duration / steps;
    const auto moved = [](const Values& a, const Values& b, long double f) {
      Values c;
      for (std::size_t k = 0; k < 6; ++k) c[k] = a[k] + f * b[k];
      return c;
    };
    for (int n = 0; n < steps; ++n) {
      const Values a = slope(y), b = slope(moved(y, a, 0.5L * h)), c = slope(moved(y, b, 0.5L * h)),
                   d = slope(moved(y, c, h));
      for (std::size_t k = 0; k < 6; ++k) y[k] += h / 6.0L * (a[k] + 2.0L * b[k] + 2.0L * c[k] + d[k]);
    }
    return y;
  }

  /// The engine's answer with a number of steps; errors of position, velocity and spin against the reference.
  std::array<double, 4> errors(double duration, int steps, const Values& truth) const {
    LawParts parts;
    parts.rolling = "none";
    Model m =
        one_pair(material, parts, {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}, duration / steps, radius, radius);
    add_wall(m, plane_surface("plane", {0, 0, 0}, {0, 0, 1}));
    const Values y = start(), s0 = slope(y);
    State state = state_of(m, {parcel(0, {0, 0, static_cast<double>(y[2])}, radius, density,
                                      {static_cast<double>(y[1]), 0, static_cast<double>(y[3])},
                                      {0, static_cast<double>(y[4]), 0})});
    // The contact exists already, with its load.
    const double inertia = 0.4 * mass * radius * radius;
    state.parcels.load[0] = {{static_cast<double>(s0[1]) * mass, 0, static_cast<double>(s0[3]) * mass},
                             {0, static_cast<double>(s0[4]) * inertia, 0}};
    state.walls.begin = {0, 1};
    state.walls.partner = {0};
    state.walls.history = {{}};
    Simulation s(m, state, 1);
    for (int k = 0; k < steps; ++k) s.step();
    const Parcel& p = s.state().parcels.body[0];
    EXPECT_TRUE(s.walls().touching[0]);
    const auto away = [](double ours, long double theirs) {
      return std::fabs(static_cast<double>(ours - theirs));
    };
    return {away(p.position.x, truth[0]), away(p.position.z, truth[2]), away(p.velocity.z, truth[3]),
            away(p.spin.y, truth[4])};
  }
};

TEST(Integrator, ErrorOfAnElasticSwingFallsWithTheSquareOfTheStep) {
  const Swing swing(1.0);
  const double duration = 4e-3;  // several swings
  const auto truth = swing.reference(duration);
  auto coarse = swing.errors(duration, 400, truth);
  for (const int steps : {800, 1600, 3200}) {
    const auto fine = swing.errors(duration, steps, truth);
    for (std::size_t k = 0; k < fine.size(); ++k) {
      EXPECT_NEAR(std::log2(coarse[k] / fine[k]), 2.0, 0.15)
          << "quantity " << k << " with " << steps << " steps";
    }
    coarse = fine;
  }
}

TEST(Integrator, ErrorOfADampedSwingFallsAtLeastWithTheStep) {
  // The dashpot sees the velocity of the middle of the step and acts at its end: first order, by choice (the
  // tangential displacement and the velocity that made it stay in step).
  const Swing swing(0.5);
  const double duration = 1e-3;
  const auto truth = swing.reference(duration);
  const auto coarse = swing.errors(duration, 400, truth), fine = swing.errors(duration, 3200, truth);
  for (std::size_t k = 0; k < fine.size(); ++k) EXPECT_GT(coarse[k] / fine[k], 7.0) << "quantity " << k;
  RecordProperty("order", std::to_string(std::log2(coarse[1] / fine[1]) / 3.0));
}

TEST(HertzGas, KeepsItsEnergyInAPeriodicBox) {
  // 100 elastic, frictionless spheres at t_c/100 of the rms speed.
  Stuff stuff;
  stuff.young_modulus = 5e6;
  stuff.restitution = 1.0;
  LawParts parts{"hertz", "none", "none", "none", {}};
  const double r = 5e-4, edge = 7e-3;
  std::vector<Parcel> parcels;
  double speed_squared = 0.0;
  for (std::uint32_t k = 0; k < 100; ++k) {
    pulvis::validation::Draw draw(k, 81);
    const Vec3 at{(0.7 + 1.4 * (k % 5)) * 1e-3, (0.7 + 1.4 * (k / 5 % 5)) * 1e-3,
                  (0.7 + 1.4 * (k / 25)) * 1e-3};
    parcels.push_back(parcel(k, at, r, 2500.0, draw.vector(0.5)));
    speed_squared += dot(parcels.back().velocity, parcels.back().velocity) / 100.0;
  }
  const laws::MaterialPair material = material_pair(stuff, stuff);
  const double mass = 0.5 * parcels[0].mass, modulus = material.effective_modulus;
  const double dt = laws::hertz_contact_time(mass, 0.5 * r, modulus, std::sqrt(2.0 * speed_squared)) / 100.0;
  Model m = one_pair(material, parts, {0, 0, 0}, {edge, edge, edge}, dt, r, r);
  m.body_force.gravity = {};
  for (bool& axis : m.domain.periodic) axis = true;
  Simulation s(m, state_of(m, parcels), 1);
  const auto energy = [&] {
    double sum = kinetic_energy(s.state().parcels);
    const NearestImage nearest = NearestImage::of(m.domain);
    for (std::size_t slot = 0; slot < s.pairs().slots(); ++slot) {
      if (!s.pairs().is_pair(slot)) continue;
      const auto& body = s.state().parcels.body;
      const double overlap =
          2.0 * r -
          norm(nearest(body[s.pairs().second[slot]].position - body[s.pairs().first[slot]].position));
      if (overlap > 0.0) sum += 8.0 / 15.0 * modulus * std::sqrt(0.5 * r) * std::pow(overlap, 2.5);
    }
    return sum;
  };
  const double start = energy();
  double worst = 0.0;
  std::size_t contacts = 0;
  for (int k = 0; k < 50000; ++k) {
    s.step();
    if (k % 500) continue;
    contacts += touching(s.pairs());
    worst = std::max(worst, std::fabs(energy() / start - 1.0));
  }
  EXPECT_GT(contacts, 200u);
  EXPECT_LT(worst, 1e-4);
  RecordProperty("worst_e9", std::to_string(1e9 * worst));
}

}  // namespace
