// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/laws/parts.hpp"

namespace pulvis {

/// The memory of contacts whose laws need more than springs; empty if no law of the model does.
class Memories {
 public:
  bool used = false;
  std::vector<laws::Memory> list;

  /// Makes room for `count` contacts that remember nothing.
  void assign(std::size_t count) { list.assign(used ? count : 0, {}); }
  void copy(std::size_t to, const Memories& other, std::size_t from) {
    if (used && other.used) list[to] = other.list[from];
  }
  void append(const Memories& other, std::size_t from) {
    if (used) list.push_back(other.list[from]);
  }
  void forget(std::size_t at) {
    if (used) list[at] = {};
  }
};

/// What the contact `at` remembers, all of it, where springs and memory are lists beside each other; and back.
inline laws::Past past_at(std::span<const laws::History> history, const Memories& memory, std::size_t at) {
  laws::Past past{history[at].slide, history[at].roll};
  if (memory.used) {
    const laws::Memory& more = memory.list[at];
    past.plastic = more.plastic, past.adhesion = more.adhesion, past.grip = more.grip;
  }
  return past;
}
inline void put_past_at(std::span<laws::History> history, Memories& memory, std::size_t at,
                        const laws::Past& past) {
  history[at] = {past.slide, past.roll};
  if (memory.used) memory.list[at] = {past.plastic, past.adhesion, past.grip};
}

/// The contacts that exist and what they remember, packed: how history crosses a rebuild of the lists, a
/// snapshot, a restart. Grouped by owner (index of a parcel in the store), partners ascending within it.
/// Pairs: the owner has the lower id, `partner` is the other's id. Walls: `partner` is the surface.
struct TouchingList {
  std::vector<std::uint32_t> begin{0};  ///< size = parcels + 1
  std::vector<std::uint32_t> partner;
  std::vector<laws::History> history;
  Memories memory;

  std::size_t size() const { return partner.size(); }
};

}  // namespace pulvis
