// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

#include "engine/laws/time_limits.hpp"
#include "validation/scene.hpp"

// Single collisions, run through the whole engine.
namespace pulvis::scenes {

/// Two equal spheres (or one and a flat wall) and how they meet.
struct Collision {
  laws::MaterialPair material;
  LawParts parts;
  double radius = 0.0;   ///< m
  double density = 0.0;  ///< kg/m^3
  double speed = 0.0;    ///< m/s, closing
  bool at_wall = false;
  double dt = 0.0;          ///< s
  double phase = 0.5;       ///< of a step at which they touch
  double tangential = 0.0;  ///< m/s along x, at a wall
  double spin = 0.0;        ///< rad/s about y, at a wall

  double sphere_mass() const { return density * sphere_volume(radius); }
  double reduced_mass() const { return at_wall ? sphere_mass() : 0.5 * sphere_mass(); }
  double reduced_radius() const { return at_wall ? radius : 0.5 * radius; }
  /// Elastic Hertz contact time, s.
  double contact_time() const {
    return laws::hertz_contact_time(reduced_mass(), reduced_radius(), material.effective_modulus, speed);
  }
};

struct Outcome {
  bool separated = false;
  double speed = 0.0;            ///< m/s, of separation
  double largest_overlap = 0.0;  ///< m
  double largest_force = 0.0;    ///< N, normal
  double duration = 0.0;         ///< s, from first touch to separation
  Vec3 velocity, spin;           ///< at a wall: of the sphere afterwards
};

inline Outcome collide(const Collision& c, std::uint64_t most_steps = 200000) {
  const double gap = (3.0 + c.phase) * c.speed * c.dt, far = 40.0 * c.radius;
  const double drift = c.dt * static_cast<double>(most_steps) * std::fabs(c.tangential);
  Model m =
      one_pair(c.material, c.parts, {-far, -far, -far}, {far + drift, far, far}, c.dt, c.radius, c.radius);
  m.body_force.gravity = {};
  std::vector<Parcel> parcels;
  if (c.at_wall) {
    add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
    parcels = {
        parcel(0, {0, 0, c.radius + gap}, c.radius, c.density, {c.tangential, 0, -c.speed}, {0, c.spin, 0})};
  } else {
    const double half = c.radius + 0.5 * gap;
    parcels = {parcel(0, {0, 0, half}, c.radius, c.density, {0, 0, -0.5 * c.speed}),
               parcel(1, {0, 0, -half}, c.radius, c.density, {0, 0, 0.5 * c.speed})};
  }
  Simulation s(m, state_of(m, parcels), 1);
  Outcome o;
  const double reach = c.at_wall ? c.radius : 2.0 * c.radius;
  bool touched = false;
  for (std::uint64_t k = 0; k < most_steps; ++k) {
    s.step();
    const auto& body = s.state().parcels.body;
    const auto of = [&](std::uint32_t id) -> const Parcel& { return body[body[0].id == id ? 0 : 1]; };
    const double distance = c.at_wall ? of(0).position.z : of(0).position.z - of(1).position.z;
    const double opening = c.at_wall ? of(0).velocity.z : of(0).velocity.z - of(1).velocity.z;
    const bool touches = c.at_wall ? s.walls().slots() > 0 && s.walls().touching[0]
                                   : s.pairs().slots() > 0 && s.pairs().touching[0];
    if (touches) {
      touched = true;
      o.largest_overlap = std::max(o.largest_overlap, reach - distance);
      const Vec3 force = c.at_wall ? s.walls().load[0].force : s.pairs().load[0].force;
      o.largest_force = std::max(o.largest_force, std::fabs(force.z));
      continue;
    }
    if (!touched) continue;
    o.separated = true;
    o.speed = opening;
    o.velocity = of(0).velocity;
    o.spin = of(0).spin;
    // Back along the free flight to where the contact ended.
    const double stretch =
        m.classes.all()[0].law.separation_gap(c.reduced_radius(), m.classes.all()[0].constants);
    o.duration = s.time() - (distance - reach - stretch) / opening - gap / c.speed;
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

/// The time step a case would be given for this collision, s. Like materials, or one at a rigid plane, so that
/// E*/G* = 2 (2 - nu)/(1 - nu) and E = E* (1 - nu^2), twice that in a pair.
inline double automatic_step(const Collision& c) {
  const double ratio = c.material.effective_modulus / c.material.effective_shear_modulus;
  const double poisson = (ratio - 4.0) / (ratio - 2.0);
  const double young = c.material.effective_modulus * (1.0 - poisson * poisson) * (c.at_wall ? 1.0 : 2.0);
  double least = laws::rayleigh_time(c.radius, c.density, young, poisson);
  for (const laws::TimeLimit& limit : laws::time_limits(c.parts.normal, c.parts.cohesion, c.material,
                                                        c.reduced_mass(), c.reduced_radius(), c.speed))
    least = std::min(least, limit.time);
  return standard_step_fraction * least;
}

}  // namespace pulvis::scenes
