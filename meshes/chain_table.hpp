// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace pulvis {

/// Stirs the bits of `value` into `seed`, so that neighbouring keys fall far apart.
inline std::uint64_t stirred(std::uint64_t seed, std::uint64_t value) {
  std::uint64_t bits = (seed ^ value) * 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio
  bits ^= bits >> 32;
  bits *= 0xD6E8FEB86659FD93u;  // odd, half of its bits set
  return bits ^ bits >> 32;
}

/// Finds numbered things by a hash of what they are: chains of numbers, without the things themselves.
/// Whoever walks a chain compares, since things of other hashes are in it too.
class ChainTable {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  explicit ChainTable(std::size_t expected)
      : heads_(std::bit_ceil(std::max<std::size_t>(expected, 16)), none) {}

  std::uint32_t first(std::uint64_t hash) const { return heads_[hash & (heads_.size() - 1)]; }
  std::uint32_t after(std::uint32_t number) const { return next_[number]; }

  /// Numbers are given once each.
  void add(std::uint64_t hash, std::uint32_t number) {
    if (next_.size() <= number) next_.resize(number + std::size_t{1}, none);
    std::uint32_t& head = heads_[hash & (heads_.size() - 1)];
    next_[number] = head;
    head = number;
  }

  enum class Then { keep, drop, stop };
  /// Calls `visit(number)` along the chain of `hash` until it says stop; takes out the numbers it drops.
  template <class Visit>
  void walk(std::uint64_t hash, Visit&& visit) {
    std::uint32_t* link = &heads_[hash & (heads_.size() - 1)];
    while (*link != none) {
      const Then then = visit(*link);
      if (then == Then::stop) return;
      if (then == Then::drop)
        *link = next_[*link];
      else
        link = &next_[*link];
    }
  }

 private:
  std::vector<std::uint32_t> heads_, next_;
};

}  // namespace pulvis
