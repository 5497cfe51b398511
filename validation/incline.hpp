// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string>

#include "validation/collisions.hpp"

// The sphere of the rolling tests of J. Ai, J.-F. Chen, J. M. Rotter, J. Y. Ooi, Powder Technol. 206 (2011) 269-282,
// doi:10.1016/j.powtec.2010.09.030, on a plane under tilted gravity.
namespace pulvis::scenes {

struct Incline {
  static constexpr double gravity = 9.81, radius = 5e-3, density = 1056.0;
  static constexpr double young_modulus = 40e6, poisson_ratio = 0.49, restitution = 0.9;
  static constexpr double published_step = 1e-5;  ///< s

  double angle = 0.0;  ///< rad, falling along x
  double friction = 0.5, rolling_friction = 0.0, rolling_viscosity = 0.3;
  double speed = 0.0;  ///< m/s along x at the start, without spin
  double dt = published_step;
  std::string rolling = "elastic_plastic";

  static Stuff stuff() { return {density, young_modulus, poisson_ratio, restitution, 0.0, 0.0, 0.0}; }
  laws::MaterialPair material() const {
    laws::MaterialPair pair = material_pair(stuff(), stuff());
    pair.friction = friction;
    pair.rolling_friction = rolling_friction;
    pair.rolling_viscosity = rolling_viscosity;
    return pair;
  }
  static double mass() { return density * sphere_volume(radius); }
  /// Hertz contact time with the plane at 1 m/s, the speed of the tests, s.
  static double contact_time() {
    return laws::hertz_contact_time(mass(), radius, Incline{}.material().effective_modulus, 1.0);
  }
  /// What a case would be given, s.
  static double automatic_step() {
    return scenes::automatic_step(law_of({}), Incline{}.material(), {}, mass(), radius, 1.0,
                                  laws::rayleigh_time(radius, density, young_modulus, poisson_ratio));
  }

  Simulation start() const {
    LawParts parts;
    parts.rolling = rolling;
    Model m = one_pair(material(), parts, {-1, -1, -0.1}, {3, 1, 0.1}, dt, radius, radius);
    m.body_force.gravity = {gravity * std::sin(angle), 0, -gravity * std::cos(angle)};
    add_wall(m, plane_surface("plane", {0, 0, 0}, {0, 0, 1}));
    // It lies as deep as its weight presses it, and the load it starts with is balanced across the plane.
    const double weight = mass() * -m.body_force.gravity.z;
    const double rest = laws::hertz_overlap_under(weight, radius, material().effective_modulus);
    State state = state_of(m, {parcel(0, {0, 0, radius - rest}, radius, density, {speed, 0, 0})});
    state.parcels.load[0].force.z = 0.0;
    return Simulation(m, state, 1);
  }
};

/// Steps on to a time, s.
inline void run_to(Simulation& s, double time) {
  while (s.time() < time - 0.5 * s.model().dt) s.step();
}

}  // namespace pulvis::scenes
