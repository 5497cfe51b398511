// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/math/bounds.hpp"
#include "engine/walls/triangle_mesh.hpp"
#include "meshes/triangle_soup.hpp"

namespace pulvis {

struct MendingChoices {
  /// m; corners closer together become one, and triangles lower than it go. Without one: a millionth of the
  /// bounding box's diagonal, but no less than what a 32-bit number can tell apart four of at the largest
  /// coordinate. A millionth is ten times the rounding of a part that lies at the origin, and for a die of
  /// 10 mm it is 10 nm, far below any parcel.
  std::optional<double> weld_distance;
};

/// Some edges of a mesh: how many, and where one of them is.
struct EdgePlaces {
  std::uint64_t count = 0;
  double length = 0.0;  ///< m, of all of them
  Vec3 place;           ///< m, the middle of the first; only if there is one
};

/// What a file held and what became of it.
struct MeshReport {
  Bounds bounds;               ///< m
  double weld_distance = 0.0;  ///< m
  std::uint64_t triangles_read = 0, triangles = 0, points = 0;
  std::uint64_t points_welded = 0;   ///< different points that became another one's
  std::uint64_t duplicates = 0;      ///< triangles of the same three points as another, removed
  std::uint64_t degenerate = 0;      ///< triangles with a corner twice or without area, removed
  std::uint64_t slivers = 0;         ///< triangles no higher than the weld distance, removed
  std::uint64_t slivers_kept = 0;    ///< those that could not be removed without opening the surface
  std::uint64_t turned = 0;          ///< triangles turned round, so that neighbours agree
  std::uint64_t not_orientable = 0;  ///< edges whose two triangles cannot agree
  std::uint64_t shells = 0;          ///< pieces that hang together by edges
  std::uint64_t holes = 0;           ///< runs of open edges that hang together
  EdgePlaces open_edges;             ///< with one triangle only
  EdgePlaces crowded_edges;          ///< with more than two triangles
  bool watertight = false;           ///< no open edge
  std::optional<double> volume;      ///< m^3, enclosed; if watertight and oriented throughout
  double area = 0.0;                 ///< m^2
  double shortest_edge = 0.0;        ///< m
};

struct MendedMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t>
      facets;  ///< per triangle: the number in the file of the one it comes from, from 1
  MeshReport report;
};

/// Makes a mesh of shared points of `soup`: welds, removes duplicates, slivers and triangles without area,
/// and turns triangles round until they agree. What is missing is not invented: holes stay and are reported.
/// Throws Failure(bad_input) if no triangle is left.
MendedMesh mend(const TriangleSoup& soup, double metres_per_unit, const MendingChoices& choices = {});

}  // namespace pulvis
