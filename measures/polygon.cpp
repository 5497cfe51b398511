// SPDX-License-Identifier: Apache-2.0
#include "measures/polygon.hpp"

namespace pulvis::measures {

AreaMoments area_moments(const Polygon& polygon) {
  AreaMoments sum;
  const Vec3& a = polygon.corner[0];
  for (int k = 2; k < polygon.count; ++k) {
    const Vec3 &b = polygon.corner[k - 1], &c = polygon.corner[k];
    const double area = 0.5 * norm(cross(b - a, c - a));
    sum.area += area;
    sum.first += (area / 3.0) * (a + b + c);
  }
  return sum;
}

void cut(const Polygon& polygon, int axis, double bound, Polygon& below, Polygon& above) {
  below.count = above.count = 0;
  bool any_below = false, any_above = false;
  for (int k = 0; k < polygon.count; ++k) {
    any_below = any_below || polygon.corner[k][axis] < bound;
    any_above = any_above || polygon.corner[k][axis] > bound;
  }
  if (!any_below || !any_above) {
    (any_below ? below : above) = polygon;
    return;
  }
  for (int k = 0; k < polygon.count; ++k) {
    const Vec3 &p = polygon.corner[k], &q = polygon.corner[k + 1 < polygon.count ? k + 1 : 0];
    const double from = p[axis] - bound, to = q[axis] - bound;
    if (from <= 0.0) below.add(p);
    if (from >= 0.0) above.add(p);
    if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0)) {
      Vec3 crossing = p + (from / (from - to)) * (q - p);
      crossing[axis] = bound;
      below.add(crossing);
      above.add(crossing);
    }
  }
}

}  // namespace pulvis::measures
