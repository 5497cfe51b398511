// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// A flat surface that parcels are counted at. Its normal tells which way is forward.
struct FlowSurface {
  enum class Shape { plane, disc, parallelogram };
  Shape shape = Shape::plane;
  Vec3 point{};                 ///< m; of a plane, the centre of a disc, a corner of a parallelogram
  Vec3 normal{0, 0, 1};         ///< plane and disc: any length above zero
  double radius = 0.0;          ///< m; disc
  Vec3 edge_one{}, edge_two{};  ///< m; parallelogram: from the corner; its normal is their cross product
};

/// What has crossed a surface.
struct Flow {
  double forward_mass = 0.0, backward_mass = 0.0;       ///< kg; along the normal and against it
  std::uint64_t forward_count = 0, backward_count = 0;  ///< parcels

  double mass() const { return forward_mass - backward_mass; }  ///< kg; net
  std::int64_t count() const { return static_cast<std::int64_t>(forward_count - backward_count); }  ///< net
};

/// Counts the parcels whose centre crosses a surface between looks at them. All it knows between two looks is
/// `state()`, plain lists, so that a run that goes on from a checkpoint counts on.
///
/// A parcel goes the straight way from where it was at the look before. It crosses if it was on one side of the
/// surface's plane and is on the other, a centre on the plane itself being in front: what stops on the plane
/// has crossed once, and leaving it forwards is no second crossing. The point of the way on the plane must be
/// within the disc (rim included) or the parallelogram (with its corner and the two edges from it, not with
/// those opposite: neighbours share no crossing). A parcel that was not there before or is gone is no
/// crossing. Who crosses there and back between two looks is not seen: look often enough that parcels move less
/// than the surface is wide.
class FlowMeter {
 public:
  struct State {
    Flow flow;
    std::vector<std::uint32_t> ids;  ///< ascending
    std::vector<Vec3> places;        ///< m; of these parcels at the last look
  };

  /// `period`: length of the space along each axis where it is periodic, m, else 0; a parcel's way is then the
  /// shortest. Throws std::invalid_argument for a surface without area or normal.
  explicit FlowMeter(const FlowSurface& surface, const Vec3& period = {});

  /// Takes up what an earlier meter of the same surface left. std::invalid_argument if it is no such state.
  void restore(State state);

  /// Parcels as they are now: ids in ascending order, places (m) and masses (kg) one by one
  /// (std::invalid_argument if not). The first look only remembers. Give places in a frame in which the surface
  /// rests. Returns what has crossed since the look before.
  Flow look(std::span<const std::uint32_t> ids, std::span<const Vec3> places, std::span<const double> masses);

  const Flow& flow() const { return state_.flow; }  ///< since the beginning
  const State& state() const { return state_; }

 private:
  Vec3 shortest(const Vec3& way) const;
  int crossing(const Vec3& from, const Vec3& to) const;
  bool holds(const Vec3& on_plane) const;

  FlowSurface surface_;
  Vec3 normal_, period_;
  State state_;
};

}  // namespace pulvis::measures
