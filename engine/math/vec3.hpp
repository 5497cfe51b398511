// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/scalar.hpp"

namespace pulvis {

/// Three numbers: a point, a velocity, a force. Units are those of what it stands for (SI).
struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  PULVIS_INLINE double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  PULVIS_INLINE double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  PULVIS_INLINE Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  PULVIS_INLINE Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
  PULVIS_INLINE Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

PULVIS_INLINE Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
PULVIS_INLINE Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
PULVIS_INLINE Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
PULVIS_INLINE Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
PULVIS_INLINE Vec3 operator*(const Vec3& a, double s) { return {s * a.x, s * a.y, s * a.z}; }
PULVIS_INLINE Vec3 operator/(const Vec3& a, double s) { return {a.x / s, a.y / s, a.z / s}; }

PULVIS_INLINE double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
PULVIS_INLINE Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PULVIS_INLINE double norm(const Vec3& a) { return root(dot(a, a)); }

}  // namespace pulvis
