// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/near_pairs.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/failure.hpp"
#include "engine/base/parallel.hpp"

namespace pulvis {

void NearPairs::rebuild(const PairSearch& wanted, int threads) {
  const std::vector<FoundPair> pairs = find_pairs(wanted, threads);
  assign_slots(wanted.parcels, wanted.classes.all().size(), pairs, threads);
  first_late_ = slots();
  waiting_.clear();
  divide(threads);
  const std::size_t close = group_begin.empty() ? 0 : group_begin[group_begin.size() / 2];
  pasts.reset(close, slots() - close, first.capacity() - slots(), shares_);
  assign_places();
  keep_forces(false);
  meets.assign(wanted.parcels.size(), 0);
}

/// The parcel to which the first slot of a slot's block belongs: its share evaluates the block.
std::uint32_t NearPairs::owner_of_block(std::size_t slot) const {
  const std::size_t start = slot / kernels::block_size * kernels::block_size;
  return std::min(first[start], second[start]);
}

void NearPairs::divide(int threads) {
  const std::size_t count = begin.size() - 1;
  shares_ = count < too_few_for_threads ? 1 : std::max(threads, 1);
  divided_.assign(shares_ > 1 ? count : 0, 0);
  divided_ones_.clear();
  if (shares_ == 1) return;
  parallel_parts(shares_, [&](int part) {
    const auto [from, to] = share(part);
    const auto of_other = [&, from = from, to = to](std::uint32_t slot) {
      const std::uint32_t owner = owner_of_block(slot);
      return owner < from || owner >= to;
    };
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1] && !divided_[i]; ++k)
        divided_[i] = of_other(entry[k] >> 1);
  });
  for (std::size_t i = 0; i < count; ++i)
    if (divided_[i]) divided_ones_.push_back(static_cast<std::uint32_t>(i));
}

/// For each parcel of a share, the first of the parcels that are not summed up yet when the first of its loads is made.
std::vector<std::size_t> NearPairs::begins_of_runs(int part) const {
  const auto [from, to] = share(part);
  std::vector<std::size_t> begins(to - from, to);
  std::size_t done = from;
  const auto note = [&, from = from, to = to](std::size_t parcel) {
    if (parcel >= from && parcel < to) begins[parcel - from] = std::min(begins[parcel - from], done);
  };
  std::vector<std::size_t> cursors(groups());
  go_through(
      part, cursors,
      [&](std::size_t group, std::size_t slots_from, std::size_t slots_to) {
        if (are_apart(group)) return;
        for (std::size_t slot = slots_from; slot < slots_to; ++slot) note(first[slot]), note(second[slot]);
      },
      [&](std::size_t, std::size_t end) { done = end; });
  return begins;
}

/// Runs that are needed while fewer parcels than this are summed up go round in a ring, the others in another, so that both
/// together have about the fewest loads: most runs are needed for a slice of the powder, some across a periodic boundary longer.
std::size_t NearPairs::longest_way_round(int part, std::span<const std::size_t> begins) const {
  constexpr std::size_t step = parcels_at_once / 8;
  const auto [from, to] = share(part);
  struct OfWay {
    double loads = 0.0, ring = 0.0;  ///< of runs with this way, and what all runs that begin meanwhile have
  };
  std::vector<OfWay> ways((to - from) / step + 1);
  std::vector<std::uint32_t> before{0};
  double whole_ring = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    const std::uint32_t own = divided(i) ? 0 : runs[i].count;
    before.push_back(before.back() + own);
    if (own == 0) continue;
    OfWay& way = ways[(i - begins[i - from]) / step];
    way.loads += own;
    way.ring = std::max<double>(way.ring, before.back() - before[begins[i - from] - from]);
    whole_ring = std::max(whole_ring, way.ring);
  }
  std::size_t best = to - from + 1;
  double loads = 0.0, ring = 0.0, fewest = whole_ring * before.back();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    loads += ways[k].loads, ring = std::max(ring, ways[k].ring);
    const double both = ring * loads + whole_ring * (before.back() - loads);
    if (both < fewest) fewest = both, best = (k + 1) * step;
  }
  return best;
}

