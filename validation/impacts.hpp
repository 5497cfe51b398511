// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "validation/collisions.hpp"
#include "validation/findings.hpp"
#include "validation/references/impact.hpp"

// Impacts through the engine, at dt = t_c/1000 and at the automatic step.
namespace pulvis::validation {

/// A meeting as the engine is given it, without rolling resistance; its time step is still to be set.
inline scenes::Collision collision_of(const Meeting& m) {
  const auto stuff = [&](const Ball& b) {
    scenes::Stuff s;
    s.young_modulus = b.modulus;
    s.poisson_ratio = b.poisson;
    s.restitution = m.restitution;
    s.friction = m.friction;
    return s;
  };
  scenes::Collision c;
  c.material = m.second ? scenes::material_pair(stuff(m.first), stuff(*m.second))
                        : scenes::on_rigid_plane(m.first.modulus, m.first.poisson, m.restitution, m.friction);
  c.parts.rolling = "none";
  c.radius = m.first.radius;
  c.density = m.first.density;
  if (m.second) {
    c.second_radius = m.second->radius;
    c.second_density = m.second->density;
  }
  c.at_wall = !m.second;
  c.speed = m.normal_speed;
  c.tangential = m.tangential_speed;
  c.spin = m.spin;
  return c;
}

/// The shortest Rayleigh time of its spheres, s.
inline double rayleigh_time_of(const Meeting& m) {
  const auto of = [](const Ball& b) {
    return laws::rayleigh_time(b.radius, b.density, b.modulus, b.poisson);
  };
  return m.second ? std::min(of(m.first), of(*m.second)) : of(m.first);
}

/// A collision at several instants within a step of first touch: what comes of it depends a little on that.
inline std::vector<scenes::Outcome> at_instants(scenes::Collision c, double dt) {
  std::vector<scenes::Outcome> outcomes;
  c.dt = dt;
  for (const double phase : {0.01, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99}) {
    c.phase = phase;
    outcomes.push_back(collide(c));
  }
  return outcomes;
}

/// What the engine made of a collision.
struct Shown {
  std::vector<scenes::Outcome> fine;       ///< at a thousandth of the contact time
  std::vector<scenes::Outcome> automatic;  ///< at the time step a case would be given
};
inline Shown shown(const scenes::Collision& c, double contact_time, double rayleigh) {
  return {at_instants(c, contact_time / 1000.0), at_instants(c, automatic_step(c, rayleigh))};
}
inline Shown shown(const Meeting& m) { return shown(collision_of(m), m.duration(), rayleigh_time_of(m)); }

/// The value furthest from its reference; not a number if a collision did not come to an end.
template <class Value>
double furthest(const std::vector<scenes::Outcome>& outcomes, double reference, const Value& value) {
  double worst = reference;
  for (const scenes::Outcome& o : outcomes) {
    if (!o.separated) return std::numeric_limits<double>::quiet_NaN();
    if (std::fabs(value(o) - reference) >= std::fabs(worst - reference)) worst = value(o);
  }
  return worst;
}

/// A row with the value furthest from its reference, also at the automatic step.
template <class Value>
Row& compare_shown(Findings& f, std::string name, std::string source, double reference, const Shown& shown,
                   Compare how, std::optional<double> limit, const Value& value) {
  Row& row = f.compare(std::move(name), std::move(source), reference, furthest(shown.fine, reference, value),
                       how, limit);
  row.automatic = furthest(shown.automatic, reference, value);
  return row;
}

}  // namespace pulvis::validation
