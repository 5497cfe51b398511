// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/laws/time_limits.hpp"
#include "validation/scene.hpp"

// Single collisions, run through the whole engine.
namespace pulvis::scenes {

/// Two spheres (or one and a flat wall) and how they meet along z.
struct Collision {
  laws::MaterialPair material;
  LawParts parts;
  double radius = 0.0;   ///< m
  double density = 0.0;  ///< kg/m^3
  double speed = 0.0;    ///< m/s, closing
  bool at_wall = false;
  double dt = 0.0;              ///< s
  double phase = 0.5;           ///< of a step at which they touch
  double tangential = 0.0;      ///< m/s along x, of the first
  double spin = 0.0;            ///< rad/s about y, of the first
  double second_radius = 0.0;   ///< m; 0: as the first
  double second_density = 0.0;  ///< kg/m^3; 0: as the first
  double second_spin = 0.0;     ///< rad/s about y

  double radius_of_second() const { return second_radius > 0.0 ? second_radius : radius; }
  double density_of_second() const { return second_density > 0.0 ? second_density : density; }
  double reduced_mass() const {
    const double first = density * sphere_volume(radius);
    const double second = density_of_second() * sphere_volume(radius_of_second());
    return at_wall ? first : first * second / (first + second);
  }
  double reduced_radius() const {
    return at_wall ? radius : radius * radius_of_second() / (radius + radius_of_second());
  }
  /// Elastic Hertz contact time, s.
  double contact_time() const {
    return laws::hertz_contact_time(reduced_mass(), reduced_radius(), material.effective_modulus, speed);
  }
};

/// The end of a step while they touch.
struct Instant {
  double time;     ///< s, from first touch
  double overlap;  ///< m
  double force;    ///< N, normal
};

struct Outcome {
  bool separated = false;
  double speed = 0.0;            ///< m/s, of separation
  double largest_overlap = 0.0;  ///< m
  double largest_force = 0.0;    ///< N, normal
  double duration = 0.0;         ///< s, from first touch to separation
  double slip = 0.0;             ///< m/s along x, of the first against the second where they touched
  Vec3 velocity, spin;           ///< of the first afterwards
  Vec3 second_velocity, second_spin;
  std::vector<Instant> course;
};

/// The model of a collision, and its one or two parcels, the first above.
inline Model model_of(const Collision& c, std::uint64_t most_steps) {
  const double other = c.at_wall ? c.radius : c.radius_of_second();
  const double far = 40.0 * std::max(c.radius, other);
  const double drift = c.dt * static_cast<double>(most_steps) * std::fabs(c.tangential);
  Model m = one_pair(c.material, c.parts, {-far, -far, -far}, {far + drift, far, far}, c.dt,
                     std::min(c.radius, other), std::max(c.radius, other));
  m.body_force.gravity = {};
  if (c.at_wall) add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
  return m;
}
inline std::vector<Parcel> parcels_of(const Collision& c, double gap) {
  const Vec3 spin{0, c.spin, 0};
  if (c.at_wall)
    return {parcel(0, {0, 0, c.radius + gap}, c.radius, c.density, {c.tangential, 0, -c.speed}, spin)};
  const double other = c.radius_of_second();
  return {
      parcel(0, {0, 0, c.radius + 0.5 * gap}, c.radius, c.density, {c.tangential, 0, -0.5 * c.speed}, spin),
      parcel(1, {0, 0, -other - 0.5 * gap}, other, c.density_of_second(), {0, 0, 0.5 * c.speed},
             {0, c.second_spin, 0})};
}

inline Outcome collide(const Collision& c, std::uint64_t most_steps = 200000) {
  const double gap = (3.0 + c.phase) * c.speed * c.dt;
  const Model m = model_of(c, most_steps);
  Simulation s(m, state_of(m, parcels_of(c, gap)), 1);
  Outcome o;
  const Parcel wall;
  const double other = c.at_wall ? 0.0 : c.radius_of_second(), reach = c.radius + other;
  for (std::uint64_t k = 0; k < most_steps; ++k) {
    s.step();
    const auto& body = s.state().parcels.body;
    const Parcel& first = body[body[0].id == 0 ? 0 : 1];
    const Parcel& second = c.at_wall ? wall : body[body[0].id == 0 ? 1 : 0];
    const Vec3 apart = first.position - second.position, away = first.velocity - second.velocity;
    // A pair may turn a little while it touches.
    const double distance = c.at_wall ? apart.z : norm(apart);
    const bool touches = c.at_wall ? s.walls().slots() > 0 && s.walls().touching[0]
                                   : s.pairs().slots() > 0 && s.pairs().touching[0];
    if (touches) {
      const Vec3 force = c.at_wall ? s.walls().load[0].force : s.pairs().force_on_first(0);
      o.course.push_back({s.time() - gap / c.speed, reach - distance, std::fabs(force.z)});
      o.largest_overlap = std::max(o.largest_overlap, o.course.back().overlap);
      o.largest_force = std::max(o.largest_force, o.course.back().force);
      continue;
    }
    if (o.course.empty()) continue;
    o.separated = true;
    o.speed = c.at_wall ? away.z : dot(away, apart) / distance;
    o.velocity = first.velocity;
    o.spin = first.spin;
    o.second_velocity = second.velocity;
    o.second_spin = second.spin;
    o.slip = away.x - c.radius * first.spin.y - other * second.spin.y;
    // Back along the free flight to where the contact ended.
    const double stretch =
        m.classes.all()[0].law.separation_gap(c.reduced_radius(), m.classes.all()[0].constants);
    o.duration = s.time() - (distance - reach - stretch) / o.speed - gap / c.speed;
    return o;
  }
  return o;
}

/// A sphere of a material that meets a rigid plane: E* = E/(1 - nu^2), 1/G* = 2 (2 - nu)(1 + nu)/E.
inline laws::MaterialPair on_rigid_plane(double modulus, double poisson, double restitution,
                                         double friction) {
  laws::MaterialPair m;
  m.effective_modulus = modulus / (1.0 - poisson * poisson);
  m.effective_shear_modulus = modulus / (2.0 * (2.0 - poisson) * (1.0 + poisson));
  m.restitution = restitution;
  m.friction = friction;
  return m;
}

/// What `time.fraction` of a case is where it does not say: share of the smallest limit.
inline constexpr double standard_step_fraction = 0.2;

/// The time step a case would be given, s, for bodies with this reduced mass and radius that meet at `speed`, if
/// the shortest Rayleigh time of the materials is `rayleigh`.
inline double automatic_step(const laws::Law& law, const laws::MaterialPair& material,
                             const laws::Choices& choices, double mass, double radius, double speed,
                             double rayleigh) {
  double least = rayleigh;
  for (const laws::TimeLimit& limit : laws::time_limits(law, material, choices, mass, radius, speed))
    least = std::min(least, limit.time);
  return standard_step_fraction * least;
}

/// The same for a collision.
inline double automatic_step(const Collision& c, double rayleigh) {
  return automatic_step(law_of(c.parts), c.material, c.parts.choices, c.reduced_mass(), c.reduced_radius(),
                        c.speed, rayleigh);
}

/// The same for like spheres, or one at a rigid plane, so that E*/G* = 2 (2 - nu)/(1 - nu) and
/// E = E* (1 - nu^2), twice that in a pair.
inline double automatic_step(const Collision& c) {
  const double ratio = c.material.effective_modulus / c.material.effective_shear_modulus;
  const double poisson = (ratio - 4.0) / (ratio - 2.0);
  const double young = c.material.effective_modulus * (1.0 - poisson * poisson) * (c.at_wall ? 1.0 : 2.0);
  return automatic_step(c, laws::rayleigh_time(c.radius, c.density, young, poisson));
}

}  // namespace pulvis::scenes
