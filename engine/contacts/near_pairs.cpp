// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/near_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "engine/base/failure.hpp"
#include "engine/base/parallel.hpp"

namespace pulvis {
namespace {

// Pairs closer than this share of their margins when the lists are made are expected to touch before the next time.
constexpr double close_share = 0.1;

struct Candidate {
  Vec3 position;
  double reach;        ///< radius + margin
  double close;        ///< radius + its share of the margin
  std::uint64_t name;  ///< id, then 2 index
};
constexpr std::uint64_t name_of(std::uint32_t id, std::uint32_t index) {
  return std::uint64_t{id} << 32 | 2 * index;
}

std::size_t group_of(const Parcels& parcels, const ContactClasses& classes, std::size_t i,
                     std::uint32_t partner) {
  return classes.index(parcels.body[i].species, parcels.body[partner >> 1].species) +
         (partner & 1u) * classes.all().size();
}

}  // namespace

void NearPairs::rebuild(const Parcels& parcels, const ContactClasses& classes, std::span<const double> margin,
                        double reach, const Box& box, const Slide& slide, int threads) {
  assign_slots(parcels, classes, search(parcels, margin, reach, box, slide, threads), threads);
  divide(threads);
  assign_places();
  meets.assign(parcels.size(), 0);
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
      const std::size_t start = slot / kernels::block_size * kernels::block_size;
      const std::uint32_t owner = std::min(first[start], second[start]);
      return owner < from || owner >= to;
    };
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1] && !divided_[i]; ++k)
        divided_[i] = of_other(entry[k] >> 1);
  });
  for (std::size_t i = 0; i < count; ++i)
    if (divided_[i]) divided_ones_.push_back(static_cast<std::uint32_t>(i));
}

/// Numbers the places of a share from 0, and returns how many there are. A place is given to another slot
/// once both parcels have been summed up; divided ones are so at the end of the step only.
std::uint32_t NearPairs::number_places(int part) {
  std::vector<std::size_t> cursors(groups());
  // Those of pairs apart are hardly used, and must not lie between the others.
  std::vector<std::uint32_t> free[2];
  std::uint32_t count = 0;
  const auto give = [&](std::size_t group, std::size_t start) {
    std::vector<std::uint32_t>& mine = free[are_apart(group)];
    for (std::size_t slot = start; slot < std::min(start + kernels::block_size, group_end[group]); ++slot) {
      if (mine.empty()) {
        place[slot] = count++;
      } else {
        place[slot] = mine.back();
        mine.pop_back();
      }
    }
  };
  const auto take_back = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (divided(i)) continue;
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) {
        const std::size_t slot = entry[k] >> 1, other = entry[k] & 1u ? first[slot] : second[slot];
        if (other < i && !divided(other)) free[slot >= first_apart()].push_back(place[slot]);
      }
    }
  };
  go_through(part, cursors, give, take_back);
  return count;
}

void NearPairs::assign_places() {
  place.assign(slots(), 0);
  std::vector<std::uint32_t> places_of(static_cast<std::size_t>(shares_));
  parallel_parts(shares_, [&](int part) { places_of[static_cast<std::size_t>(part)] = number_places(part); });
  std::uint32_t count = 0;
  // One between shares stays unused: of a load in the last place a sum reads one number too many.
  for (std::uint32_t& of_part : places_of) of_part = std::exchange(count, count + of_part + 1);
  parallel_parts(shares_, [&](int part) {
    std::vector<std::size_t> cursors(groups());
    const std::uint32_t before = places_of[static_cast<std::size_t>(part)];
    const auto shift = [&](std::size_t group, std::size_t start) {
      for (std::size_t slot = start; slot < std::min(start + kernels::block_size, group_end[group]); ++slot)
        place[slot] += before;
    };
    if (before > 0) go_through(part, cursors, shift, [](std::size_t, std::size_t) {});
  });
  load.assign(count + 1, {});
  summand.assign(entry.size() + kernels::summands_ahead, no_summand());
  parallel_shares(entry.size(), shares_, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t k = from; k < to; ++k)
      if (const std::size_t slot = entry[k] >> 1; slot < first_apart())
        summand[k] = 2 * place[slot] + (entry[k] & 1u);
  });
}

laws::History NearPairs::history(std::size_t slot) const {
  const kernels::Springs& s = springs[slot / kernels::block_size];
  const std::size_t k = slot % kernels::block_size;
  return {{s.slide.x[k], s.slide.y[k], s.slide.z[k]}, {s.roll.x[k], s.roll.y[k], s.roll.z[k]}};
}

