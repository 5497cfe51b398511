// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// A turn about an axis, right-handed for n > 0. The rate rises evenly from 0 to n within the ramp t_a and
/// then stays; the angle is
///   n t^2/(2 t_a)   for t < t_a,   n (t - t_a/2)   after   [cycles]
/// Without a ramp the body turns at full rate from the first moment on. Peak rate 2 pi n, peak angular
/// acceleration 2 pi n/t_a (0 without a ramp: a jump).
struct Rotation {
  Vec3 point;          ///< a point of the axis, m
  Vec3 axis{0, 0, 1};  ///< unit vector
  double rate = 0.0;   ///< n, cycles/s
  double ramp = 0.0;   ///< t_a, s

  Rigid displacement(double t) const;
  Peaks peaks() const;
  /// A full turn at full rate, s.
  std::optional<double> cycle() const;
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const;
};

}  // namespace pulvis::motions
