// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/parcels/domain.hpp"
#include "engine/walls/bodies.hpp"
#include "output/vtk.hpp"

namespace pulvis {

/// Walls as triangles, to look at and to check: planes are cut off at the domain, round walls get 64 facets,
/// meshes are as they are.
struct WallMesh {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> body, wall, surface;  ///< per triangle
  std::vector<std::uint32_t> facet;                ///< per triangle: of its mesh; no_facet for shapes
};

/// The walls where their bodies stand; absent bodies are left out. `pose(body)`.
WallMesh mesh_of_walls(const Walls& walls, const Box& domain,
                       const std::function<const Pose&(std::uint32_t)>& pose);

/// The triangles of one shape in the frame of its body. Not for patches.
TriangleMesh triangles_of(const Surface& surface, const Box& domain);

/// All triangles of one body, in its own frame.
TriangleMesh triangles_of_body(const Walls& walls, std::uint32_t body, const Box& domain);

/// The faces of a box or cylinder.
TriangleMesh triangles_of(const Region& region);

}  // namespace pulvis