void NearPairs::set_history(std::size_t slot, const laws::History& h) {
  kernels::Springs& s = springs[slot / kernels::block_size];
  const std::size_t k = slot % kernels::block_size;
  s.slide.x[k] = h.slide.x, s.slide.y[k] = h.slide.y, s.slide.z[k] = h.slide.z;
  s.roll.x[k] = h.roll.x, s.roll.y[k] = h.roll.y, s.roll.z[k] = h.roll.z;
}

void NearPairs::set_memory(std::size_t slot, const laws::Memory& from) {
  kernels::MemoryLanes& m = memory[slot / kernels::block_size];
  const std::size_t k = slot % kernels::block_size;
  m.plastic[k] = from.plastic, m.adhesion[k] = from.adhesion, m.grip[k] = from.grip;
}

laws::Memory NearPairs::memory_of(std::size_t slot) const {
  const kernels::MemoryLanes& m = memory[slot / kernels::block_size];
  const std::size_t k = slot % kernels::block_size;
  return {m.plastic[k], m.adhesion[k], m.grip[k]};
}

NearPairs::Partners NearPairs::search(const Parcels& parcels, std::span<const double> margin, double reach,
                                      const Box& box, const Slide& slide, int threads) {
  const std::size_t count = parcels.size();
  double widest = 0.0;
  for (std::size_t k = 0; k < count; ++k) widest = std::max(widest, parcels.body[k].radius + margin[k]);
  CellGrid grid;
  grid.build(box, 2.0 * widest + reach, count, [&](std::size_t k) { return parcels.body[k].position; });

  // Copied in the order of the cells, so that a scan reads memory forwards.
  const auto order = grid.order();
  std::vector<Candidate> candidate(count);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t k = from; k < to; ++k) {
      const Parcel& p = parcels.body[order[k]];
      const double m = margin[order[k]];
      candidate[k] = {p.position, p.radius + m, p.radius + close_share * m, name_of(p.id, order[k])};
    }
  });

  const Images nearest{NearestImage::of(box), slide};
  begin.assign(count + 1, 0);
  std::vector<std::vector<std::uint32_t>> found(static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::size_t> share_begin(found.size(), count);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    auto& mine = found[static_cast<std::size_t>(thread)];
    share_begin[static_cast<std::size_t>(thread)] = from;
    mine.reserve(7 * (to - from));
    std::vector<std::uint64_t> near;  // names of one parcel's partners, + 1 if they are apart
    for (std::size_t i = from; i < to; ++i) {
      const Vec3 position = parcels.body[i].position;
      const double radius = parcels.body[i].radius;
      const double own = radius + margin[i], own_close = radius + close_share * margin[i];
      const std::uint64_t name = name_of(parcels.body[i].id, static_cast<std::uint32_t>(i));
      std::size_t count_near = 0;
      grid.for_ranges_around(grid.cell_of(i), slide, [&](std::uint32_t first_k, std::uint32_t last_k) {
        if (near.size() < count_near + (last_k - first_k)) near.resize(2 * near.size() + (last_k - first_k));
        // Every one is written and most are overwritten: nobody can guess which candidates are near.
        for (std::uint32_t k = first_k; k < last_k; ++k) {
          const Candidate& c = candidate[k];
          const Vec3 d = nearest(c.position - position);
          const double far = (own + c.reach) + reach;  // the same bits seen from either parcel
          const double close = own_close + c.close + reach, square = dot(d, d);
          near[count_near] = c.name + static_cast<std::uint64_t>(!(square < close * close));
          count_near += static_cast<std::size_t>((square < far * far) & (c.name != name));
        }
      });
      std::sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count_near));  // by the ids
      for (std::size_t k = 0; k < count_near; ++k) mine.push_back(static_cast<std::uint32_t>(near[k]));
      begin[i + 1] = static_cast<std::uint32_t>(count_near);
    }
  });
  for (std::size_t i = 0; i < count; ++i) begin[i + 1] += begin[i];
  Partners partners(begin[count]);
  for (std::size_t t = 0; t < found.size(); ++t)
    if (!found[t].empty())
      std::copy(found[t].begin(), found[t].end(), partners.begin() + begin[share_begin[t]]);
  return partners;
}

