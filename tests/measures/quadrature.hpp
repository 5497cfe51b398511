// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "measures/shapes.hpp"

// Slow, independent ways to the volumes and areas under test, in long double. They share no formula with the
// program: areas by walking round the rectangle, volumes by integrating these areas over the height.
namespace pulvis::measures::oracle {

using Real = long double;

/// A point of the plane, seen from the disc's centre.
struct Point {
  Real x, y;
};

inline Real angle_between(Point a, Point b) {
  return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// Signed area that a disc of radius r round the origin shares with the triangle (origin, a, b): along the
/// part of the side a-b inside the disc it is a triangle, elsewhere a sector.
inline Real swept_area(Point a, Point b, Real r) {
  const Point d{b.x - a.x, b.y - a.y};
  const Real dd = d.x * d.x + d.y * d.y;
  if (dd == 0) return 0;
  const Real ad = a.x * d.x + a.y * d.y, cross = a.x * b.y - a.y * b.x;
  const Real discriminant = r * r * dd - cross * cross;
  const auto sector = [&](Point p, Point q) { return r * r * angle_between(p, q) / 2; };
  if (discriminant <= 0) return sector(a, b);

  const Real root = std::sqrt(discriminant);
  const Real enter = std::clamp<Real>((-ad - root) / dd, 0, 1),
             leave = std::clamp<Real>((-ad + root) / dd, 0, 1);
  const auto at = [&](Real t) { return Point{a.x + t * d.x, a.y + t * d.y}; };
  Real area = (leave - enter) * cross / 2;
  if (enter > 0) area += sector(a, at(enter));
  if (leave < 1) area += sector(at(leave), b);
  return area;
}

/// Area shared by a disc of radius r round the origin and the rectangle [x0, x1] x [y0, y1].
inline Real disc_area(Real r, Real x0, Real x1, Real y0, Real y1) {
  if (!(r > 0)) return 0;
  const Point corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  Real area = 0;
  for (int i = 0; i < 4; ++i) area += swept_area(corners[i], corners[(i + 1) % 4], r);
  return area;
}

/// Nodes and weights of Gauss's rule on [-1, 1], by Newton's method on the Legendre polynomial.
struct GaussRule {
  std::vector<Real> nodes, weights;

  explicit GaussRule(int n) {
    for (int i = 0; i < n; ++i) {
      Real x =
          std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.75L) / (static_cast<Real>(n) + 0.5L));
      Real slope = 1;
      for (int step = 0; step < 50; ++step) {
        Real before = 1, value = x;
        for (int k = 2; k <= n; ++k) {
          const Real m = static_cast<Real>(k);
          const Real next = ((2 * m - 1) * x * value - (m - 1) * before) / m;
          before = value;
          value = next;
        }
        slope = static_cast<Real>(n) * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      nodes.push_back(x);
      weights.push_back(2 / ((1 - x * x) * slope * slope));
    }
  }
};

template <class Function>
Real gauss(const Function& f, Real a, Real b) {
  static const GaussRule rule(16);
  Real sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i)
    sum += rule.weights[i] * f((a + b) / 2 + (b - a) / 2 * rule.nodes[i]);
  return sum * (b - a) / 2;
}

template <class Function>
Real adaptive(const Function& f, Real a, Real b, Real whole, int depth) {
  const Real middle = (a + b) / 2;
  const Real left = gauss(f, a, middle), right = gauss(f, middle, b);
  if (depth == 0 || std::abs(left + right - whole) < 1e-15L) return left + right;
  return adaptive(f, a, middle, left, depth - 1) + adaptive(f, middle, b, right, depth - 1);
}

/// Volume shared by the unit ball and a box, to about 1e-14: the area of each slice integrated over z. The
/// area has a kink wherever the slice's circle meets a side or a corner of the rectangle; between these
/// heights the substitution z ~ sin(t) makes it smooth.
inline Real unit_ball_volume(Vec3 low, Vec3 high) {
  const Real x0 = low.x, x1 = high.x, y0 = low.y, y1 = high.y;
  const Real bottom = std::max<Real>(low.z, -1), top = std::min<Real>(high.z, 1);
  if (!(bottom < top)) return 0;
  std::vector<Real> heights{bottom, top};
  for (const Real x : {Real{0}, x0, x1})
    for (const Real y : {Real{0}, y0, y1}) {
      const Real rest = 1 - x * x - y * y;
      if (!(rest >= 0)) continue;
      for (const Real z : {-std::sqrt(rest), std::sqrt(rest)})
        if (bottom < z && z < top) heights.push_back(z);
    }
  std::sort(heights.begin(), heights.end());

  Real volume = 0;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const Real middle = (heights[i] + heights[i + 1]) / 2, half = (heights[i + 1] - heights[i]) / 2;
    const auto slice = [&](Real t) {
      const Real z = middle + half * std::sin(t);
      return disc_area(std::sqrt(std::max<Real>(0, 1 - z * z)), x0, x1, y0, y1) * half * std::cos(t);
    };
    const Real end = std::numbers::pi_v<Real> / 2;
    volume += adaptive(slice, -end, end, gauss(slice, -end, end), 12);
  }
  return volume;
}

/// Volume shared by a sphere and a box, m^3.
inline double sphere_box_volume(const Sphere& sphere, const Box& box) {
  const double r = sphere.radius;
  const Real unit = unit_ball_volume((box.min - sphere.centre) / r, (box.max - sphere.centre) / r);
  return static_cast<double>(unit * static_cast<Real>(r) * r * r);
}

}  // namespace pulvis::measures::oracle