/// Lays out the runs of a share from 0 on, and returns how many loads that takes. Runs go round in two rings, in the order of the
/// store, each as long as ever is needed at the same time; one that begins in its ring may end behind it. Those of divided
/// parcels, which are summed up at the end of the step only, have places of their own.
std::uint32_t NearPairs::lay_out_runs(int part) {
  const auto [from, to] = share(part);
  const std::vector<std::size_t> begins = begins_of_runs(part);
  const std::size_t most = longest_way_round(part, begins);
  struct Ring {
    std::uint32_t longest = 0, length = 1;
    std::vector<std::uint32_t> before{0};  ///< loads of its runs, by the parcel
  };
  Ring rings[2];
  const auto ring_of = [&, from = from](std::size_t i) { return i < begins[i - from] + most ? 0 : 1; };
  std::uint32_t end = 0;
  for (std::size_t i = from; i < to; ++i) {
    const std::uint32_t own = runs[i].count;
    for (Ring& ring : rings) ring.before.push_back(ring.before.back());
    if (divided(i)) {
      runs[i].begin = std::exchange(end, end + own);
    } else if (own > 0) {
      Ring& ring = rings[ring_of(i)];
      ring.before.back() += own;
      ring.longest = std::max(ring.longest, own);
      ring.length = std::max(ring.length, ring.before.back() - ring.before[begins[i - from] - from]);
    }
  }
  for (int k = 0; k < 2; ++k) {
    for (std::size_t i = from; i < to; ++i)
      if (!divided(i) && ring_of(i) == k) runs[i].begin = end + rings[k].before[i - from] % rings[k].length;
    end += rings[k].length + rings[k].longest;
  }
  return end;
}

void NearPairs::assign_places() {
  const std::size_t count = begin.size() - 1;
  const auto is_close = [&](std::uint32_t k) { return (entry[k] >> 1) < first_apart(); };
  runs.assign(count, {});
  parallel_shares(count, shares_, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) runs[i].count += is_close(k);
  });
  std::vector<std::uint32_t> before(static_cast<std::size_t>(shares_));
  parallel_parts(shares_, [&](int part) { before[static_cast<std::size_t>(part)] = lay_out_runs(part); });
  std::size_t loads = 0;
  for (std::uint32_t& of_part : before)
    of_part = static_cast<std::uint32_t>(std::exchange(loads, loads + of_part));
  if (loads * kernels::Places::numbers > UINT32_MAX)
    throw Failure(Exit::physics,
                  "more than 700 million loads of contacts are needed at a time; that is too many");
  load.assign(loads, {});
  places.assign(first_apart(), {});
  parallel_parts(shares_, [&](int part) {
    const auto [from, to] = share(part);
    for (std::size_t i = from; i < to; ++i) {
      std::uint32_t at = runs[i].begin += before[static_cast<std::size_t>(part)];
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (is_close(k))
          (entry[k] & 1u ? places[entry[k] >> 1].second : places[entry[k] >> 1].first) =
              kernels::Places::numbers * at++;
    }
  });
}

int NearPairs::part_of(std::size_t slot) const {
  if (slot >= first_late_)
    return static_cast<int>((slot - first_late_) / kernels::block_size % static_cast<std::size_t>(shares_));
  int part = 0;
  while (owner_of_block(slot) >= share(part).second) ++part;
  return part;
}

void NearPairs::set_past(std::size_t slot, const laws::Past& past) {
  if (slot < first_apart())
    pasts.put_close(slot, past);
  else
    pasts.met.put(slot - first_apart(), {past, {}}, part_of(slot));
}

