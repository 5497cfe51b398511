// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/kernels/contact_block.hpp"
#include "engine/laws/parts.hpp"

namespace pulvis {

/// What a pair contact does to its two parcels, about their centres: N, N m.
struct PairLoad {
  Vec3 force;  ///< on the first; the second gets the opposite
  Vec3 torque_first, torque_second;
};

/// What contacts of pairs remember and do that were apart when the lists were made and met since. They are few, so room is
/// found for them when they meet rather than kept for every pair. Parts of the work that go on at once have each their own
/// number, and each pair always belongs to the same. A part holds less than 2^32 contacts over the number of parts.
class MetPairs {
 public:
  struct Contact {
    laws::Past past;
    PairLoad load;
  };

  /// Forgets all; there are `pairs` that could meet, and soon perhaps `more`.
  void reset(std::size_t pairs, int parts, std::size_t more = 0) {
    number_.reserve(pairs + more);
    number_.assign(pairs, 0);
    parts_.assign(static_cast<std::size_t>(parts), {});
  }
  /// Makes room for more pairs behind those that are there.
  void add(std::size_t pairs) { number_.resize(number_.size() + pairs, 0); }
  /// The contact of a pair, or null where there is none.
  const Contact* find(std::size_t pair) const {
    const std::size_t n = number_[pair];
    return n == 0 ? nullptr : &parts_[(n - 1) % parts_.size()].contacts[(n - 1) / parts_.size()];
  }
  void put(std::size_t pair, const Contact& contact, int part) {
    Part& own = parts_[static_cast<std::size_t>(part)];
    if (number_[pair] == 0) number_[pair] = new_number(own, static_cast<std::size_t>(part));
    own.contacts[(number_[pair] - 1) / parts_.size()] = contact;
  }
  void forget(std::size_t pair, int part) {
    if (number_[pair] == 0) return;
    parts_[static_cast<std::size_t>(part)].free.push_back(number_[pair]);
    number_[pair] = 0;
  }
  std::size_t bytes() const {
    std::size_t sum = number_.capacity() * sizeof number_[0];
    for (const Part& p : parts_)
      sum += p.contacts.capacity() * sizeof(Contact) + p.free.capacity() * sizeof p.free[0];
    return sum;
  }

 private:
  struct alignas(64) Part {
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> free;  ///< numbers
  };
  std::uint32_t new_number(Part& own, std::size_t part) {
    if (own.free.empty()) {
      // By an eighth, not to twice as much: they are large.
      if (own.contacts.size() == own.contacts.capacity())
        own.contacts.reserve(own.contacts.size() + own.contacts.size() / 8 + 64);
      own.contacts.emplace_back();
      return static_cast<std::uint32_t>((own.contacts.size() - 1) * parts_.size() + part + 1);
    }
    const std::uint32_t number = own.free.back();
    own.free.pop_back();
    return number;
  }

  std::vector<std::uint32_t>
      number_;  ///< per pair: 0, or 1 + the part + as many parts more as its contact's place there
  std::vector<Part> parts_;
};

/// What the contacts of a list of pairs remember: those of close pairs, slots up to `first_apart`, in blocks of lanes as the
/// kernels use them; those of pairs apart as they meet.
struct Pasts {
  bool remembers = false;  ///< more than springs; to be set before the first `reset`
  std::size_t first_apart = 0;
  std::vector<kernels::Springs> springs;     ///< per block of slots
  std::vector<kernels::MemoryLanes> memory;  ///< the same; empty unless `remembers`
  MetPairs met;                              ///< from first_apart on

  void reset(std::size_t close, std::size_t apart, std::size_t more, int parts) {
    constexpr std::size_t block = kernels::block_size;
    first_apart = close;
    springs.assign((close + block - 1) / block, {});
    memory.assign(remembers ? springs.size() : 0, {});
    met.reset(apart, parts, more);
  }
  /// The contact of a pair apart that has met, or null.
  const MetPairs::Contact* met_at(std::size_t slot) const { return met.find(slot - first_apart); }

  laws::Past of(std::size_t slot) const {
    if (slot >= first_apart) return met_at(slot) ? met_at(slot)->past : laws::Past{};
    const std::size_t block = slot / kernels::block_size;
    const int lane = static_cast<int>(slot % kernels::block_size);
    return kernels::past_of(springs[block], remembers ? &memory[block] : nullptr, lane);
  }
  void put_close(std::size_t slot, const laws::Past& past) {
    const std::size_t block = slot / kernels::block_size;
    const int lane = static_cast<int>(slot % kernels::block_size);
    kernels::put_past(springs[block], remembers ? &memory[block] : nullptr, lane, past);
  }
};

}  // namespace pulvis
