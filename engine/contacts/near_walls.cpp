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

/// What is near one parcel. A body's margin counts `body_margins` times, a parcel's at least `radii` of its radius.
class LookFromParcel {
 public:
  LookFromParcel(const WallSearch& wanted, double body_margins, double radii)
      : wanted_(wanted), body_margins_(body_margins), radii_(radii) {}

  void look(std::size_t parcel, Found& found) {
    const double radius = wanted_.parcels.body[parcel].radius;
    position_ = wanted_.parcels.body[parcel].position;
    far_ = radius + std::max(wanted_.margin[parcel], radii_ * radius) + wanted_.reach;
    crowd_ = wanted_.crowd[parcel];
    find_shapes(found);
    for (const FacetedWall& mesh : wanted_.walls.meshes) find_patches(mesh, found);
  }

 private:
  double reach_to(std::uint32_t body) const {
    const double between = wanted_.body_crowd[body] != crowd_ ? wanted_.between_crowds : 0.0;
    return far_ + body_margins_ * wanted_.body_margin[body] + between;
  }

  void find_shapes(Found& found) const {
    for (std::uint32_t s = 0; s < wanted_.walls.surfaces.size(); ++s) {
      const Surface& surface = wanted_.walls.surfaces[s];
      if (surface.kind == Surface::Kind::patch || wanted_.poses[surface.body].absent) continue;
      const double reach = reach_to(surface.body);
      const Vec3 at = wanted_.poses[surface.body].now.back(position_);
      const Vec3 d = nearest_point(surface, at).point - at;
      if (!(dot(d, d) < reach * reach)) continue;
      found.surface.push_back(s);
      found.facets_end.push_back(static_cast<std::uint32_t>(found.facet.size()));
    }
  }

  void find_patches(const FacetedWall& mesh, Found& found) {
    const std::uint32_t body = wanted_.walls.surfaces[mesh.first_surface].body;
    if (wanted_.poses[body].absent) return;
    const double reach = reach_to(body);
    const Vec3 at = wanted_.poses[body].now.back(position_);
    near_.clear();
    mesh.for_near(at, reach, [&](std::uint32_t triangle) {
      const Vec3 d = mesh.nearest(triangle, at).point - at;
      if (dot(d, d) < reach * reach) near_.push_back({mesh.patch_of(triangle), triangle});
    });
    std::sort(near_.begin(), near_.end(), [](const NearFacet& a, const NearFacet& b) {
      return a.patch != b.patch ? a.patch < b.patch : a.triangle < b.triangle;
    });
    for (std::size_t k = 0; k < near_.size(); ++k) {
      found.facet.push_back(near_[k].triangle);
      if (k + 1 < near_.size() && near_[k + 1].patch == near_[k].patch) continue;
      found.surface.push_back(mesh.first_surface + near_[k].patch);
      found.facets_end.push_back(static_cast<std::uint32_t>(found.facet.size()));
    }
  }

  const WallSearch& wanted_;
  double body_margins_, radii_;
  Vec3 position_;
  double far_ = 0.0;
  std::uint8_t crowd_ = 0;
  std::vector<NearFacet> near_;
};

}  // namespace

void NearWalls::rebuild(const WallSearch& wanted, int threads) {
  const std::size_t count = wanted.parcels.size();
  std::vector<Found> found(static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::size_t> share_begin(found.size(), count);
  begin.assign(count + 1, 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    auto& mine = found[static_cast<std::size_t>(thread)];
    // More than margins ask for, so that lists of walls are still good for most that leave theirs.
    LookFromParcel looker(wanted, 1.0, 0.5);
    share_begin[static_cast<std::size_t>(thread)] = from;
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t before = mine.surface.size();
      looker.look(i, mine);
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

bool NearWalls::would_miss(std::uint32_t parcel_index, const WallSearch& wanted) const {
  Found found;
  // A body may be at one end of its margin now, and go to the other.
  LookFromParcel(wanted, 2.0, 0.0).look(parcel_index, found);
  const auto own_begin = surface.begin() + begin[parcel_index],
             own_end = surface.begin() + begin[parcel_index + 1];
  std::uint32_t facets_from = 0;
  for (std::size_t k = 0; k < found.surface.size(); facets_from = found.facets_end[k++]) {
    const auto own = std::find(own_begin, own_end, found.surface[k]);
    if (own == own_end) return true;
    const std::span<const std::uint32_t> listed = facets(static_cast<std::size_t>(own - surface.begin()));
    if (!std::includes(listed.begin(), listed.end(), found.facet.begin() + facets_from,
                       found.facet.begin() + found.facets_end[k]))
      return true;
  }
  return false;
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
