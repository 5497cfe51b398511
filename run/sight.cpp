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
  // In the order of ids, not of slots, which rebuilds change: sums over contacts must not.
  const NearPairs& pairs = simulation.pairs();
  for (const std::uint32_t k : s.index)
    for (std::uint32_t e = pairs.begin[k]; e < pairs.begin[k + 1]; ++e) {
      const std::uint32_t slot = pairs.entry[e] / 2;
      if (pairs.first[slot] != k || !pairs.touching[slot]) continue;
      s.contacts.push_back({place[k], place[pairs.second[slot]]});
      s.contact_slots.push_back(slot);
    }
  const NearWalls& walls = simulation.walls();
  for (const std::uint32_t slot : simulation.wall_slots_by_id()) {
    if (!walls.touching[slot]) continue;
    s.wall_contacts.push_back(place[walls.parcel[slot]]);
    s.wall_slots.push_back(slot);
  }
  return s;
}

std::vector<std::int32_t> contacts_of(const Sight& sight) {
  std::vector<std::int32_t> contacts(sight.spheres.size(), 0);
  for (const auto& c : sight.contacts) ++contacts[c.first], ++contacts[c.second];
  return contacts;
}

ForceSight forces_in(const Simulation& simulation, const Sight& sight) {
  const auto& body = simulation.state().parcels.body;
  const Images& nearest = simulation.images();
  ForceSight forces;
  forces.pairs.reserve(sight.contacts.size());
  forces.walls.reserve(sight.wall_contacts.size());
  const NearPairs& pairs = simulation.pairs();
  for (std::size_t c = 0; c < sight.contacts.size(); ++c) {
    const std::uint32_t slot = sight.contact_slots[c];
    const Vec3 branch = nearest(body[pairs.first[slot]].position - body[pairs.second[slot]].position);
    forces.pairs.push_back(
        {sight.contacts[c].first, sight.contacts[c].second, pairs.force_on_first(slot), branch});
  }
  const NearWalls& near = simulation.walls();
  const Walls& walls = simulation.model().walls;
  for (std::size_t c = 0; c < sight.wall_contacts.size(); ++c) {
    const std::uint32_t slot = sight.wall_slots[c];
    const Pose& pose = simulation.pose(walls.surfaces[near.surface[slot]].body);
    const Vec3 at = pose.now.back(body[near.parcel[slot]].position);
    const Vec3 branch = pose.now.turn(-look(walls, near, slot, at).offset);
    forces.walls.push_back({sight.wall_contacts[c], near.load[slot].force, branch});
  }
  return forces;
}

}  // namespace pulvis
