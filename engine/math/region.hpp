// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis {

/// A region of space: a box or a cylinder.
struct Region {
  enum class Shape { box, cylinder };
  Shape shape = Shape::box;
  Vec3 min, max;                      ///< m; box
  Vec3 base, axis{0, 0, 1};           ///< m, -; cylinder: centre of its lower end, unit vector along it
  double radius = 0.0, height = 0.0;  ///< m; cylinder
};

}  // namespace pulvis
