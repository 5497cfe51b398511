// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string_view>

#include "output/image.hpp"

namespace pulvis {

/// Where the given point lies on the baseline of a text.
enum class TextAlign { left, centre, right };

/// Draws text with the machine's sans-serif font (DejaVu Sans where it is installed).
class Typeface {
 public:
  /// Throws Failure(Exit::io) naming the package to install if the machine has no font.
  Typeface();
  ~Typeface();
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;

  /// Width of a line of UTF-8 text in pixels at the font size `size` (pixels).
  double width(std::string_view text, int size);
  /// Draws a line of UTF-8 text with its baseline at `y`; letters the font lacks show as its box.
  void draw(Image& image, double x, double y, std::string_view text, int size, Colour colour,
            TextAlign align = TextAlign::left);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace pulvis
