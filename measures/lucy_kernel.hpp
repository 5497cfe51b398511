// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis::measures {

/// Lucy's polynomial, a smooth weight of integral 1 over space that ends at the distance c:
///   W(r) = 105/(16 pi c^3) (1 + 3 r/c) (1 - r/c)^3  for r < c, else 0;  1/m^3.
/// Twice continuously differentiable. L. B. Lucy, The Astronomical Journal 82 (1977) 1013-1024,
/// doi:10.1086/112164.
class LucyKernel {
 public:
  /// `support`: c, m. Throws std::invalid_argument unless it is above zero.
  explicit LucyKernel(double support);

  double support() const { return support_; }

  /// W at the distance from the middle whose square is given, 1/m^3.
  double at(double squared_distance) const;

  /// Mean of W(point - y) over the places y on a straight line, 1/m^3: integral of ds from 0 to 1 with
  /// y = from + s (to - from). Exact but for rounding: with t along the line, a its distance from the point,
  /// r^2 = a^2 + t^2 and c = 1,
  ///   W = W(0) (1 - 6 r^2 + 8 r^3 - 3 r^4),
  ///   integral of r^3 dt = t r^3/4 + 3 a^2 t r/8 + (3 a^4/8) ln(t + r).
  double along(const Vec3& point, const Vec3& from, const Vec3& to) const;

 private:
  double support_, peak_;
};

}  // namespace pulvis::measures
