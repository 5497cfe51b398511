// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/functions.hpp"
#include "engine/math/vec3.hpp"

namespace pulvis {

/// A rigid displacement: x -> (turn of x) + shift. The turn is held by its three rows. With the turn of the
/// identity it moves points to the same bits as adding the shift would.
struct Rigid {
  Vec3 row[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3 shift;  ///< m

  static Rigid translation(const Vec3& by) {
    Rigid r;
    r.shift = by;
    return r;
  }
  /// By `cycles` (1 is a full turn, right-handed) about the axis through `point` along the unit vector `axis`
  /// (O. Rodrigues' formula).
  static Rigid rotation(double cycles, const Vec3& point, const Vec3& axis) {
    const double c = cosine_of_cycles(cycles), s = sine_of_cycles(cycles), rest = 1.0 - c;
    Rigid r;
    r.row[0] = rest * axis.x * axis + Vec3{c, -s * axis.z, s * axis.y};
    r.row[1] = rest * axis.y * axis + Vec3{s * axis.z, c, -s * axis.x};
    r.row[2] = rest * axis.z * axis + Vec3{-s * axis.y, s * axis.x, c};
    r.shift = point - r.turn(point);
    return r;
  }

  Vec3 turn(const Vec3& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
  Vec3 turn_back(const Vec3& v) const { return v.x * row[0] + v.y * row[1] + v.z * row[2]; }
  Vec3 operator()(const Vec3& x) const { return turn(x) + shift; }
  /// The point that is moved to `x`.
  Vec3 back(const Vec3& x) const { return turn_back(x - shift); }

  friend bool operator==(const Rigid&, const Rigid&) = default;
};

/// First `inner`, then `outer`.
inline Rigid operator*(const Rigid& outer, const Rigid& inner) {
  Rigid r;
  const Vec3 column[3] = {{inner.row[0].x, inner.row[1].x, inner.row[2].x},
                          {inner.row[0].y, inner.row[1].y, inner.row[2].y},
                          {inner.row[0].z, inner.row[1].z, inner.row[2].z}};
  for (int i = 0; i < 3; ++i)
    r.row[i] = {dot(outer.row[i], column[0]), dot(outer.row[i], column[1]), dot(outer.row[i], column[2])};
  r.shift = outer(inner.shift);
  return r;
}

/// Small turn from `before` to `now` as a vector along its axis, rad; off by its cube over six.
inline Vec3 turned_between(const Rigid& before, const Rigid& now) {
  // Off-diagonal elements of now.turn * transposed before.turn.
  const auto element = [&](int i, int k) { return dot(now.row[i], before.row[k]); };
  return 0.5 *
         Vec3{element(2, 1) - element(1, 2), element(0, 2) - element(2, 0), element(1, 0) - element(0, 1)};
}

}  // namespace pulvis
