// SPDX-License-Identifier: Apache-2.0
#include "measures/sphere_box.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "measures/half_spaces.hpp"

namespace pulvis::measures {
namespace {

constexpr double pi = std::numbers::pi;

/// x (3 - x^2) / 6: weight of the arc on the plane at distance x.
double arc_weight(double x) { return x * (3.0 - x * x) / 6.0; }

/// sqrt(1 - x^2 - y^2), without the cancellation in 1 - x^2.
double edge_height(double x, double y) { return std::sqrt(std::max(0.0, (1.0 - x) * (1.0 + x) - y * y)); }

/// Length in angle of the arc on X = x between Y = y and Z = z. It is the difference of two arc tangents,
/// joined into one by the rule for the tangent of a difference: half the cost, and no cancellation.
double arc_angle(double y, double z, double s_xy, double s_xz) {
  return std::atan2(s_xy * s_xz - y * z, y * s_xz + z * s_xy);
}

double quarter_cap(double x) { return pi / 12.0 * (1.0 - x) * (1.0 - x) * (2.0 + x); }

double half_wedge(double x, double y) {
  const double s = edge_height(x, y);
  return (std::atan2(s, x * y) + x * y * s) / 3.0 - arc_weight(x) * std::atan2(s, y) -
         arc_weight(y) * std::atan2(s, x);
}

double full_corner(double x, double y, double z) {
  const double s_xy = edge_height(x, y), s_yz = edge_height(y, z), s_zx = edge_height(x, z);

  // Of the three inner angles alpha, what each lacks of a right angle is taken: the sum needs no big terms.
  const double excess =
      0.5 * pi - std::atan2(x * y, s_xy) - std::atan2(y * z, s_yz) - std::atan2(z * x, s_zx);
  const double arcs = arc_weight(x) * arc_angle(y, z, s_xy, s_zx) +
                      arc_weight(y) * arc_angle(z, x, s_yz, s_xy) +
                      arc_weight(z) * arc_angle(x, y, s_zx, s_yz);
  return (excess + x * y * s_xy + y * z * s_yz + z * x * s_zx) / 3.0 - arcs - x * y * z;
}

/// Q(x,y,z) of the header, for 0 <= x,y,z < 1. Sorted first: the order of the planes cannot change a bit.
double corner(double x, double y, double z) {
  if (x < y) std::swap(x, y);
  if (y < z) std::swap(y, z);
  if (x < y) std::swap(x, y);
  if (x * x + y * y + z * z >= 1.0) return 0.0;
  if (y == 0.0) return quarter_cap(x);
  if (z == 0.0) return half_wedge(x, y);
  return full_corner(x, y, z);
}

/// Squared distances from the centre to the nearest and to the farthest point of the box.
struct Reach {
  double nearest = 0.0, farthest = 0.0;

  void add(double low, double high) {
    const double gap = std::max({0.0, low, -high});
    nearest += gap * gap;
    farthest += std::max(low * low, high * high);
  }
};

}  // namespace

double sphere_volume(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }

double sphere_box_volume(const Sphere& sphere, const Box& box) {
  const double r = sphere.radius;
  const Vec3 width = box.max - box.min;
  if (!(r > 0.0 && width.x > 0.0 && width.y > 0.0 && width.z > 0.0)) return 0.0;

  // In units of the radius, from the centre. Far from or deep inside each other nothing is to be computed.
  const Vec3 low = (box.min - sphere.centre) / r, high = (box.max - sphere.centre) / r;
  const double whole = sphere_volume(r);
  if (least(least(-low.x, -low.y), -low.z) >= 1.0 && least(least(high.x, high.y), high.z) >= 1.0)
    return whole;
  Reach reach;
  for (int axis = 0; axis < 3; ++axis) reach.add(low[axis], high[axis]);
  if (reach.nearest >= 1.0) return 0.0;
  const double box_volume = width.x * width.y * width.z;
  if (reach.farthest <= 1.0) return box_volume;

  const HalfSpaces along_x(low.x, high.x), along_y(low.y, high.y), along_z(low.z, high.z);
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(along_x.count); ++i)
    for (std::size_t j = 0; j < static_cast<std::size_t>(along_y.count); ++j)
      for (std::size_t k = 0; k < static_cast<std::size_t>(along_z.count); ++k)
        sum += along_x.weight[i] * along_y.weight[j] * along_z.weight[k] *
               corner(along_x.distance[i], along_y.distance[j], along_z.distance[k]);
  return std::clamp(sum * r * r * r, 0.0, std::min(whole, box_volume));
}

}  // namespace pulvis::measures
