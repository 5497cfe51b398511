// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/math/vec3.hpp"
#include "output/image.hpp"
#include "output/vtk.hpp"

namespace pulvis {

/// A parcel in a picture; lengths in m.
struct PictureSphere {
  Vec3 centre;
  double radius = 0.0;
  float value = 0.0f;  ///< 0 to 1 along the colour map; NaN is grey
};

/// Takes away all on the side that `normal` (of any length) points to. Spheres are cut through: their discs
/// show the plain colour of the map, so that the voids between them stand out.
struct CutPlane {
  Vec3 point;  ///< m
  Vec3 normal;
};

/// What the values 0 and 1 of the spheres stand for.
struct ColourBar {
  std::string label;  ///< with its unit: "speed (mm/s)"
  double minimum = 0.0, maximum = 1.0;
};

struct PictureRequest {
  std::vector<PictureSphere> spheres;
  SurfaceMesh walls;  ///< seen through where they stand in front
  std::optional<CutPlane> cut;
  std::optional<ColourBar> colour_bar;
  std::string title, caption;      ///< above and below; UTF-8, either may be empty
  Vec3 up{0.0, 0.0, 1.0};          ///< against gravity
  int width = 1200, height = 900;  ///< pixels, at least 400 x 300
  int threads = 0;                 ///< 0: all there are
};

/// Draws the scene from obliquely above, looking into the cut (without one along +y), in parallel projection
/// so that the scale bar holds everywhere. The same request gives the same picture with any number of
/// threads. Throws std::invalid_argument for a size, radius or position that makes no sense and
/// Failure(Exit::io) where the machine has no font.
Image draw_picture(const PictureRequest& request);

/// Writes `draw_picture(request)` as a PNG; Failure(Exit::io) if that fails.
void write_picture(const std::string& path, const PictureRequest& request);

}  // namespace pulvis
