// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis {

/// A region of space: a box or a cylinder.
struct Region {
  enum class Shape { box, cylinder };
  Shape shape = Shape::box;
  Vec3 min, max;                      ///< m; box
  Vec3 base, axis{0, 0, 1};           ///< m, -; cylinder: centre of its lower end, unit vector along it
  double radius = 0.0, height = 0.0;  ///< m; cylinder
};

/// m^3.
inline double volume(const Region& r) {
  if (r.shape == Region::Shape::cylinder) return pi * square(r.radius) * r.height;
  const Vec3 e = r.max - r.min;
  return e.x * e.y * e.z;
}

/// Its narrowest width, m.
inline double narrowest(const Region& r) {
  if (r.shape == Region::Shape::cylinder) return least(2.0 * r.radius, r.height);
  const Vec3 e = r.max - r.min;
  return least(least(e.x, e.y), e.z);
}

/// Any unit vector at right angles to the unit vector `axis`.
inline Vec3 perpendicular(const Vec3& axis) {
  const Vec3 helper = magnitude(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 side = cross(axis, helper);
  return side / norm(side);
}

}  // namespace pulvis
