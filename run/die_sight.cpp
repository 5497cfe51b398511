// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "run/measuring.hpp"

namespace pulvis {
namespace {

measures::Container container_of(const Region& region, const Vec3& moved, const Vec3& gravity) {
  measures::Container m;
  m.shape = region.shape == Region::Shape::box ? measures::Container::Shape::box
                                               : measures::Container::Shape::cylinder;
  m.min = region.min + moved;
  m.max = region.max + moved;
  m.base = region.base + moved;
  m.axis = region.axis;
  m.radius = region.radius;
  m.height = region.height;
  m.up = -gravity;
  return m;
}

/// Of the wall that is the measured die; at rest if a region is measured instead.
Pose pose_of_die(const Case& c, const Simulation& simulation) {
  if (!c.measures.die) return {};
  const std::string& body = c.walls[*c.measures.die].body;
  const auto& bodies = simulation.model().walls.bodies;
  const auto at = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == body; });
  return simulation.pose(static_cast<std::size_t>(at - bodies.begin()));
}

bool has_turned(const Pose& pose) { return !(pose.now == Rigid::translation(pose.now.shift)); }

}  // namespace

std::optional<measures::Container> measured_container(const Case& c, const Simulation& simulation) {
  const Vec3 pull = simulation.field().at(0.5 * (c.domain.min + c.domain.max));
  if (c.measures.region) return container_of(*c.measures.region, {}, pull);
  if (!c.measures.die) return {};
  const Pose pose = pose_of_die(c, simulation);
  const Region& region = c.walls[*c.measures.die].region;
  if (!has_turned(pose)) return container_of(region, pose.now.shift, pull);
  return container_of(region, {}, pose.now.turn_back(pull));  // its own frame
}

Rigid placement_of_container(const Case& c, const Simulation& simulation) {
  const Pose pose = pose_of_die(c, simulation);
  return has_turned(pose) ? pose.now : Rigid{};
}

std::optional<DieSight> spheres_in_die(const Case& c, const Simulation& simulation) {
  const auto container = measured_container(c, simulation);
  if (!container) return {};
  DieSight die{*container, look_at(simulation), {}, {}};
  const Pose pose = pose_of_die(c, simulation);
  if (has_turned(pose))
    for (measures::Sphere& sphere : die.sight.spheres) sphere.centre = pose.now.back(sphere.centre);
  return die;
}

std::optional<DieSight> look_into_die(const Case& c, const Simulation& simulation) {
  auto seen = spheres_in_die(c, simulation);
  if (!seen) return {};
  DieSight& die = *seen;
  die.forces = forces_in(simulation, die.sight);
  const Pose pose = pose_of_die(c, simulation);
  die.particles.reserve(die.sight.bodies.size());
  for (std::size_t k = 0; k < die.sight.bodies.size(); ++k) {
    const measures::Body& body = die.sight.bodies[k];
    const Vec3 of_die = pose.velocity(pose.now.back(body.position), simulation.model().dt);
    die.particles.push_back({body.position, body.velocity - of_die, body.mass, die.sight.spheres[k].radius});
  }
  if (!has_turned(pose)) return seen;
  for (measures::Particle& p : die.particles) {
    p.position = pose.now.back(p.position);
    p.velocity = pose.now.turn_back(p.velocity);
  }
  const auto turn = [&](auto& contact) {
    contact.force = pose.now.turn_back(contact.force);
    contact.branch = pose.now.turn_back(contact.branch);
  };
  for (measures::PairForce& pair : die.forces.pairs) turn(pair);
  for (measures::WallForce& wall : die.forces.walls) turn(wall);
  return seen;
}

std::optional<measures::Fill> fill_of_die(const Case& c, const Simulation& simulation) {
  const auto die = spheres_in_die(c, simulation);
  if (!die) return {};
  return measures::fill_inside(die->sight.spheres, die->sight.masses, die->container);
}

}  // namespace pulvis
