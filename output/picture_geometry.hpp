// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "output/picture.hpp"
#include "output/ray_scene.hpp"

namespace pulvis {

using Segment = std::array<Vec3, 2>;

/// What remains of a picture's scene behind the cut, moved and scaled into a ball of radius one around the
/// origin: rays are traced in single precision, and parcels may be micrometres across.
struct PictureGeometry {
  std::vector<Ball> spheres;
  std::vector<float> sphere_values;
  std::vector<Ball> discs;  ///< where the cut goes through spheres
  std::vector<float> disc_values;
  std::vector<Vec3> wall_corners;  ///< three for each triangle
  std::vector<Segment> edges;      ///< sharp and open edges of the walls
  std::vector<Segment> sections;   ///< where the cut goes through walls
  std::optional<CutPlane> cut;     ///< scaled, with a normal of length one
  double unit = 1.0;               ///< m, length of one in the scaled scene
  double mean_radius = 0.0;        ///< of the spheres, scaled
};

/// Throws std::invalid_argument for a sphere without a finite place and a positive radius.
PictureGeometry picture_geometry(const PictureRequest& request);

}  // namespace pulvis
