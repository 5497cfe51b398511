// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/near_walls.hpp"

#include <algorithm>

#include "engine/base/parallel.hpp"
#include "engine/contacts/near_pairs.hpp"

namespace pulvis {

void NearWalls::rebuild(const Parcels& parcels, std::span<const Surface> surfaces,
                        std::span<const Pose> poses, std::span<const double> margin,
                        std::span<const double> body_margin, double reach, int threads) {
  const std::size_t count = parcels.size();
  std::vector<std::vector<std::uint32_t>> found(static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::size_t> share_begin(found.size(), count);
  begin.assign(count + 1, 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    auto& mine = found[static_cast<std::size_t>(thread)];
    share_begin[static_cast<std::size_t>(thread)] = from;
    for (std::size_t i = from; i < to; ++i) {
      const Parcel& p = parcels.body[i];
      for (std::size_t s = 0; s < surfaces.size(); ++s) {
        const double far = p.radius + margin[i] + body_margin[surfaces[s].body] + reach;
        const Vec3 at = p.position - poses[surfaces[s].body].now;
        const Vec3 d = nearest_point(surfaces[s], at).point - at;
        if (dot(d, d) < far * far) mine.push_back(static_cast<std::uint32_t>(s)), ++begin[i + 1];
      }
    }
  });
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];

  const std::size_t slot_count = begin[count];
  surface.resize(slot_count);
  for (std::size_t t = 0; t < found.size(); ++t)
    if (!found[t].empty())
      std::copy(found[t].begin(), found[t].end(), surface.begin() + begin[share_begin[t]]);
  parcel.resize(slot_count);
  for (std::size_t i = 0; i < count; ++i)
    std::fill(parcel.begin() + begin[i], parcel.begin() + begin[i + 1], static_cast<std::uint32_t>(i));
  touching.assign(slot_count, 0);
  history.assign(slot_count, {});
  load.assign(slot_count, {});
}

TouchingList NearWalls::pack() const {
  const std::size_t count = begin.empty() ? 0 : begin.size() - 1;
  TouchingList list;
  list.begin.assign(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
      if (touching[k]) {
        list.partner.push_back(surface[k]);
        list.history.push_back(history[k]);
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
