// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <vector>

#include "engine/walls/triangle_mesh.hpp"
#include "meshes/triangle_soup.hpp"

namespace pulvis::test {

/// Adds the two triangles of a quadrilateral, counter-clockwise seen from outside.
inline void add_quad(TriangleSoup& soup, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

/// Twelve triangles, two on each of the sides -x, +x, -y, +y, -z, +z.
inline TriangleSoup box_soup(const Vec3& min, const Vec3& max) {
  TriangleSoup soup{"box.stl", {}};
  const auto corner = [&](int x, int y, int z) {
    return Vec3{x ? max.x : min.x, y ? max.y : min.y, z ? max.z : min.z};
  };
  add_quad(soup, corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  add_quad(soup, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  add_quad(soup, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  add_quad(soup, corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0));
  add_quad(soup, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  add_quad(soup, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  return soup;
}

inline TriangleSoup cube_soup(double side = 8.0) { return box_soup({0, 0, 0}, {side, side, side}); }

inline void append(TriangleSoup& soup, const TriangleSoup& more) {
  soup.triangles.insert(soup.triangles.end(), more.triangles.begin(), more.triangles.end());
}

/// 2 n^2 triangles over [0, side]^2 at the heights height(x, y), looking upward.
template <class Height>
TriangleMesh sheet(int n, double side, Height&& height) {
  TriangleMesh mesh;
  const auto number = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = side * i / n, y = side * j / n;
      mesh.points.push_back({x, y, height(x, y)});
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      mesh.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.points) p += by;
  return mesh;
}

}  // namespace pulvis::test
