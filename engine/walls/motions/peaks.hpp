// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis::motions {

/// The largest values a motion reaches if nothing cuts it short. A jump of the velocity, as where a motion
/// without a ramp begins, has no acceleration and is not counted.
struct Peaks {
  double speed = 0.0;                 ///< m/s
  double acceleration = 0.0;          ///< m/s^2
  double rate = 0.0;                  ///< of turning, rad/s; a point at the distance r moves at rate * r
  double angular_acceleration = 0.0;  ///< rad/s^2
  Vec3 point{};                       ///< of the axis of turning, m
  Vec3 axis{};                        ///< of turning, unit vector
};

}  // namespace pulvis::motions
