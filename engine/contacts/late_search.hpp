// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/contacts/cell_grid.hpp"
#include "engine/kernels/parcel_block.hpp"
#include "engine/parcels/domain.hpp"
#include "engine/parcels/parcels.hpp"

namespace pulvis {

/// What near lists were made with: where parcels stood, and how far they may go until they are looked at again.
struct ListedAt {
  const Parcels& parcels;
  const kernels::Leeway& leeway;
  const kernels::Drift& drift;  ///< since the lists were made
  double reach;                 ///< m, of contacts that hold beyond touching
  double between_crowds;        ///< m, by which parcels of different crowds may come nearer besides,
  double between_crowds_left;   ///< and what is left of that
  double widest;                ///< m, that no radius and margin together exceed
  const Box& box;               ///< not sheared

  /// Where a parcel is but for what it moved within its margin, m.
  Vec3 place(std::size_t i) const { return leeway.reference[i] + drift[leeway.crowd[i]]; }
};

/// Looks for what is near single parcels between two rebuilds of the near lists, since a parcel that leaves its margin early
/// is hardly ever followed by another.
class LateSearch {
 public:
  /// To be called when all lists are made anew.
  void forget() { grid_is_made_ = false, moved_.clear(); }
  /// How many parcels have been looked from since; the more there are, the longer each takes.
  std::size_t looked() const { return moved_.size(); }

  /// Appends the pairs of parcel `i`, which has been given a new reference and margin, with all that may come near it: those
  /// that are listed already too, and some twice.
  void look_from(std::uint32_t i, const ListedAt& lists,
                 std::vector<std::pair<std::uint32_t, std::uint32_t>>& near);

 private:
  bool grid_is_made_ = false;
  CellGrid grid_;                     ///< of places when it was made, as seen from the first crowd
  std::vector<std::uint32_t> moved_;  ///< which have another reference since
};

}  // namespace pulvis
