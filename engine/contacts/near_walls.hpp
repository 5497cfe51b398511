// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/contacts/touching.hpp"
#include "engine/parcels/parcels.hpp"
#include "engine/walls/bodies.hpp"

namespace pulvis {

/// Who is looked for: parcels, bodies, and how far they may go until lists are made again.
struct WallSearch {
  const Parcels& parcels;
  const Walls& walls;
  std::span<const Pose> poses;
  std::span<const double> margin;       ///< m, per parcel
  std::span<const std::uint8_t> crowd;  ///< per parcel
  std::span<const double> body_margin;  ///< m, per body
  std::span<const std::uint8_t> body_crowd;
  double reach;           ///< m, of contacts that hold beyond touching
  double between_crowds;  ///< m, by which parcels and bodies of different crowds may come nearer besides
};

/// Parcels and surfaces that touch or could before the next rebuild; a parcel's slots lie together, surfaces
/// ascending. A slot of a patch lists the triangles that can come into question.
class NearWalls {
 public:
  /// Finds all surfaces closer to a parcel than its margin, that of the surface's body, the reach, and what crowds may come
  /// nearer. Bodies that are absent are passed over.
  void rebuild(const WallSearch& wanted, int threads);
  /// Whether a parcel that has been given another margin where it is now could come near a surface or triangle that its list
  /// does not have, before it leaves that margin or a body its own.
  bool would_miss(std::uint32_t parcel, const WallSearch& wanted) const;
  TouchingList pack() const;
  /// As NearPairs::restore.
  std::size_t restore(const TouchingList& list, std::span<const std::uint32_t> old_index);

  /// As NearPairs::take_over_forces.
  void take_over_loads(const NearWalls& old, std::span<const std::uint32_t> old_index);

  std::size_t slots() const { return parcel.size(); }
  /// The first slot of the parcel that slot `slot` belongs to; slots() beyond the last: so shares of slots become
  /// shares of parcels.
  std::size_t first_of_parcel(std::size_t slot) const {
    return slot < slots() ? begin[parcel[slot]] : slots();
  }
  /// Triangles of the slot's patch that can come into question, ascending; none for a shape.
  std::span<const std::uint32_t> facets(std::size_t slot) const {
    return {facet_.data() + facet_begin_[slot], facet_.data() + facet_begin_[slot + 1]};
  }

  static constexpr std::uint32_t no_facet = 0xffffffffu;

  std::vector<std::uint32_t> begin;  ///< per parcel, slots [begin[k], begin[k + 1])
  // Per slot.
  std::vector<std::uint32_t> parcel, surface;
  std::vector<std::uint32_t> touched_facet;  ///< triangle of the last evaluation, or no_facet
  std::vector<std::uint8_t> touching;
  std::vector<laws::History> history;
  Memories memory;         ///< `used` is to be set before the first rebuild
  std::vector<Load> load;  ///< on the parcel, N and N m about its centre

 private:
  std::vector<std::uint32_t> facet_begin_{0}, facet_;
};

}  // namespace pulvis
