// SPDX-License-Identifier: Apache-2.0
#include "run/overlaps.hpp"

#include <algorithm>

#include "engine/contacts/wall_sight.hpp"

namespace pulvis {
namespace {

/// Largest overlap of a pair over the smaller radius.
double pair_overlap_ratio(const Simulation& simulation) {
  const NearPairs& pairs = simulation.pairs();
  const Images& nearest = simulation.images();
  double largest = 0.0;
  for (std::size_t s = 0; s < pairs.slots(); ++s) {
    if (!pairs.touching[s]) continue;
    const Parcel& p = simulation.state().parcels.body[pairs.first[s]];
    const Parcel& q = simulation.state().parcels.body[pairs.second[s]];
    const double overlap = p.radius + q.radius - norm(nearest(q.position - p.position));
    largest = std::max(largest, overlap / std::min(p.radius, q.radius));
  }
  return largest;
}

/// Largest overlap of a parcel with a wall over its radius.
double wall_overlap_ratio(const Simulation& simulation) {
  const NearWalls& walls = simulation.walls();
  double largest = 0.0;
  for (std::size_t s = 0; s < walls.slots(); ++s) {
    if (!walls.touching[s]) continue;
    const Parcel& p = simulation.state().parcels.body[walls.parcel[s]];
    const Walls& all = simulation.model().walls;
    const Pose& pose = simulation.pose(all.surfaces[walls.surface[s]].body);
    const double overlap = p.radius - look(all, walls, s, pose.now.back(p.position)).distance;
    largest = std::max(largest, overlap / p.radius);
  }
  return largest;
}

}  // namespace

double largest_overlap_ratio(const Simulation& simulation) {
  return std::max(pair_overlap_ratio(simulation), wall_overlap_ratio(simulation));
}

}  // namespace pulvis
