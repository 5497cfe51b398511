// SPDX-License-Identifier: Apache-2.0
#include "output/image.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis {
namespace {

std::uint8_t to_byte(float part) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(part, 0.0f, 1.0f)));
}

}  // namespace

Image::Image(int width, int height, Colour background)
    : width_(width), height_(height), rgb_(3 * static_cast<std::size_t>(width) * height) {
  fill(0, 0, width, height, background);
}

void Image::set(int x, int y, Colour colour) {
  if (!holds(x, y)) return;
  std::uint8_t* rgb = pixel(x, y);
  rgb[0] = to_byte(colour.red);
  rgb[1] = to_byte(colour.green);
  rgb[2] = to_byte(colour.blue);
}

Colour Image::at(int x, int y) const {
  const std::uint8_t* rgb = rgb_.data() + 3 * (static_cast<std::size_t>(y) * width_ + x);
  return {static_cast<float>(rgb[0]) / 255.0f, static_cast<float>(rgb[1]) / 255.0f,
          static_cast<float>(rgb[2]) / 255.0f};
}

void Image::blend(int x, int y, Colour colour, float cover) {
  if (!holds(x, y)) return;
  const Colour under = at(x, y);
  set(x, y,
      {std::lerp(under.red, colour.red, cover), std::lerp(under.green, colour.green, cover),
       std::lerp(under.blue, colour.blue, cover)});
}

void Image::fill(int x, int y, int width, int height, Colour colour) {
  for (int row = std::max(y, 0); row < std::min(y + height, height_); ++row)
    for (int column = std::max(x, 0); column < std::min(x + width, width_); ++column)
      set(column, row, colour);
}

void Image::line(double x0, double y0, double x1, double y1, double thickness, Colour colour) {
  const double half = 0.5 * thickness;
  const double length_squared = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
  const auto low = [&](double a, double b) {
    return static_cast<int>(std::floor(std::min(a, b) - half - 1.0));
  };
  const auto high = [&](double a, double b) {
    return static_cast<int>(std::ceil(std::max(a, b) + half + 1.0));
  };
  for (int y = low(y0, y1); y <= high(y0, y1); ++y) {
    for (int x = low(x0, x1); x <= high(x0, x1); ++x) {
      const double px = x + 0.5 - x0, py = y + 0.5 - y0;
      const double along = length_squared > 0.0
                               ? std::clamp((px * (x1 - x0) + py * (y1 - y0)) / length_squared, 0.0, 1.0)
                               : 0.0;
      const double distance = std::hypot(px - along * (x1 - x0), py - along * (y1 - y0));
      blend(x, y, colour, static_cast<float>(std::clamp(half + 0.5 - distance, 0.0, 1.0)));
    }
  }
}

}  // namespace pulvis
