// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/parcels/domain.hpp"
#include "engine/walls/bodies.hpp"
#include "output/vtk.hpp"

namespace pulvis {

/// Walls as triangles, to look at: planes are cut off at the domain, round walls get 64 facets.
struct WallMesh {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> body;     ///< per triangle
  std::vector<std::uint32_t> surface;  ///< per triangle
};

/// `displacement(body)` is where each body stands now, m.
template <class Displacement>
WallMesh mesh_of_walls(std::span<const Surface> surfaces, const Box& domain, Displacement&& displacement);

/// The triangles of one surface, moved by `shift`, added to `mesh`.
void add_triangles(const Surface& surface, const Box& domain, const Vec3& shift, SurfaceMesh& mesh);

template <class Displacement>
WallMesh mesh_of_walls(std::span<const Surface> surfaces, const Box& domain, Displacement&& displacement) {
  WallMesh result;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    add_triangles(surfaces[s], domain, displacement(surfaces[s].body), result.mesh);
    result.body.resize(result.mesh.triangles.size(), surfaces[s].body);
    result.surface.resize(result.mesh.triangles.size(), s);
  }
  return result;
}

}  // namespace pulvis
