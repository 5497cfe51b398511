// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// A flat convex polygon in space, small enough to lie on the stack. A triangle cut out by a box has at most
/// nine corners, a plane cut out by two boxes at most sixteen; rounding may add one now and then.
struct Polygon {
  static constexpr int most = 24;
  Vec3 corner[most];  ///< m, in order round the polygon
  int count = 0;

  void add(const Vec3& p) {
    if (count < most) corner[count++] = p;  // beyond that, corners lie within rounding of each other
  }
};

/// Area and area times mean position of a polygon.
struct AreaMoments {
  double area = 0.0;  ///< m^2
  Vec3 first;         ///< m^3
};
AreaMoments area_moments(const Polygon& polygon);

/// Cuts a polygon at the plane where the coordinate `axis` is `bound`. A polygon that lies in that plane is
/// above; one that only touches it from below is below. The other part is then empty.
void cut(const Polygon& polygon, int axis, double bound, Polygon& below, Polygon& above);

}  // namespace pulvis::measures
