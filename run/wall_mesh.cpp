// SPDX-License-Identifier: Apache-2.0
#include "run/wall_mesh.hpp"

#include <cmath>

namespace pulvis {
namespace {

constexpr int facets = 64;

/// A convex polygon as a fan of triangles.
void add_fan(const std::vector<Vec3>& corners, SurfaceMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
  for (std::uint32_t k = 2; k < corners.size(); ++k)
    mesh.triangles.push_back({first, first + k - 1, first + k});
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

void add_plane(const Surface& s, const Box& domain, const Vec3& shift, SurfaceMesh& mesh) {
  const Vec3 u = perpendicular(s.normal), v = cross(s.normal, u);
  const Vec3 middle = 0.5 * (domain.min + domain.max), point = s.centre + shift;
  const Vec3 centre = middle - dot(middle - point, s.normal) * s.normal;
  const double far = norm(domain.extent());
  std::vector<Vec3> polygon{centre + far * u + far * v, centre - far * u + far * v,
                            centre - far * u - far * v, centre + far * u - far * v};
  for (int axis = 0; axis < 3; ++axis) {
    polygon = clipped(polygon, axis, domain.max[axis], 1.0);
    polygon = clipped(polygon, axis, domain.min[axis], -1.0);
  }
  if (polygon.size() >= 3) add_fan(polygon, mesh);
}

}  // namespace

void add_triangles(const Surface& s, const Box& domain, const Vec3& shift, SurfaceMesh& mesh) {
  const auto on_circle = [&](int k, double along) {
    const Vec3 u = perpendicular(s.normal), v = cross(s.normal, u);
    const double angle = 2.0 * M_PI * k / facets;
    return s.centre + shift + along * s.normal + s.half[0] * std::cos(angle) * u +
           s.half[0] * std::sin(angle) * v;
  };
  switch (s.kind) {
    case Surface::Kind::plane:
      add_plane(s, domain, shift, mesh);
      break;
    case Surface::Kind::rectangle: {
      const Vec3 c = s.centre + shift, u = s.half[0] * s.side[0], v = s.half[1] * s.side[1];
      add_fan({c - u - v, c + u - v, c + u + v, c - u + v}, mesh);
      break;
    }
    case Surface::Kind::disc: {
      std::vector<Vec3> rim;
      for (int k = 0; k < facets; ++k) rim.push_back(on_circle(k, 0.0));
      add_fan(rim, mesh);
      break;
    }
    case Surface::Kind::tube:
      for (int k = 0; k < facets; ++k)
        add_fan(
            {on_circle(k, 0.0), on_circle(k + 1, 0.0), on_circle(k + 1, s.half[1]), on_circle(k, s.half[1])},
            mesh);
      break;
  }
}

}  // namespace pulvis
