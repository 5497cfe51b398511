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

}  // namespace pulvis
