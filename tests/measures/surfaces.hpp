// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "engine/walls/bodies.hpp"
#include "packings.hpp"

// Surfaces with known areas, and points thrown at them evenly.
namespace pulvis::measures::surfaces {

using packings::Uniform;

/// A point of a surface, and the triangle it lies on.
struct Hit {
  std::uint32_t surface = 0, facet = 0xffffffff;
  Vec3 point;  ///< m
};
using Sampler = std::function<Hit(Uniform&)>;

struct Shape {
  Surface surface;
  double area = 0.0;  ///< m^2
  Sampler sample;
};

inline Vec3 unit(const Vec3& v) { return v / norm(v); }

inline Walls walls_of(const Surface& surface) {
  Walls walls;
  walls.surfaces.push_back(surface);
  return walls;
}

inline Walls walls_of(TriangleMesh mesh) {
  Walls walls;
  walls.meshes.emplace_back(std::move(mesh), Smoothness{});
  for (std::uint32_t patch = 0; patch < walls.meshes[0].patches(); ++patch) {
    Surface surface;
    surface.kind = Surface::Kind::patch;
    surface.patch = patch;
    walls.surfaces.push_back(surface);
  }
  return walls;
}

/// A shape of revolution about a tilted axis: a point of it by the share of its area below.
inline Shape turned(Surface surface, double area,
                    const std::function<std::pair<double, double>(double)>& at) {
  const Vec3 centre = surface.centre, axis = surface.normal;
  return {std::move(surface), area, [=](Uniform& uniform) {
            const auto [radius, along] = at(uniform(0, 1));
            const Vec3 across = unit(cross(axis, {0.3, -0.5, 0.2}));
            const double angle = uniform(0, 6.283185307179586);
            const Vec3 outward = std::cos(angle) * across + std::sin(angle) * cross(axis, across);
            return Hit{0, 0xffffffff, centre + radius * outward + along * axis};
          }};
}

inline Shape frustum(const std::string& name, double r, double top, double height) {
  const Vec3 axis = unit({1, 2, -3});
  const double slant = std::hypot(top - r, height);
  return turned(frustum_surfaces(name, {0.1, 0.2, 0.3}, axis, r, top, height, {"base", "top"})[0],
                pi * (r + top) * slant, [=](double share) {
                  const double here =
                      std::sqrt(r * r + share * (top * top - r * r));  // area is as its square
                  const double way = top == r ? share : (here - r) / (top - r);
                  return std::pair{here, way * height};
                });
}

inline Shape disc(const std::string& name, double radius, double hole) {
  return turned(disc_surface(name, {0.3, 0.2, 0.1}, unit({-2, 1, 1}), radius, hole),
                pi * (radius * radius - hole * hole), [=](double share) {
                  return std::pair{std::sqrt(hole * hole + share * (radius * radius - hole * hole)), 0.0};
                });
}

inline Shape sphere(double radius) {
  return turned(sphere_surface("sphere", {1, 2, 3}, radius), 4 * pi * radius * radius, [=](double share) {
    const double z = 2 * share - 1;  // Archimedes: area is as height
    return std::pair{radius * std::sqrt(1 - z * z), radius * z};
  });
}

inline Shape rectangle(const std::string& name, double length, double width) {
  const Vec3 corner{1, -1, 0.5}, along = unit({1, 2, 3}), across = unit(cross(along, {1, 0, 0}));
  return {rectangle_surface(name, corner, length * along, width * across), length * width,
          [=](Uniform& uniform) {
            const Vec3 point = corner + uniform(0, length) * along + uniform(0, width) * across;
            return Hit{0, 0xffffffff, point};
          }};
}

inline std::vector<Shape> shapes() {
  return {
      rectangle("rectangle", 2.3, 1.1), rectangle("strip", 4.0, 0.31),  frustum("cylinder", 0.8, 0.8, 1.7),
      frustum("funnel", 0.4, 1.3, 1.1), frustum("cone", 0.0, 0.9, 1.4), frustum("roof", 1.2, 0.0, 0.2),
      disc("disc", 1.1, 0.0),           disc("ring", 1.4, 0.5),         sphere(0.75)};
}

/// A mesh over the unit square, at(s, t) being its points. Points that coincide, as along a seam, become one.
template <class At>
TriangleMesh sheet(int n, int m, const At& at) {
  TriangleMesh mesh;
  std::vector<std::uint32_t> point;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i <= n; ++i) {
      const Vec3 p = at(double(i) / n, double(j) / m);
      const auto found = std::ranges::find_if(mesh.points, [&](const Vec3& q) { return norm(p - q) < 1e-9; });
      point.push_back(static_cast<std::uint32_t>(found - mesh.points.begin()));
      if (found == mesh.points.end()) mesh.points.push_back(p);
    }
  const auto put = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i + (n + 1) * j), up = k + static_cast<std::size_t>(n) + 1;
      put(point[k], point[k + 1], point[up + 1]);
      put(point[k], point[up + 1], point[up]);
    }
  return mesh;
}

inline TriangleMesh tilted_sheet() {
  const Vec3 along = unit({1, 2, 3}), across = unit(cross(along, {1, 0, 0}));
  return sheet(5, 4, [=](double s, double t) { return 2.3 * s * along + 1.9 * t * across; });
}

inline TriangleMesh faceted_cylinder(double radius, double height, int n, int m) {
  return sheet(n, m, [=](double s, double t) {
    return Vec3{radius * std::cos(2 * pi * s), radius * std::sin(2 * pi * s), height * t};
  });
}

inline TriangleMesh faceted_sphere(double radius, int n) {
  return sheet(2 * n, n, [=](double s, double t) {
    const double across = radius * std::sin(pi * t);
    return Vec3{across * std::cos(2 * pi * s), across * std::sin(2 * pi * s), -radius * std::cos(pi * t)};
  });
}

inline TriangleMesh meshed_box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline double area_of(const TriangleMesh& mesh, std::size_t t) {
  return 0.5 * norm(cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)));
}
inline double area_of(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += area_of(mesh, t);
  return sum;
}

/// Points on the triangles of the first mesh.
inline Sampler sampler_of(const Walls& walls) {
  const FacetedWall& wall = walls.meshes[0];
  std::vector<double> below;  // area of the triangles up to each
  for (std::size_t t = 0; t < wall.mesh().triangles.size(); ++t)
    below.push_back((t == 0 ? 0.0 : below.back()) + area_of(wall.mesh(), t));
  return [&wall, below](Uniform& uniform) {
    const auto found = std::ranges::upper_bound(below, uniform(0, below.back()));
    const auto t = static_cast<std::uint32_t>(found - below.begin());
    double s = uniform(0, 1), r = uniform(0, 1);
    if (s + r > 1) s = 1 - s, r = 1 - r;
    const TriangleMesh& mesh = wall.mesh();
    const Vec3& first = mesh.corner(t, 0);
    return Hit{wall.patch_of(t), t,
               first + s * (mesh.corner(t, 1) - first) + r * (mesh.corner(t, 2) - first)};
  };
}

inline Sampler without_facets(const Sampler& sample) {
  return [sample](Uniform& uniform) {
    Hit hit = sample(uniform);
    hit.facet = 0xffffffff;
    return hit;
  };
}

}  // namespace pulvis::measures::surfaces