/// Each parcel's list of pairs, by the partners' ids; `begin` says where each starts. Every thread goes through all pairs and
/// writes down those of its own parcels.
std::vector<NearPairs::Listed> NearPairs::list_pairs(const Parcels& parcels, std::span<const FoundPair> pairs,
                                                     int threads) {
  const std::size_t count = parcels.size();
  begin.assign(count + 1, 0);
  const auto of_share = [&](auto&& note) {
    parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
      for (std::uint32_t p = 0; p < pairs.size(); ++p) {
        const std::size_t i = pairs[p].first, j = pairs[p].second;
        if (i >= from && i < to) note(i, j, p);
        if (j >= from && j < to) note(j, i, p);
      }
    });
  };
  of_share([&](std::size_t i, std::size_t, std::uint32_t) { ++begin[i + 1]; });
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1), id(count);
  for (std::size_t i = 0; i < count; ++i) id[i] = parcels.body[i].id;
  std::vector<Listed> listed(begin[count]);
  of_share([&](std::size_t i, std::size_t j, std::uint32_t p) { listed[next[i]++] = {p, id[j]}; });
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      std::sort(listed.begin() + begin[i], listed.begin() + begin[i + 1],
                [](const Listed& a, const Listed& b) { return a.partner_id < b.partner_id; });
  });
  return listed;
}

/// Numbers the slots: by group, in it by the parcel that stands first in the store, so that slots follow the
/// store's order. Returns their number.
std::size_t NearPairs::count_slots(std::size_t class_count, std::span<const FoundPair> pairs,
                                   std::span<const Listed> listed, int threads) {
  const std::size_t count = begin.size() - 1, group_count = 2 * class_count;
  std::vector<std::size_t> in_group(group_count, 0);
  for (const FoundPair& p : pairs) ++in_group[p.group];
  row_.assign(group_count, 0);
  std::size_t rows = 0;
  for (std::size_t g = 0; g < group_count; ++g)
    if (in_group[g] > 0) row_[g] = rows++ * count;
  own_end_.assign(rows * count, 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (const FoundPair& p = pairs[listed[k].pair]; std::min(p.first, p.second) == i)
          ++own_end_[row_[p.group] + i];
  });
  std::size_t total = 0;
  group_begin.assign(group_count, 0);
  group_end.assign(group_count, 0);
  for (std::size_t g = 0; g < group_count; ++g) {
    constexpr std::size_t block = kernels::block_size;
    total = (total + block - 1) / block * block;
    group_begin[g] = total;
    for (std::size_t i = row_[g]; in_group[g] > 0 && i < row_[g] + count; ++i) {
      const std::uint32_t own = own_end_[i];
      own_end_[i] = static_cast<std::uint32_t>(total);
      total += own;
    }
    group_end[g] = total;
  }
  return total;
}

void NearPairs::assign_slots(const Parcels& parcels, std::size_t class_count,
                             std::span<const FoundPair> pairs, int threads) {
  // An entry is 2 slot + 1 in 32 bits, and every group fills up to a block.
  if (pairs.size() >= (std::size_t{1} << 31) - 2 * class_count * kernels::block_size)
    throw Failure(Exit::physics, "about 2^31 pairs of parcels are near; that is too many");
  const std::vector<Listed> listed = list_pairs(parcels, pairs, threads);
  const std::size_t count = parcels.size(), slot_count = count_slots(class_count, pairs, listed, threads);
  const std::size_t room = slot_count + slot_count / 32 + 64;  // for those that come late
  first.reserve(room), second.reserve(room), touching.reserve(room);
  first.assign(slot_count, 0);
  second.assign(slot_count, 0);
  touching.assign(slot_count, 0);
  entry.assign(listed.size(), 0);
  std::vector<std::uint32_t> slot_of(pairs.size());
  // First the parcels that own the slots, then their partners, which look them up.
  for (const bool owners : {true, false})
    parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
      for (std::size_t i = from; i < to; ++i)
        for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) {
          const FoundPair& p = pairs[listed[k].pair];
          const std::uint32_t own = std::min(p.first, p.second), partner = std::max(p.first, p.second);
          if ((own == i) != owners) continue;
          std::uint32_t& slot = slot_of[listed[k].pair];
          const bool is_second = parcels.body[i].id > listed[k].partner_id;
          if (owners) {
            slot = own_end_[row_[p.group] + i]++;
            first[slot] = is_second ? partner : own;
            second[slot] = is_second ? own : partner;
          }
          entry[k] = 2 * slot + is_second;
        }
    });
}

