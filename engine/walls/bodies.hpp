// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/walls/motion.hpp"
#include "engine/walls/surface.hpp"

namespace pulvis {

/// A rigid set of surfaces with one material and, maybe, a motion.
struct Body {
  std::string name;
  std::uint32_t species = 0;
  std::optional<std::size_t> motion;  ///< index of the motion that can move it
};

/// Where a body is at the start and the end of a step. Bodies translate; the displacement is from where the
/// case put them.
struct Pose {
  Vec3 before, now;  ///< m
};

}  // namespace pulvis
