// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "engine/math/vec3.hpp"

// Arithmetic with 113 bits (g++'s __float128) for references that the engine's 53 bits are measured against.
namespace pulvis::validation {

using Quad = __float128;

/// pi as the sum of its first 106 bits, since a literal of this type is not standard C++.
inline Quad quad_pi() {
  return static_cast<Quad>(0x1.921fb54442d18p+1) + static_cast<Quad>(0x1.1a62633145c07p-53);
}

inline Quad quad_magnitude(Quad a) { return a < 0 ? -a : a; }

/// Square and cube root by Newton's method from the double result: 15, 30, 34 digits.
inline Quad quad_root(Quad a) {
  if (!(a > 0)) return 0;
  Quad x = std::sqrt(static_cast<double>(a));
  for (int step = 0; step < 3; ++step) x = (x + a / x) / 2;
  return x;
}
inline Quad quad_cube_root(Quad a) {
  if (!(a > 0)) return 0;
  Quad x = std::cbrt(static_cast<double>(a));
  for (int step = 0; step < 3; ++step) x -= (x * x * x - a) / (3 * x * x);
  return x;
}

struct QuadVec {
  Quad x = 0, y = 0, z = 0;
};
inline QuadVec quad(const Vec3& a) { return {a.x, a.y, a.z}; }
inline QuadVec operator+(const QuadVec& a, const QuadVec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline QuadVec operator*(Quad s, const QuadVec& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Quad norm(const QuadVec& a) { return quad_root(dot(a, a)); }

/// Length of the difference between a result and its reference.
inline double distance(const Vec3& result, const QuadVec& reference) {
  return static_cast<double>(norm(quad(result) - reference));
}

}  // namespace pulvis::validation
