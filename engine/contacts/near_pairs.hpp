// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/contacts/cell_grid.hpp"
#include "engine/contacts/contact_classes.hpp"
#include "engine/contacts/touching.hpp"
#include "engine/kernels/parcel_block.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

using kernels::PairLoad;

/// Pairs of parcels that touch or could before the next rebuild. Each pair has one slot, which holds its
/// history; each parcel has a list of its slots, sorted by the partner's id, so that sums run in
/// the same order whatever the lists contain besides. Slots of one group lie together and each group begins a new
/// block of the kernels, so that blocks of slots are evaluated where they stand; slots that only fill a block up
/// belong to no entry and never touch. A contact class has two groups: pairs that touched or nearly did when the lists
/// were made, and pairs apart, whose blocks mostly need no more than a look at their distances.
class NearPairs {
 public:
  static constexpr std::uint32_t no_parcel = 0xffffffffu;
  static constexpr std::size_t parcels_at_once =
      512;  ///< what they need of each other stays in the second cache

  /// Finds all pairs closer than margin_i + margin_j + reach. `margin` is per parcel, m; `reach` covers
  /// contacts that hold beyond touching. Forgets all contacts: see `restore`.
  void rebuild(const Parcels& parcels, const ContactClasses& classes, std::span<const double> margin,
               double reach, const Box& box, const Slide& slide, int threads);

  /// The contacts that touch now.
  TouchingList pack(const Parcels& parcels, int threads) const;

  /// Puts contacts back after a rebuild. `old_index[k]` is where the k-th parcel stood in `list` (no_parcel:
  /// it is new). Returns how many contacts found their slot.
  std::size_t restore(const TouchingList& list, std::span<const std::uint32_t> old_index,
                      const Parcels& parcels, int threads);

  /// Takes the forces of the contacts that touch over from the lists before a rebuild, where each parcel stood
  /// at `old_index`, so that they can still be asked for before the next evaluation.
  void take_over_forces(const NearPairs& old, std::span<const std::uint32_t> old_index);

  std::size_t slots() const { return first.size(); }
  bool is_pair(std::size_t slot) const { return first[slot] != second[slot]; }  ///< and no mere filling

  std::size_t class_of(std::size_t group) const { return group % (group_begin.size() / 2); }
  bool are_apart(std::size_t group) const { return group >= group_begin.size() / 2; }
  std::size_t first_apart() const { return group_begin[group_begin.size() / 2]; }  ///< slot

  /// End of the slots of a group that belong to the parcels up to `parcel` in the order of the store. A slot belongs to
  /// that of its two parcels which stands first.
  std::size_t slot_end(std::size_t group, std::size_t parcel) const {
    return own_end_[group * (begin.size() - 1) + parcel];
  }
  /// The first block that begins with a slot of `parcel` or of one behind it.
  std::size_t first_block(std::size_t group, std::size_t parcel) const {
    constexpr std::size_t block = kernels::block_size;
    const std::size_t slot = parcel == 0 ? group_begin[group] : slot_end(group, parcel - 1);
    return (slot + block - 1) / block * block;
  }

  // Shares of the parcels that threads work on, each with the blocks that begin with a slot of its parcels.
  int shares() const { return shares_; }
  std::pair<std::size_t, std::size_t> share(int part) const {
    const std::size_t count = begin.size() - 1, k = static_cast<std::size_t>(part),
                      n = static_cast<std::size_t>(shares_);
    return {count * k / n, count * (k + 1) / n};
  }
  /// Whether a slot of the parcel lies in a block of another share.
  bool divided(std::size_t parcel) const { return shares_ > 1 && divided_[parcel]; }
  /// Those of all shares, in as many equal parts as there are shares.
  std::span<const std::uint32_t> divided_ones(int part) const {
    const std::size_t count = divided_ones_.size(), k = static_cast<std::size_t>(part),
                      n = static_cast<std::size_t>(shares_);
    return std::span(divided_ones_).subspan(count * k / n, count * (k + 1) / n - count * k / n);
  }
  laws::History history(std::size_t slot) const;
  void set_history(std::size_t slot, const laws::History& history);

  /// Goes through the share `part` as every step does: calls `block(group, slot)` for each block of 64 slots, beginning
  /// with `slot`, that parcels need before `parcels(from, to)` is called for them. `cursors`: one per group.
  template <class Block, class OfParcels>
  void go_through(int part, std::vector<std::size_t>& cursors, Block&& block, OfParcels&& parcels) const {
    const auto [from, to] = share(part);
    for (std::size_t g = 0; g < cursors.size(); ++g) cursors[g] = first_block(g, from);
    for (std::size_t start = from; start < to; start += parcels_at_once) {
      const std::size_t end = std::min(to, start + parcels_at_once);
      for (std::size_t g = 0; g < cursors.size(); ++g)
        for (; cursors[g] < slot_end(g, end - 1); cursors[g] += kernels::block_size) block(g, cursors[g]);
      parcels(start, end);
    }
  }
  std::size_t groups() const { return group_begin.size(); }

  /// Force on the first of a pair at the end of the last step, N, if that kept the forces; else zero.
  Vec3 force_on_first(std::size_t slot) const { return force.empty() ? Vec3{} : force[slot]; }
  std::uint32_t no_summand() const { return static_cast<std::uint32_t>(2 * (load.size() - 1)); }
  /// Forgets the forces, and says whether the step that comes shall keep its own.
  void keep_forces(bool keep);

  // Per slot. The first has the lower id.
  std::vector<std::uint32_t> first, second;
  std::vector<std::uint8_t> touching;
  std::vector<std::uint32_t> place;  ///< where its load lies while it is needed
  std::vector<Vec3> force;           ///< empty where nobody asked for them

  /// In places. A load is needed until both parcels have been summed up; then another contact takes its place, so that
  /// there are about as many as a slice or two of the powder has pairs. The last is always zero.
  std::vector<PairLoad> load;

  // Per block of slots.
  std::vector<kernels::Springs> springs;
  std::vector<kernels::MemoryLanes> memory;  ///< empty unless `remembers`
  bool remembers = false;                    ///< to be set before the first rebuild

  // Per group: its slots are [group_begin[g], group_end[g]). The close ones of each class come first.
  std::vector<std::size_t> group_begin, group_end;

  // Per parcel: entries [begin[k], begin[k + 1]) of `entry`, partners' ids ascending.
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> entry;  ///< 2 slot + (1 if the parcel is the second)
  std::vector<std::uint32_t>
      summand;  ///< the same with places for slots, no_summand() for pairs apart; some more at the end
  std::vector<std::uint8_t> meets;  ///< touches one of those that were apart, in this step

 private:
  /// Per entry: 2 index of the partner (+ 1 if they are apart).
  using Partners = std::vector<std::uint32_t>;
  Partners search(const Parcels& parcels, std::span<const double> margin, double reach, const Box& box,
                  const Slide& slide, int threads);
  void assign_slots(const Parcels& parcels, const ContactClasses& classes, const Partners& partners,
                    int threads);
  std::size_t count_slots(const Parcels& parcels, const ContactClasses& classes, const Partners& partners,
                          int threads);
  void divide(int threads);
  void assign_places();
  std::uint32_t number_places(int part);
  laws::Memory memory_of(std::size_t slot) const;
  void set_memory(std::size_t slot, const laws::Memory& memory);

  std::vector<std::uint32_t> own_end_;  ///< [group * parcels + parcel]
  int shares_ = 1;
  std::vector<std::uint8_t> divided_;
  std::vector<std::uint32_t> divided_ones_;
};

}  // namespace pulvis
