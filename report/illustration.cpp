// SPDX-License-Identifier: Apache-2.0
#include "report/illustration.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis::report {
namespace {

bool shows_something(const Figure& figure) {
  for (const Curve& c : figure.curves)
    for (std::size_t k = 0; k < c.x.size(); ++k)
      if (std::isfinite(c.x[k]) && std::isfinite(c.y[k]) && (!figure.log_y || c.y[k] > 0.0)) return true;
  return false;
}

/// gnuplot refuses a logarithmic axis with points at or below zero, and an axis without length.
void make_drawable(Figure& figure) {
  if (figure.log_y)
    for (Curve& c : figure.curves)
      for (double& y : c.y)
        if (!(y > 0.0)) y = std::nan("");
  const auto mend = [](std::optional<Range>& range) {
    if (range && !(range->high > range->low)) range.reset();
  };
  mend(figure.x_range);
  mend(figure.y_range);
}

}  // namespace

std::optional<Illustration> illustrate(Figure figure, std::string caption) {
  if (!shows_something(figure)) return {};
  make_drawable(figure);
  return Illustration{figure.name, figure.title, std::move(caption), figure_script(figure),
                      figure_csv(figure)};
}

std::optional<Illustration> illustrate(FigureSheet sheet, std::string caption) {
  std::erase_if(sheet.panels, [](const Figure& panel) { return !shows_something(panel); });
  if (sheet.panels.empty()) return {};
  for (Figure& panel : sheet.panels) make_drawable(panel);
  return Illustration{sheet.name, sheet.title, std::move(caption), figure_script(sheet), figure_csv(sheet)};
}

std::optional<Illustration> illustrate(HeatMap map, std::string caption) {
  const auto shown = [](const MapPanel& panel) {
    return std::any_of(panel.cells.begin(), panel.cells.end(),
                       [](const MapCell& c) { return std::isfinite(c.value); });
  };
  if (std::none_of(map.panels.begin(), map.panels.end(), shown)) return {};
  return Illustration{map.name, map.title, std::move(caption), figure_script(map), figure_csv(map)};
}

}  // namespace pulvis::report
