// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "report/illustration.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

const FreeSurface* surface_of(const Labelled& one) {
  return one.phase->detail && one.phase->detail->surface ? &*one.phase->detail->surface : nullptr;
}

/// One unit for lengths and one for heights of all surfaces.
struct Units {
  DisplayUnit length, height;
  explicit Units(const Beside& list) {
    double longest = 0.0, highest = 0.0;
    for (const Labelled& one : list)
      if (const FreeSurface* s = surface_of(one)) {
        for (int axis = 0; axis < 2; ++axis)
          longest = std::max(longest, static_cast<double>(s->columns[axis]) * s->spacing[axis]);
        highest = std::max(highest, largest_of(s->heights));
      }
    length = display_unit(longest, "m");
    height = display_unit(highest, "m");
  }
};

/// The mean over the other axis, of the columns that have a height.
Curve mean_heights(const FreeSurface& s, const std::string& label, int axis, const Units& units) {
  Curve curve{label, {}, {}};
  for (std::size_t a = 0; a < s.columns[axis]; ++a) {
    double sum = 0.0, count = 0.0;
    for (std::size_t b = 0; b < s.columns[1 - axis]; ++b) {
      const double h = s.heights[axis == 0 ? a + s.columns[0] * b : b + s.columns[0] * a];
      if (std::isfinite(h)) sum += h, count += 1.0;
    }
    curve.x.push_back((static_cast<double>(a) + 0.5) * s.spacing[axis] * units.length.factor);
    curve.y.push_back(count > 0.0 ? sum / count * units.height.factor : std::nan(""));
  }
  return curve;
}

}  // namespace

std::optional<Illustration> surface_maps(const Beside& list) {
  const Units units(list);
  HeatMap map{
      "surface-height", "Height of the powder's surface", with_unit("height", units.height), {}, 3, {}};
  for (const Labelled& one : list) {
    const FreeSurface* s = surface_of(one);
    if (!s) continue;
    const double w = s->spacing[0] * units.length.factor, h = s->spacing[1] * units.length.factor;
    MapPanel panel{one.label,
                   with_unit("first axis", units.length),
                   with_unit("second axis", units.length),
                   {0.0, w * static_cast<double>(s->columns[0])},
                   {0.0, h * static_cast<double>(s->columns[1])},
                   {}};
    for (std::size_t j = 0; j < s->columns[1]; ++j)
      for (std::size_t i = 0; i < s->columns[0]; ++i)
        panel.cells.push_back({(static_cast<double>(i) + 0.5) * w, (static_cast<double>(j) + 0.5) * h, w, h,
                               s->heights[i + s->columns[0] * j] * units.height.factor});
    map.panels.push_back(std::move(panel));
  }
  map.scale = range_of_values(map.panels);
  return illustrate(std::move(map),
                    "Seen from above; the same scale for all. Heights count from the floor of the die.");
}

std::optional<Illustration> surface_profiles(const Beside& list) {
  const Units units(list);
  FigureSheet sheet{
      "surface-profiles", "Height of the surface, mean over the other axis", {}, 2, 380, 230, true};
  Range shown{1e300, -1e300};
  for (int axis = 0; axis < 2; ++axis) {
    const char* words = axis == 0 ? "first axis" : "second axis";
    Figure panel{"",
                 fmt::format("along the {}", words),
                 with_unit(words, units.length),
                 with_unit("height", units.height),
                 {}};
    for (const Labelled& one : list)
      if (const FreeSurface* s = surface_of(one))
        panel.curves.push_back(mean_heights(*s, one.label, axis, units));
    for (const Curve& c : panel.curves)
      for (const double y : c.y)
        if (std::isfinite(y)) shown = {std::min(shown.low, y), std::max(shown.high, y)};
    sheet.panels.push_back(std::move(panel));
  }
  const double margin = 0.05 * (shown.high - shown.low);
  if (shown.high > shown.low)
    for (Figure& panel : sheet.panels) panel.y_range = Range{shown.low - margin, shown.high + margin};
  return illustrate(std::move(sheet), "The scale of heights does not begin at zero.");
}

}  // namespace pulvis::report
