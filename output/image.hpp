// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pulvis {

/// A colour as it is stored in pictures (sRGB), each part 0 to 1.
struct Colour {
  float red = 0.0f, green = 0.0f, blue = 0.0f;
};

/// Pixels from the upper left corner, row by row.
class Image {
 public:
  Image(int width, int height, Colour background);

  int width() const { return width_; }
  int height() const { return height_; }
  const std::vector<std::uint8_t>& rgb() const { return rgb_; }

  void set(int x, int y, Colour colour);
  /// Lays `colour` over the pixel, 0 (no change) to 1 (replaced). Outside the image nothing happens.
  void blend(int x, int y, Colour colour, float cover);
  Colour at(int x, int y) const;

  /// A rectangle of pixels with whole coordinates; parts outside are left out.
  void fill(int x, int y, int width, int height, Colour colour);
  /// A smooth line of `thickness` pixels between points in pixels (pixel centres at .5).
  void line(double x0, double y0, double x1, double y1, double thickness, Colour colour);

 private:
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  std::uint8_t* pixel(int x, int y) { return rgb_.data() + 3 * (static_cast<std::size_t>(y) * width_ + x); }

  int width_, height_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace pulvis
