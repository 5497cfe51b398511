// SPDX-License-Identifier: Apache-2.0
#include "run/sight.hpp"

#include <algorithm>
#include <numeric>

#include "engine/contacts/wall_sight.hpp"

namespace pulvis {

Sight look_at(const Simulation& simulation) {
  const auto& body = simulation.state().parcels.body;
  Sight s;
  s.index.resize(body.size());
  std::iota(s.index.begin(), s.index.end(), 0u);
  std::sort(s.index.begin(), s.index.end(),
            [&](std::uint32_t a, std::uint32_t b) { return body[a].id < body[b].id; });
  std::vector<std::uint32_t> place(body.size());
  s.spheres.reserve(body.size());
  s.masses.reserve(body.size());
  s.bodies.reserve(body.size());
  for (std::uint32_t k = 0; k < s.index.size(); ++k) {
    const Parcel& p = body[s.index[k]];
    place[s.index[k]] = k;
    s.spheres.push_back({p.position, p.radius});
    s.masses.push_back(p.mass);
    s.bodies.push_back({p.position, p.velocity, p.spin, p.mass, inertia(p)});
  }
  const NearPairs& pairs = simulation.pairs();
  for (std::size_t slot = 0; slot < pairs.slots(); ++slot)
    if (pairs.touching[slot]) s.contacts.push_back({place[pairs.first[slot]], place[pairs.second[slot]]});
  const NearWalls& walls = simulation.walls();
  for (std::size_t slot = 0; slot < walls.slots(); ++slot)
    if (walls.touching[slot]) s.wall_contacts.push_back(place[walls.parcel[slot]]);
  return s;
}

std::vector<std::int32_t> contacts_of(const Sight& sight) {
  std::vector<std::int32_t> contacts(sight.spheres.size(), 0);
  for (const auto& c : sight.contacts) ++contacts[c.first], ++contacts[c.second];
  return contacts;
}

ForceSight forces_in(const Simulation& simulation, const Sight& sight) {
  const auto& body = simulation.state().parcels.body;
  const NearestImage nearest = NearestImage::of(simulation.model().domain);
  ForceSight forces;
  forces.pairs.reserve(sight.contacts.size());
  forces.walls.reserve(sight.wall_contacts.size());
  const NearPairs& pairs = simulation.pairs();
  for (std::size_t slot = 0; slot < pairs.slots(); ++slot) {
    if (!pairs.touching[slot]) continue;
    const measures::Contact& contact = sight.contacts[forces.pairs.size()];
    const Vec3 branch = nearest(body[pairs.first[slot]].position - body[pairs.second[slot]].position);
    forces.pairs.push_back({contact.first, contact.second, pairs.load[slot].force, branch});
  }
  const NearWalls& near = simulation.walls();
  const Walls& walls = simulation.model().walls;
  for (std::size_t slot = 0; slot < near.slots(); ++slot) {
    if (!near.touching[slot]) continue;
    const Pose& pose = simulation.pose(walls.surfaces[near.surface[slot]].body);
    const Vec3 at = pose.now.back(body[near.parcel[slot]].position);
    const Vec3 branch = pose.now.turn(-look(walls, near, slot, at).offset);
    forces.walls.push_back({sight.wall_contacts[forces.walls.size()], near.load[slot].force, branch});
  }
  return forces;
}

std::vector<double> normal_forces(const ForceSight& forces) {
  std::vector<double> list;
  list.reserve(forces.pairs.size());
  for (const measures::PairForce& pair : forces.pairs)
    list.push_back(dot(pair.force, pair.branch) / norm(pair.branch));
  return list;
}

}  // namespace pulvis
