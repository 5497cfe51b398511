// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "output/image.hpp"
#include "output/picture_geometry.hpp"

namespace pulvis {

/// A part of an image, in pixels.
struct Frame {
  int left, top, width, height;
};

/// A parallel projection: `right` and `up` lie in the picture, `forward` points into it.
struct Camera {
  Vec3 right, up, forward;
  double centre_right = 0.0, centre_up = 0.0;  ///< what the middle of the frame shows
  double pixel = 1.0;                          ///< edge of a pixel in the scaled scene
};

/// Looks obliquely from above into the cut, with the whole scene in the frame. `up` is against gravity.
Camera camera_for(const PictureGeometry& geometry, const Vec3& up, const Frame& frame);

/// Draws the scene into the frame: one key light with soft shadows, ambient occlusion, discs of the cut
/// plain. Directions of rays come from a fixed sequence and the pixel, not from threads or time.
void render(Image& image, const Frame& frame, const PictureGeometry& geometry, const Camera& camera,
            int threads);

}  // namespace pulvis
