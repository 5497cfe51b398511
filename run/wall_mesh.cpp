// SPDX-License-Identifier: Apache-2.0
#include "run/wall_mesh.hpp"

#include <cmath>

#include "engine/contacts/near_walls.hpp"

namespace pulvis {
namespace {

constexpr int facets = 64;

/// A convex polygon as a fan of triangles.
void add_fan(const std::vector<Vec3>& corners, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  for (std::uint32_t k = 2; k < corners.size(); ++k)
    mesh.triangles.push_back({first, first + k - 1, first + k});
}

/// Rings of points, the next around the last: a strip of triangles between each two of them.
void add_strips(const std::vector<std::vector<Vec3>>& rings, TriangleMesh& mesh) {
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
    for (std::size_t k = 0; k < rings[r].size(); ++k) {
      const std::size_t next = (k + 1) % rings[r].size();
      add_fan({rings[r][k], rings[r][next], rings[r + 1][next], rings[r + 1][k]}, mesh);
    }
}

void append(const TriangleMesh& more, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (const auto& t : more.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// The part of a convex polygon where sign * (x[axis] - limit) <= 0.
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, int axis, double limit, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
    if (da <= 0.0) kept.push_back(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

void add_plane(const Surface& s, const Box& domain, TriangleMesh& mesh) {
  const Vec3 u = perpendicular(s.normal), v = cross(s.normal, u);
  const Vec3 middle = 0.5 * (domain.min + domain.max);
  const Vec3 centre = middle - dot(middle - s.centre, s.normal) * s.normal;
  const double far = norm(domain.extent());
  std::vector<Vec3> polygon{centre + far * u + far * v, centre - far * u + far * v,
                            centre - far * u - far * v, centre + far * u - far * v};
  for (int axis = 0; axis < 3; ++axis) {
    polygon = clipped(polygon, axis, domain.max[axis], 1.0);
    polygon = clipped(polygon, axis, domain.min[axis], -1.0);
  }
  if (polygon.size() >= 3) add_fan(polygon, mesh);
}

std::vector<Vec3> ring(const Surface& s, double along, double radius) {
  const Vec3 u = perpendicular(s.normal), v = cross(s.normal, u);
  std::vector<Vec3> points;
  for (int k = 0; k < facets; ++k) {
    const double angle = 2.0 * M_PI * k / facets;
    points.push_back(s.centre + along * s.normal + radius * std::cos(angle) * u +
                     radius * std::sin(angle) * v);
  }
  return points;
}

void add_sphere(const Surface& s, TriangleMesh& mesh) {
  std::vector<std::vector<Vec3>> rings;
  for (int k = 0; k <= facets / 2; ++k) {
    const double angle = M_PI * k / (facets / 2);
    rings.push_back(ring(s, -s.radius * std::cos(angle), s.radius * std::sin(angle)));
  }
  add_strips(rings, mesh);
}

}  // namespace

TriangleMesh triangles_of(const Surface& s, const Box& domain) {
  TriangleMesh mesh;
  switch (s.kind) {
    case Surface::Kind::plane:
      add_plane(s, domain, mesh);
      break;
    case Surface::Kind::rectangle: {
      const Vec3 u = s.half[0] * s.side[0], v = s.half[1] * s.side[1];
      add_fan({s.centre - u - v, s.centre + u - v, s.centre + u + v, s.centre - u + v}, mesh);
      break;
    }
    case Surface::Kind::disc:
      if (s.other_radius > 0.0)
        add_strips({ring(s, 0.0, s.other_radius), ring(s, 0.0, s.radius)}, mesh);
      else
        add_fan(ring(s, 0.0, s.radius), mesh);
      break;
    case Surface::Kind::frustum:
      add_strips({ring(s, 0.0, s.radius), ring(s, s.height, s.other_radius)}, mesh);
      break;
    case Surface::Kind::sphere:
      add_sphere(s, mesh);
      break;
    case Surface::Kind::patch:
      break;
  }
  return mesh;
}

TriangleMesh triangles_of_body(const Walls& walls, std::uint32_t body, const Box& domain) {
  TriangleMesh mesh;
  for (const Surface& s : walls.surfaces)
    if (s.body == body) append(triangles_of(s, domain), mesh);
  for (const FacetedWall& faceted : walls.meshes)
    if (walls.surfaces[faceted.first_surface].body == body) append(faceted.mesh(), mesh);
  return mesh;
}

TriangleMesh triangles_of(const Region& region) {
  TriangleMesh mesh;
  const auto surfaces =
      region.shape == Region::Shape::box ? box_surfaces("", region, {}) : cylinder_surfaces("", region, {});
  for (const Surface& s : surfaces) append(triangles_of(s, {}), mesh);
  return mesh;
}

WallMesh mesh_of_walls(const Walls& walls, const Box& domain,
                       const std::function<const Pose&(std::uint32_t)>& pose) {
  WallMesh result;
  const auto add = [&](const Surface& s, std::uint32_t surface, const Vec3(&corners)[3],
                       std::uint32_t facet) {
    const auto first = static_cast<std::uint32_t>(result.mesh.points.size());
    for (const Vec3& corner : corners) result.mesh.points.push_back(pose(s.body).now(corner));
    result.mesh.triangles.push_back({first, first + 1, first + 2});
    result.body.push_back(s.body);
    result.wall.push_back(s.wall);
    result.surface.push_back(surface);
    result.facet.push_back(facet);
  };
  for (std::uint32_t k = 0; k < walls.surfaces.size(); ++k) {
    const Surface& s = walls.surfaces[k];
    if (pose(s.body).absent) continue;
    const TriangleMesh mesh = triangles_of(s, domain);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      add(s, k, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, NearWalls::no_facet);
  }
  for (const FacetedWall& faceted : walls.meshes)
    for (std::uint32_t t = 0; t < faceted.mesh().triangles.size(); ++t) {
      const std::uint32_t k = faceted.first_surface + faceted.patch_of(t);
      if (pose(walls.surfaces[k].body).absent) continue;
      const TriangleMesh& mesh = faceted.mesh();
      add(walls.surfaces[k], k, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, t);
    }
  return result;
}

}  // namespace pulvis
