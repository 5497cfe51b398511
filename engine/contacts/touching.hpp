// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/laws/parts.hpp"

namespace pulvis {

/// The contacts that exist and what they remember, packed: how history crosses a rebuild of the lists, a
/// snapshot, a restart. Grouped by owner (index of a parcel in the store), partners ascending within it.
/// Pairs: the owner has the lower id, `partner` is the other's id. Walls: `partner` is the surface.
struct TouchingList {
  std::vector<std::uint32_t> begin{0};  ///< size = parcels + 1
  std::vector<std::uint32_t> partner;
  std::vector<laws::History> history;

  std::size_t size() const { return partner.size(); }
};

}  // namespace pulvis
