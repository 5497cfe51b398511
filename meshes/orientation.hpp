// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "meshes/edges.hpp"

namespace pulvis {

struct Orientation {
  std::uint64_t turned = 0;     ///< triangles turned round
  std::uint64_t conflicts = 0;  ///< edges whose two triangles cannot agree: a Moebius band has one side only
};

/// Turns triangles round until neighbours across every edge of exactly two triangles agree. What hangs
/// together by such edges is a patch, and has one choice left:
///   a closed patch (without open edges) that lies within no other looks outward: its volume is positive;
///   one whose bounding box lies within that of another turns with it, for it may be its cavity;
///   an open patch keeps what most of its triangles say.
/// Contacts do not mind, for walls have two sides; volumes and pictures do.
Orientation orient(std::span<const Vec3> points, std::span<const EdgeUse> uses, std::span<Corners> triangles);

/// Volume between the triangles and `centre`: that enclosed, if they are closed and oriented. m^3.
double signed_volume(std::span<const Vec3> points, const Vec3& centre, const Corners& triangle);

}  // namespace pulvis
