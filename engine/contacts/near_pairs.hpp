// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/contacts/met_pairs.hpp"
#include "engine/contacts/pair_search.hpp"
#include "engine/contacts/touching.hpp"
#include "engine/kernels/parcel_block.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

/// Pairs of parcels that touch or could before the next rebuild. Each pair has one slot; each parcel has a list of its
/// slots, sorted by the partner's id, so that sums run in the same order whatever the lists contain besides. Slots of one
/// group lie together and each group begins a new block of the kernels; slots that only fill a block up belong to no entry
/// and never touch. A contact class has two groups: pairs that touched or nearly did when the lists were made, whose blocks
/// are evaluated where they stand, and pairs apart, of which most need no more than a look at their distance. Pairs that come
/// near before the lists are made again are added behind, in no block of their own: few, apart, of any class.
class NearPairs {
 public:
  static constexpr std::uint32_t no_parcel = 0xffffffffu;
  static constexpr std::size_t parcels_at_once =
      512;  ///< what they need of each other stays in the second cache

  /// Lists the pairs that are near now. Forgets all contacts: see `restore`.
  void rebuild(const PairSearch& wanted, int threads);

  /// Lists pairs besides (indices in the store), those not listed yet: apart, in slots behind all others and in no group.
  /// Their entries wait until `settle_late`, which costs a pass over all; after a whole step none wait.
  void add(std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs, const Parcels& parcels);
  void settle_late(const Parcels& parcels);
  /// Whether so many more can be added without moving what is listed.
  bool has_room_for(std::size_t pairs) const { return first.size() + pairs <= first.capacity(); }
  /// An entry that will be one of a parcel's.
  struct Waiting {
    std::uint32_t parcel, partner_id, entry;
    friend auto operator<=>(const Waiting&, const Waiting&) = default;
  };
  /// Those of a parcel, partners' ids ascending.
  std::span<const Waiting> waiting_of(std::uint32_t parcel) const;

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
  /// The other parcel of a pair, by an entry of the one.
  std::uint32_t partner(std::uint32_t of_entry) const {
    return of_entry & 1u ? first[of_entry >> 1] : second[of_entry >> 1];
  }
  bool is_pair(std::size_t slot) const { return first[slot] != second[slot]; }  ///< and no mere filling

  std::size_t class_of(std::size_t group) const { return group % (group_begin.size() / 2); }
  bool are_apart(std::size_t group) const { return group >= group_begin.size() / 2; }
  std::size_t first_apart() const { return pasts.first_apart; }  ///< slot
  std::size_t first_late() const { return first_late_; }         ///< slot

  /// End of the slots of a group that belong to the parcels up to `parcel` in the order of the store. A slot belongs to
  /// that of its two parcels which stands first.
  std::size_t slot_end(std::size_t group, std::size_t parcel) const {
    return is_empty(group) ? group_begin[group] : own_end_[row_[group] + parcel];
  }
  bool is_empty(std::size_t group) const { return group_begin[group] == group_end[group]; }
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
  /// Sets what a contact remembers. Those of pairs apart must be set by one thread at a time.
  void set_past(std::size_t slot, const laws::Past& past);

  /// Goes through the share `part` as every step does: calls `slots(group, from, to)` for the slots, whole blocks
  /// of a group, that parcels need before `parcels(from, to)` is called for them. `cursors`: one per group.
  template <class Slots, class OfParcels>
  void go_through(int part, std::vector<std::size_t>& cursors, Slots&& slots, OfParcels&& parcels) const {
    constexpr std::size_t block = kernels::block_size;
    const auto [from, to] = share(part);
    for (std::size_t g = 0; g < cursors.size(); ++g) cursors[g] = first_block(g, from);
    for (std::size_t start = from; start < to; start += parcels_at_once) {
      const std::size_t end = std::min(to, start + parcels_at_once);
      for (std::size_t g = 0; g < cursors.size(); ++g) {
        const std::size_t wanted = slot_end(g, end - 1), begin_slot = cursors[g];
        if (begin_slot >= wanted) continue;
        cursors[g] += (wanted - begin_slot + block - 1) / block * block;
        slots(g, begin_slot, std::min(cursors[g], group_end[g]));
      }
      parcels(start, end);
    }
  }
  std::size_t groups() const { return group_begin.size(); }
  /// The share whose way goes through a slot.
  int part_of(std::size_t slot) const;
  /// The slots from `from` on, which begins a block, as kernels take them.
  kernels::SomePairs some(std::size_t from, int count) const {
    constexpr std::size_t block = kernels::block_size;
    const std::size_t ahead = std::min(block, slots() - std::min(slots(), from + block));
    return {count, &first[from], &second[from], &touching[from], static_cast<int>(ahead)};
  }

  /// Force on the first of a pair at the end of the last step, N, if that kept the forces; else zero.
  Vec3 force_on_first(std::size_t slot) const;
  /// Forgets the forces, and says whether the step that comes shall keep its own.
  void keep_forces(bool keep);

  // Per slot. The first has the lower id.
  std::vector<std::uint32_t> first, second;
  std::vector<std::uint8_t> touching;

  // Of close pairs, slots up to first_apart().
  std::vector<Vec3> force;              ///< on the first; empty where nobody asked for them
  std::vector<kernels::Places> places;  ///< where what it does to its parcels lies while it is needed

  Pasts pasts;  ///< by slot

  // Per group: its slots are [group_begin[g], group_end[g]). The close ones of each class come first.
  std::vector<std::size_t> group_begin, group_end;

  // Per parcel: entries [begin[k], begin[k + 1]) of `entry`, partners' ids ascending.
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> entry;  ///< 2 slot + (1 if the parcel is the second)
  std::vector<kernels::Run> runs;    ///< of loads of its close pairs, in the order of entries
  std::vector<std::uint8_t> meets;   ///< touches one of those that were apart, in this step

  /// In runs. A parcel's is needed from the first of its slots that is evaluated until it has been summed up; then another
  /// parcel's takes its place, so that there are about as many as a slice or two of the powder has.
  std::vector<Load> load;
  /// While they are needed, of a close pair.
  Load& load_on_first(std::size_t slot) { return load[places[slot].first / kernels::Places::numbers]; }
  Load& load_on_second(std::size_t slot) { return load[places[slot].second / kernels::Places::numbers]; }

 private:
  /// Where a pair stands in the list of one of its parcels, while slots are assigned.
  struct Listed {
    std::uint32_t pair;
    std::uint32_t partner_id;
  };
  bool is_listed(std::uint32_t i, std::uint32_t j) const;
  std::vector<Listed> list_pairs(const Parcels& parcels, std::span<const FoundPair> pairs, int threads);
  void assign_slots(const Parcels& parcels, std::size_t class_count, std::span<const FoundPair> pairs,
                    int threads);
  std::size_t count_slots(std::size_t class_count, std::span<const FoundPair> pairs,
                          std::span<const Listed> listed, int threads);
  std::uint32_t owner_of_block(std::size_t slot) const;
  void divide(int threads);
  void assign_places();
  std::vector<std::size_t> begins_of_runs(int part) const;
  std::size_t longest_way_round(int part, std::span<const std::size_t> begins) const;
  std::uint32_t lay_out_runs(int part);

  std::vector<std::uint32_t> own_end_;  ///< [row_[group] + parcel], of groups that have slots
  std::vector<std::size_t> row_;
  std::size_t first_late_ = 0;
  std::vector<Waiting> waiting_;
  int shares_ = 1;
  bool forces_kept_ = false;
  std::vector<std::uint8_t> divided_;
  std::vector<std::uint32_t> divided_ones_;
};

}  // namespace pulvis
