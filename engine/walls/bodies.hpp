// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/rigid.hpp"
#include "engine/walls/faceted_wall.hpp"
#include "engine/walls/surface.hpp"

namespace pulvis {

/// What moves as one: surfaces that do not move against each other. Its frame is that of the domain while
/// none of its motions has begun.
struct Body {
  std::string name;
  std::vector<std::size_t> motions;  ///< indices; the first is carried by the second, and so on
};

/// All walls of a run: surfaces (of shapes and of meshes) in the frames of their bodies.
struct Walls {
  std::vector<Surface> surfaces;
  std::vector<FacetedWall> meshes;
  std::vector<Body> bodies;
  std::vector<std::string> names;  ///< of the walls; each has one or more surfaces
};

/// Where a body is at the start and the end of a step.
struct Pose {
  Rigid before, now;
  Vec3 spin;            ///< rad/s, mean over the step
  bool turns = false;   ///< it turned in this step
  bool absent = false;  ///< it is not there: nothing touches it

  static Pose of_step(const Rigid& before, const Rigid& now, double dt) {
    Pose pose{before, now, {}, false, false};
    for (int i = 0; i < 3; ++i) pose.turns = pose.turns || !(before.row[i] == now.row[i]);
    if (pose.turns) pose.spin = turned_between(before, now) / dt;
    return pose;
  }
  /// Velocity of the body's point `at` (in its frame), mean over the step, m/s: so overlaps change as the
  /// surfaces do.
  Vec3 velocity(const Vec3& at, double dt) const {
    Vec3 way = now.shift - before.shift;
    if (turns)
      way += Vec3{dot(now.row[0] - before.row[0], at), dot(now.row[1] - before.row[1], at),
                  dot(now.row[2] - before.row[2], at)};
    return way / dt;
  }
};

}  // namespace pulvis
