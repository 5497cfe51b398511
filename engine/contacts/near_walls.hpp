// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/contacts/touching.hpp"
#include "engine/parcels/parcels.hpp"
#include "engine/walls/bodies.hpp"

namespace pulvis {

/// Parcels and surfaces that touch or could before the next rebuild; a parcel's slots lie together, surfaces
/// ascending.
class NearWalls {
 public:
  /// Finds all surfaces closer to a parcel than its margin + that of the surface's body + reach, m.
  void rebuild(const Parcels& parcels, std::span<const Surface> surfaces, std::span<const Pose> poses,
               std::span<const double> margin, std::span<const double> body_margin, double reach,
               int threads);
  TouchingList pack() const;
  /// As NearPairs::restore.
  std::size_t restore(const TouchingList& list, std::span<const std::uint32_t> old_index);

  /// As NearPairs::take_over_loads.
  void take_over_loads(const NearWalls& old, std::span<const std::uint32_t> old_index);

  std::size_t slots() const { return parcel.size(); }

  std::vector<std::uint32_t> begin;  ///< per parcel, slots [begin[k], begin[k + 1])
  // Per slot.
  std::vector<std::uint32_t> parcel, surface;
  std::vector<std::uint8_t> touching;
  std::vector<laws::History> history;
  std::vector<Load> load;  ///< on the parcel, N and N m about its centre
};

}  // namespace pulvis
