// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// Passes to and fro, as of a feeding shoe: the first there, the second back, and so on, each over the
/// distance L from rest to rest, with a pause between them.
///
/// A pass speeds up with a, keeps the speed v and slows down with a:
///   x = a t^2/2   up to t_a = v/a,   v (t - t_a/2)   up to T - t_a,   L - a (T - t)^2/2   up to T
/// with T = L/v + v/a [s]. A distance below v^2/a leaves no time for v: then t_a = sqrt(L/a), T = 2 t_a, and
/// the peak speed is sqrt(a L). At the end of a pass the body stands at 0 or L exactly.
struct Stroke {
  double distance = 0.0;      ///< L, m
  Vec3 direction{1, 0, 0};    ///< unit vector
  double speed = 0.0;         ///< v, m/s
  double acceleration = 0.0;  ///< a, m/s^2
  int passes = 1;
  double pause = 0.0;  ///< s

  Rigid displacement(double t) const;
  Peaks peaks() const;
  std::optional<double> cycle() const { return std::nullopt; }
  std::optional<double> duration() const;
  Fault fault() const;
};

}  // namespace pulvis::motions
