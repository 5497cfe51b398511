// SPDX-License-Identifier: Apache-2.0
#include "output/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "output/colour_map.hpp"
#include "output/png_file.hpp"
#include "output/renderer.hpp"
#include "output/typeface.hpp"

namespace pulvis {
namespace {

constexpr Colour paper{1.0f, 1.0f, 1.0f};
constexpr Colour ink{0.12f, 0.13f, 0.16f};

// Places in a picture follow from its height, so that small pictures keep readable text.
struct Layout {
  int letter, margin;
  Frame scene, bar;

  explicit Layout(const PictureRequest& request) {
    letter = std::max(11, request.height / 46);
    margin = letter;
    const int above = request.title.empty() ? margin : 3 * letter;
    const int below = margin + 3 * letter + (request.caption.empty() ? 0 : 2 * letter);
    const int beside = request.colour_bar ? 7 * letter : margin;
    scene = {margin, above, request.width - margin - beside, request.height - above - below};
    bar = {request.width - beside + letter, above + 3 * letter, letter, scene.height - 4 * letter};
  }
};

// The largest of 1, 2 and 5 times a power of ten that is not above `value`.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= value * (1.0 + 1e-9)) return digit * power;
  return power;
}

std::string length_text(double metres) {
  constexpr std::array<std::pair<double, const char*>, 4> units{
      {{1.0, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}}};
  for (const auto& [size, name] : units)
    if (metres >= 0.9999 * size) return fmt::format("{:.6g} {}", metres / size, name);
  return fmt::format("{:.3g} m", metres);
}

void draw_scale_bar(Image& image, Typeface& typeface, const Layout& layout, double pixel_length) {
  const double length = round_down(0.25 * layout.scene.width * pixel_length);
  const double pixels = length / pixel_length;
  const double left = layout.margin, y = layout.scene.top + layout.scene.height + 1.6 * layout.letter;
  const double tick = 0.3 * layout.letter, thickness = std::max(1.5, 0.09 * layout.letter);
  image.line(left, y, left + pixels, y, thickness, ink);
  for (const double x : {left, left + pixels}) image.line(x, y - tick, x, y + tick, thickness, ink);
  typeface.draw(image, left + 0.5 * pixels, y + 1.3 * layout.letter, length_text(length), layout.letter, ink,
                TextAlign::centre);
}

void draw_colour_bar(Image& image, Typeface& typeface, const Layout& layout, const ColourBar& bar) {
  const Frame& place = layout.bar;
  for (int row = 0; row < place.height; ++row) {
    const float value = 1.0f - (static_cast<float>(row) + 0.5f) / static_cast<float>(place.height);
    image.fill(place.left, place.top + row, place.width, 1, viridis(value));
  }
  const double left = place.left, right = left + place.width, top = place.top, bottom = top + place.height;
  image.line(left, top, right, top, 1.0, ink);
  image.line(left, bottom, right, bottom, 1.0, ink);
  image.line(left, top, left, bottom, 1.0, ink);
  image.line(right, top, right, bottom, 1.0, ink);
  const double edge = image.width() - 0.5 * layout.letter;
  const double label_left = std::min(left, edge - typeface.width(bar.label, layout.letter));
  typeface.draw(image, label_left, top - 1.2 * layout.letter, bar.label, layout.letter, ink);

  const double range = bar.maximum - bar.minimum;
  const auto tick = [&](double value, double y) {
    image.line(right, y, right + 0.3 * layout.letter, y, 1.0, ink);
    typeface.draw(image, right + 0.6 * layout.letter, y + 0.36 * layout.letter, fmt::format("{:.4g}", value),
                  layout.letter, ink);
  };
  if (!(range > 0.0) || !std::isfinite(range)) return tick(bar.minimum, 0.5 * (top + bottom));
  const double step = round_down(range / 4.0);
  for (double number = std::ceil(bar.minimum / step - 1e-9); number * step <= bar.maximum + 1e-9 * range;
       ++number)
    tick(number * step + 0.0,
         bottom - (number * step - bar.minimum) / range * place.height);  // + 0: never "-0"
}

}  // namespace

Image draw_picture(const PictureRequest& request) {
  constexpr int largest = 16384;  // pixels per edge
  if (request.width < 400 || request.height < 300 || std::max(request.width, request.height) > largest)
    throw std::invalid_argument("a picture has 400 x 300 to 16384 x 16384 pixels");
  const Layout layout(request);
  Image image(request.width, request.height, paper);
  Typeface typeface;  // first: a missing font should not show only after the rendering
  const PictureGeometry geometry = picture_geometry(request);
  const Camera camera = camera_for(geometry, request.up, layout.scene);
  render(image, layout.scene, geometry, camera, request.threads);

  typeface.draw(image, layout.margin, 1.9 * layout.letter, request.title, 5 * layout.letter / 4, ink);
  typeface.draw(image, layout.margin, request.height - layout.margin, request.caption, layout.letter, ink);
  draw_scale_bar(image, typeface, layout, camera.pixel * geometry.unit);
  if (request.colour_bar) draw_colour_bar(image, typeface, layout, *request.colour_bar);
  return image;
}

void write_picture(const std::string& path, const PictureRequest& request) {
  write_png(path, draw_picture(request));
}

}  // namespace pulvis