/// Numbers the slots: by group, in it by the parcel that stands first in the store, so that slots follow the
/// store's order. Returns their number.
std::size_t NearPairs::count_slots(const Parcels& parcels, const ContactClasses& classes,
                                   const Partners& partners, int threads) {
  const std::size_t count = parcels.size(), group_count = 2 * classes.all().size();
  own_end_.assign(group_count * count, 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (const std::uint32_t j = partners[k] >> 1; j > i)
          ++own_end_[group_of(parcels, classes, i, partners[k]) * count + i];
  });
  std::size_t total = 0;
  group_begin.assign(group_count, 0);
  group_end.assign(group_count, 0);
  for (std::size_t g = 0; g < group_count; ++g) {
    constexpr std::size_t block = kernels::block_size;
    total = (total + block - 1) / block * block;
    group_begin[g] = total;
    for (std::size_t i = g * count; i < (g + 1) * count; ++i) {
      const std::uint32_t own = own_end_[i];
      own_end_[i] = static_cast<std::uint32_t>(total);
      total += own;
    }
    group_end[g] = total;
  }
  if (total >= (std::size_t{1} << 31))
    throw Failure(Exit::physics, "more than 2^31 pairs of parcels are near");
  return total;
}

void NearPairs::assign_slots(const Parcels& parcels, const ContactClasses& classes, const Partners& partners,
                             int threads) {
  const std::size_t count = parcels.size(), slot_count = count_slots(parcels, classes, partners, threads);
  const std::size_t block_count = (slot_count + kernels::block_size - 1) / kernels::block_size;
  first.assign(slot_count, 0);
  second.assign(slot_count, 0);
  touching.assign(slot_count, 0);
  force.clear();
  springs.assign(block_count, {});
  memory.assign(remembers ? block_count : 0, {});
  entry.assign(partners.size(), 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) {
        const std::uint32_t j = partners[k] >> 1;
        if (j < i) continue;
        const std::uint32_t slot = own_end_[group_of(parcels, classes, i, partners[k]) * count + i]++;
        const bool is_second = parcels.body[i].id > parcels.body[j].id;
        first[slot] = is_second ? j : static_cast<std::uint32_t>(i);
        second[slot] = is_second ? static_cast<std::uint32_t>(i) : j;
        entry[k] = 2 * slot + (is_second ? 1 : 0);
      }
  });
  // The other parcel looks its slot up in the list of the one that numbered it.
  std::atomic<bool> one_sided{false};
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i)
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k) {
        const std::uint32_t j = partners[k] >> 1;
        if (j > i) continue;
        const auto last = partners.begin() + begin[j + 1];
        const auto at = std::find_if(partners.begin() + begin[j], last,
                                     [i](std::uint32_t partner) { return partner >> 1 == i; });
        if (at == last)
          one_sided = true;
        else
          entry[k] = entry[static_cast<std::size_t>(at - partners.begin())] ^ 1u;
      }
  });
  if (one_sided) throw Failure(Exit::internal_check, "a near pair is listed by one of its parcels only");
}

TouchingList NearPairs::pack(const Parcels& parcels, int threads) const {
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
  list.memory.used = remembers;
  list.memory.assign(list.begin[count]);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int) {
    for (std::size_t i = from; i < to; ++i) {
      std::uint32_t at = list.begin[i];
      for (std::uint32_t k = begin[i]; k < begin[i + 1]; ++k)
        if (owned(k)) {
          const std::uint32_t slot = entry[k] >> 1;
          list.partner[at] = parcels.body[second[slot]].id;
          if (remembers) list.memory.list[at] = memory_of(slot);
          list.history[at++] = history(slot);
        }
    }
  });
  return list;
}

std::size_t NearPairs::restore(const TouchingList& list, std::span<const std::uint32_t> old_index,
                               const Parcels& parcels, int threads) {
  const std::size_t count = parcels.size();
  std::vector<std::size_t> found(static_cast<std::size_t>(std::max(threads, 1)), 0);
  parallel_shares(count, threads, [&](std::size_t from, std::size_t to, int thread) {
    std::size_t mine = 0;
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
          touching[slot] = 1;
          if (remembers && list.memory.used) set_memory(slot, list.memory.list[at]);
          set_history(slot, list.history[at++]);
          ++mine;
        }
      }
    }
    found[static_cast<std::size_t>(thread)] = mine;
  });
  std::size_t total = 0;
  for (const std::size_t n : found) total += n;
  return total;
}

void NearPairs::keep_forces(bool keep) {
  if (keep)
    force.assign(slots(), {});
  else
    force.clear();
}

void NearPairs::take_over_forces(const NearPairs& old, std::span<const std::uint32_t> old_index) {
  if (old.force.empty()) return;
  force.assign(slots(), {});
  for (std::size_t slot = 0; slot < slots(); ++slot) {
    if (!touching[slot]) continue;
    const std::uint32_t i = old_index[first[slot]], j = old_index[second[slot]];
    for (std::uint32_t k = old.begin[i]; k < old.begin[i + 1]; ++k)
      if (!(old.entry[k] & 1u) && old.second[old.entry[k] >> 1] == j)
        force[slot] = old.force[old.entry[k] >> 1];
  }
}

}  // namespace pulvis
