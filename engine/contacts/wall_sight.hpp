// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/contacts/near_walls.hpp"

namespace pulvis {

/// A surface as seen from the centre of a parcel, in the frame of the surface's body.
struct WallSight {
  NearestPoint nearest;
  Vec3 offset;                                ///< from the centre to the nearest point, m
  double distance;                            ///< m
  std::uint32_t facet = NearWalls::no_facet;  ///< triangle the nearest point lies on
};

/// The surface of a slot from the point `at`.
inline WallSight look(const Walls& walls, const NearWalls& near, std::size_t slot, const Vec3& at) {
  const Surface& surface = walls.surfaces[near.surface[slot]];
  WallSight sight;
  if (surface.kind != Surface::Kind::patch) {
    sight.nearest = nearest_point(surface, at);
  } else {
    const FacetedWall& mesh = walls.meshes[surface.mesh];
    double least_square = 1e300;
    for (const std::uint32_t facet : near.facets(slot)) {
      const NearestPoint nearest = mesh.nearest(facet, at);
      const Vec3 d = nearest.point - at;
      if (dot(d, d) >= least_square) continue;
      least_square = dot(d, d);
      sight.nearest = nearest;
      sight.facet = facet;
    }
  }
  sight.offset = sight.nearest.point - at;
  sight.distance = norm(sight.offset);
  return sight;
}

/// Direction to the wall in the middle of the step, in space: where curved surfaces, edges and turning bodies stood dt/2
/// ago. `sight` is from the end of the step, `half` from its middle.
inline Vec3 normal_in_the_middle(const Walls& walls, const NearWalls& near, std::size_t slot,
                                 const WallSight& sight, const WallSight& half, const Pose& pose) {
  const Surface::Kind kind = walls.surfaces[near.surface[slot]].kind;
  // In the middle of the step it may still have been on an edge, where the normal turns.
  const bool flat =
      sight.nearest.in_face && half.nearest.in_face && !pose.turns &&
      (kind == Surface::Kind::plane || kind == Surface::Kind::rectangle || kind == Surface::Kind::disc);
  if (flat || half.distance == 0.0) return pose.now.turn(sight.offset / sight.distance);
  const Vec3 there = half.offset / half.distance;
  if (!pose.turns) return pose.now.turn(there);
  const Vec3 between = pose.now.turn(there) + pose.before.turn(there);
  return between / norm(between);
}

/// Whether a centre that went from `from` to `to` changed sides through the face itself. `sight`: from `to`.
inline bool crossed(const Walls& walls, const NearWalls& near, std::size_t slot, const WallSight& sight,
                    const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  if (square(sight.distance) > dot(way, way)) return false;  // it ends farther away than it went
  const Surface& surface = walls.surfaces[near.surface[slot]];
  if (surface.kind == Surface::Kind::patch) {
    for (const std::uint32_t facet : near.facets(slot))
      if (walls.meshes[surface.mesh].passed(facet, from, to)) return true;
    return false;
  }
  const double was = nearest_point(surface, from).elevation, is = sight.nearest.elevation;
  if (is == 0.0) return sight.nearest.in_face;
  if ((was > 0.0) == (is > 0.0)) return false;
  return nearest_point(surface, from + (was / (was - is)) * way).in_face;  // where it passed
}

}  // namespace pulvis
