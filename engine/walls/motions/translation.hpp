// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// Constant velocity from the first moment on: displacement v t [m].
struct Translation {
  Vec3 velocity;  ///< v, m/s

  Rigid displacement(double t) const { return Rigid::translation(t * velocity); }
  Peaks peaks() const { return {.speed = norm(velocity)}; }
  std::optional<double> cycle() const { return std::nullopt; }
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const { return unless_finite("velocity", velocity); }
};

}  // namespace pulvis::motions