TouchingList NearPairs::pack(const Parcels& parcels, int threads) const {
  if (!waiting_.empty())
    throw Failure(Exit::internal_check,
                  "contacts were asked for while some of them still wait for their place");
  const std::size_t count = begin.empty() ? 0 : begin.size() - 1;
  TouchingList list;
  list.begin.assign(count + 1, 0);
  const auto owned = [&](std::uint32_t k) { return (entry[k] & 1u) == 0 && touching[entry[k] >> 1]; };
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (owned(k)) ++list.begin[i + 1];
  });
  for (std::size_t i = 0; i < count; ++i) list.begin[i + 1] += list.begin[i];
  list.partner.resize(list.begin[count]);
  list.history.resize(list.begin[count]);
  list.memory.used = pasts.remembers;
  list.memory.assign(list.begin[count]);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) {
      std::uint32_t at = list.begin[i];
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (owned(k)) {
          const std::uint32_t slot = entry[k] >> 1;
          list.partner[at] = parcels.body[second[slot]].id;
          put_past_at(list.history, list.memory, at++, pasts.of(slot));
        }
    }
  });
  return list;
}

std::size_t NearPairs::restore(const TouchingList& list, std::span<const std::uint32_t> old_index,
                               const Parcels& parcels, int threads) {
  const std::size_t count = parcels.size();
  struct Found {
    std::size_t count = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> apart;  ///< slots, and where they stand in the list
  };
  std::vector<Found> found(static_cast<std::size_t>(std::max(threads, 1)));
  const auto put_back = [&](std::uint32_t slot, std::uint32_t at) {
    touching[slot] = 1;
    set_past(slot, past_at(list.history, list.memory, at));
  };
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    Found mine;
    for (std::size_t i = from; i < to; ++i) {
      if (old_index[i] == no_parcel) continue;
      // Both lists ascend in the partner's id: one pass over both.
      std::uint32_t at = list.begin[old_index[i]];
      const std::uint32_t end = list.begin[old_index[i] + 1];
      for (std::uint32_t k = begin[i]; k < begin[i + 1] && at < end; ++k) {
        if (entry[k] & 1u) continue;
        const std::uint32_t slot = entry[k] >> 1, id = parcels.body[second[slot]].id;
        while (at < end && list.partner[at] < id) ++at;
        if (at < end && list.partner[at] == id) {
          if (slot < first_apart())
            put_back(slot, at);
          else
            mine.apart.push_back({slot, at});
          ++at, ++mine.count;
        }
      }
    }
    found[static_cast<std::size_t>(thread)] = std::move(mine);
  });
  std::size_t total = 0;
  for (const Found& of_thread : found) {
    total += of_thread.count;
    // By this thread alone: the part that such a pair belongs to may be another than the one that found it.
    for (const auto& [slot, at] : of_thread.apart) put_back(slot, at);
  }
  return total;
}

Vec3 NearPairs::force_on_first(std::size_t slot) const {
  if (!forces_kept_) return {};
  if (slot < first_apart()) return force[slot];
  const MetPairs::Contact* contact = pasts.met_at(slot);
  return contact ? contact->load.force : Vec3{};
}

void NearPairs::keep_forces(bool keep) {
  forces_kept_ = keep;
  force.assign(keep ? first_apart() : 0, {});
}

void NearPairs::take_over_forces(const NearPairs& old, std::span<const std::uint32_t> old_index) {
  if (!old.forces_kept_) return;
  keep_forces(true);
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (!touching[slot]) continue;
    Vec3 on_first;
    const std::uint32_t i = old_index[first[slot]], j = old_index[second[slot]];
    for (std::uint32_t k = old.begin[i]; k < old.begin[i + 1]; ++k)
      if (!(old.entry[k] & 1u) && old.second[old.entry[k] >> 1] == j)
        on_first = old.force_on_first(old.entry[k] >> 1);
    if (slot < first_apart())
      force[slot] = on_first;
    else
      pasts.met.put(slot - first_apart(), {pasts.of(slot), {on_first, {}, {}}}, part_of(slot));
  }
}

}  // namespace pulvis
