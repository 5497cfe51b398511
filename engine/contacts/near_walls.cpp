// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/near_walls.hpp"

#include <algorithm>

#include "engine/base/parallel.hpp"
#include "engine/contacts/near_pairs.hpp"

namespace pulvis {

namespace {

/// What one thread finds, parcel after parcel.
struct Found {
  std::vector<std::uint32_t> surface, facets_end, facet;
};

/// One triangle near a parcel, to be gathered by patches.
struct NearFacet {
  std::uint32_t patch, triangle;
};

void find_shapes(const Walls& walls, std::span<const Pose> poses, const Vec3& position, double far,
                 std::span<const double> body_margin, Found& found) {
  for (std::uint32_t s = 0; s < walls.surfaces.size(); ++s) {
    const Surface& surface = walls.surfaces[s];
    if (surface.kind == Surface::Kind::patch || poses[surface.body].absent) continue;
    const double reach = far + body_margin[surface.body];
    const Vec3 at = poses[surface.body].now.back(position);
    const Vec3 d = nearest_point(surface, at).point - at;
    if (!(dot(d, d) < reach * reach)) continue;
    found.surface.push_back(s);
    found.facets_end.push_back(static_cast<std::uint32_t>(found.facet.size()));
  }
}

void find_patches(const FacetedWall& mesh, const Walls& walls, std::span<const Pose> poses,
                  const Vec3& position, double far, std::span<const double> body_margin,
                  std::vector<NearFacet>& near, Found& found) {
  const std::uint32_t body = walls.surfaces[mesh.first_surface].body;
  if (poses[body].absent) return;
  const double reach = far + body_margin[body];
  const Vec3 at = poses[body].now.back(position);
  near.clear();
  mesh.for_near(at, reach, [&](std::uint32_t triangle) {
    const Vec3 d = mesh.nearest(triangle, at).point - at;
    if (dot(d, d) < reach * reach) near.push_back({mesh.patch_of(triangle), triangle});
  });
  std::sort(near.begin(), near.end(), [](const NearFacet& a, const NearFacet& b) {
    return a.patch != b.patch ? a.patch < b.patch : a.triangle < b.triangle;
  });
  for (std::size_t k = 0; k < near.size(); ++k) {
    found.facet.push_back(near[k].triangle);
    if (k + 1 < near.size() && near[k + 1].patch == near[k].patch) continue;
    found.surface.push_back(mesh.first_surface + near[k].patch);
    found.facets_end.push_back(static_cast<std::uint32_t>(found.facet.size()));
  }
}

}  // namespace

void NearWalls::rebuild(const Parcels& parcels, const Walls& walls, std::span<const Pose> poses,
                        std::span<const double> margin, std::span<const double> body_margin, double reach,
                        int threads) {
  const std::size_t count = parcels.size();
  std::vector<Found> found(static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::size_t> share_begin(found.size(), count);
  begin.assign(count + 1, 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    auto& mine = found[static_cast<std::size_t>(thread)];
    std::vector<NearFacet> near;
    share_begin[static_cast<std::size_t>(thread)] = from;
    for (std::size_t i = from; i < to; ++i) {
      const Parcel& p = parcels.body[i];
      const double far = p.radius + margin[i] + reach;
      const std::size_t before = mine.surface.size();
      find_shapes(walls, poses, p.position, far, body_margin, mine);
      for (const FacetedWall& mesh : walls.meshes)
        find_patches(mesh, walls, poses, p.position, far, body_margin, near, mine);
      begin[i + 1] = static_cast<std::uint32_t>(mine.surface.size() - before);
    }
  });
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];

  const std::size_t slot_count = begin[count];
  surface.resize(slot_count);
  facet_begin_.assign(slot_count + 1, 0);
  facet_.clear();
  for (std::size_t t = 0; t < found.size(); ++t) {  // shares follow each other in the order of threads
    if (found[t].surface.empty()) continue;
    const std::uint32_t at = begin[share_begin[t]], facets_before = static_cast<std::uint32_t>(facet_.size());
    std::copy(found[t].surface.begin(), found[t].surface.end(), surface.begin() + at);
    for (std::size_t k = 0; k < found[t].facets_end.size(); ++k)
      facet_begin_[at + k + 1] = facets_before + found[t].facets_end[k];
    facet_.insert(facet_.end(), found[t].facet.begin(), found[t].facet.end());
  }
  parcel.resize(slot_count);
  for (std::size_t i = 0; i < count; ++i)
    std::fill(parcel.begin() + begin[i], parcel.begin() + begin[i + 1], static_cast<std::uint32_t>(i));
  touched_facet.assign(slot_count, no_facet);
  touching.assign(slot_count, 0);
  history.assign(slot_count, {});
  memory.assign(slot_count);
  load.assign(slot_count, {});
}

TouchingList NearWalls::pack() const {
  const std::size_t count = begin.empty() ? 0 : begin.size() - 1;
  TouchingList list;
  list.begin.assign(count + 1, 0);
  list.memory.used = memory.used;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
      if (touching[k]) {
        list.partner.push_back(surface[k]);
        list.history.push_back(history[k]);
        list.memory.append(memory, k);
      }
    list.begin[i + 1] = static_cast<std::uint32_t>(list.partner.size());
  }
  return list;
}

std::size_t NearWalls::restore(const TouchingList& list, std::span<const std::uint32_t> old_index) {
  std::size_t total = 0;
  for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
    if (old_index[i] == NearPairs::no_parcel) continue;
    for (std::uint32_t at = list.begin[old_index[i]]; at < list.begin[old_index[i] + 1]; ++at)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (surface[k] == list.partner[at]) {
          touching[k] = 1;
          history[k] = list.history[at];
          memory.copy(k, list.memory, at);
          ++total;
        }
  }
  return total;
}

void NearWalls::take_over_loads(const NearWalls& old, std::span<const std::uint32_t> old_index) {
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (!touching[slot]) continue;
    const std::uint32_t i = old_index[parcel[slot]];
    for (std::uint32_t k = old.begin[i]; k < old.begin[i + 1]; ++k)
      if (old.surface[k] == surface[slot]) load[slot] = old.load[k];
  }
}

}  // namespace pulvis
