// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "validation/draw.hpp"
#include "validation/scene.hpp"

// Meshes for tests, and how they get into a model.
namespace pulvis::scenes {

/// A parallelogram as `along_count` by `across_count` cells of two triangles each. Inner corners are moved at
/// random by up to `jitter` cells (below a quarter no triangle turns over), diagonals are laid at random; the rim stays even, so that neighbours fit.
inline TriangleMesh random_triangles(const Vec3& corner, const Vec3& along, const Vec3& across,
                                     std::uint32_t along_count, std::uint32_t across_count, double jitter,
                                     validation::Draw& draw) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= across_count; ++j)
    for (std::uint32_t i = 0; i <= along_count; ++i) {
      const bool rim = i == 0 || j == 0 || i == along_count || j == across_count;
      const double u = (i + (rim ? 0.0 : draw.between(-jitter, jitter))) / along_count;
      const double v = (j + (rim ? 0.0 : draw.between(-jitter, jitter))) / across_count;
      mesh.points.push_back(corner + u * along + v * across);
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (along_count + 1) + i; };
  for (std::uint32_t j = 0; j < across_count; ++j)
    for (std::uint32_t i = 0; i < along_count; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (draw.chance(0.5)) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      } else {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({b, c, d});
      }
    }
  return mesh;
}

/// One mesh of several; corners at the same place (to 1e-12 m) become one.
inline TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
  TriangleMesh mesh;
  std::map<std::tuple<long long, long long, long long>, std::uint32_t> known;
  for (const TriangleMesh& part : parts) {
    std::vector<std::uint32_t> number;
    for (const Vec3& p : part.points) {
      const auto place = [](double x) { return std::llround(x * 1e12); };
      const auto [entry, is_new] = known.emplace(std::tuple{place(p.x), place(p.y), place(p.z)},
                                                 static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back(p);
      number.push_back(entry->second);
    }
    for (const auto& t : part.triangles) mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return mesh;
}

/// The six faces of a box.
inline TriangleMesh random_box(const Vec3& low, const Vec3& high, std::uint32_t cells, double jitter,
                               validation::Draw& draw) {
  const Vec3 e = high - low, x{e.x, 0, 0}, y{0, e.y, 0}, z{0, 0, e.z};
  const auto face = [&](const Vec3& corner, const Vec3& a, const Vec3& b) {
    return random_triangles(corner, a, b, cells, cells, jitter, draw);
  };
  return joined({face(low, y, x), face(low, x, z), face(low, z, y), face(low + z, x, y), face(low + y, z, x),
                 face(low + x, y, z)});
}

/// Adds a mesh as one more wall; of the first body, or of a body of its own.
inline void add_mesh(Model& m, TriangleMesh triangles, bool own_body = false, const Smoothness& smooth = {}) {
  if (own_body || m.walls.bodies.empty()) m.walls.bodies.push_back({"mesh", {}});
  FacetedWall mesh(std::move(triangles), smooth);
  mesh.first_surface = static_cast<std::uint32_t>(m.walls.surfaces.size());
  Surface s;
  s.kind = Surface::Kind::patch;
  s.name = "mesh";
  s.body = own_body ? static_cast<std::uint32_t>(m.walls.bodies.size() - 1) : 0;
  s.mesh = static_cast<std::uint32_t>(m.walls.meshes.size());
  for (s.patch = 0; s.patch < mesh.patches(); ++s.patch) m.walls.surfaces.push_back(s);
  m.walls.meshes.push_back(std::move(mesh));
}

}  // namespace pulvis::scenes
