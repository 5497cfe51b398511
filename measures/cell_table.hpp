// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pulvis::measures {

/// Numbers by key, in one block of memory: asked for each contact with a wall, so a look must cost one miss
/// of the cache, not the three of a std::unordered_map. At least half of its slots are free.
class CellTable {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t find(std::uint64_t key) const { return slots_.empty() ? none : slots_[place(key)].number; }

  /// The number that the key has; if none, it is given this one.
  std::uint32_t find_or_add(std::uint64_t key, std::uint32_t number) {
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place(key)];
    if (slot.number == none) {
      slot = {key, number};
      ++used_;
    }
    return slot.number;
  }

  /// Replaces each number by replace(number).
  template <class Replace>
  void renumber(const Replace& replace) {
    for (Slot& slot : slots_)
      if (slot.number != none) slot.number = replace(slot.number);
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t number = none;
  };

  /// Slot of the key, or the free one where it would be put.
  std::size_t place(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    // Multiplying by 2^64 over the golden ratio scatters keys in even steps (Knuth, vol. 3, section 6.4).
    std::size_t at = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> shift_);
    while (slots_[at].number != none && slots_[at].key != key) at = (at + 1) & mask;
    return at;
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 4 : 2 * slots_.size());
    old.swap(slots_);
    shift_ = 64 - std::countr_zero(slots_.size());
    for (const Slot& slot : old)
      if (slot.number != none) slots_[place(slot.key)] = slot;
  }

  std::vector<Slot> slots_;  ///< a power of two
  std::size_t used_ = 0;
  int shift_ = 0;  ///< what is left of a key's product is a slot
};

}  // namespace pulvis::measures
