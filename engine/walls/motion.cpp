// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motion.hpp"

#include "engine/math/functions.hpp"

namespace pulvis {

Vec3 SineMotion::displacement(double t) const {
  return (amplitude * (sine_of_cycles(frequency * t + phase) - sine_of_cycles(phase))) * direction;
}

}  // namespace pulvis
