// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/illustration.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

constexpr const char* axis_names[] = {"first", "second", "third"};
constexpr const char* axis_words[] = {"first axis", "second axis", "height"};

double length_of(const PorosityGrid& g, int axis) {
  return static_cast<double>(g.cells[axis]) * g.spacing[axis];
}

std::vector<const PorosityGrid*> grids_of(const Beside& list) {
  std::vector<const PorosityGrid*> grids;
  for (const Labelled& one : list)
    if (one.phase->detail && one.phase->detail->porosity) grids.push_back(&*one.phase->detail->porosity);
  return grids;
}

DisplayUnit length_unit(const std::vector<const PorosityGrid*>& grids) {
  double longest = 0.0;
  for (const PorosityGrid* g : grids)
    for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, length_of(*g, axis));
  return display_unit(longest, "m");
}

/// Half the height of the lowest powder, m: a level cut there meets powder in all grids.
double middle_of_powder(const std::vector<const PorosityGrid*>& grids) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const PorosityGrid* g : grids) {
    std::size_t layers = 0;
    for (std::size_t k = 0; k < g->values.size(); ++k)
      if (std::isfinite(g->values[k])) layers = k / (g->cells[0] * g->cells[1]) + 1;
    if (layers > 0) lowest = std::min(lowest, 0.5 * static_cast<double>(layers) * g->spacing[2]);
  }
  return std::isfinite(lowest) ? lowest : 0.0;
}

/// The cells at `cut` m along an axis, seen along it.
MapPanel cut_of(const PorosityGrid& g, const std::string& label, int across, double cut,
                const DisplayUnit& unit) {
  const int right = across == 0 ? 1 : 0, up = across == 2 ? 1 : 2;
  std::size_t at[3]{};
  at[across] = std::min(static_cast<std::size_t>(cut / g.spacing[across]), g.cells[across] - 1);
  const double place = (static_cast<double>(at[across]) + 0.5) * g.spacing[across] * unit.factor;
  MapPanel panel;
  panel.title = fmt::format("{}{} at {:.3g} {}", label.empty() ? "" : label + ": ", axis_words[across], place,
                            unit.name);
  panel.x_label = with_unit(axis_words[right], unit);
  panel.y_label = with_unit(axis_words[up], unit);
  panel.x = {0.0, length_of(g, right) * unit.factor};
  panel.y = {0.0, length_of(g, up) * unit.factor};
  const double width = g.spacing[right] * unit.factor, height = g.spacing[up] * unit.factor;
  for (at[up] = 0; at[up] < g.cells[up]; ++at[up])
    for (at[right] = 0; at[right] < g.cells[right]; ++at[right])
      panel.cells.push_back({(static_cast<double>(at[right]) + 0.5) * width,
                             (static_cast<double>(at[up]) + 0.5) * height, width, height,
                             g.values[at[0] + g.cells[0] * (at[1] + g.cells[1] * at[2])]});
  return panel;
}

/// Of those that have a map.
std::vector<std::string> labels_of(const Beside& list) {
  std::vector<std::string> labels;
  for (const Labelled& one : list)
    if (one.phase->detail && one.phase->detail->porosity) labels.push_back(one.label);
  return labels;
}

/// Cuts across some axes of every grid, all in the same scale.
HeatMap cuts(const Beside& list, std::initializer_list<int> axes) {
  HeatMap map;
  const std::vector<const PorosityGrid*> grids = grids_of(list);
  const std::vector<std::string> labels = labels_of(list);
  const DisplayUnit unit = length_unit(grids);
  const double level = middle_of_powder(grids);
  for (std::size_t k = 0; k < grids.size(); ++k)
    for (const int across : axes)
      map.panels.push_back(cut_of(*grids[k], list.size() > 1 ? labels[k] : "", across,
                                  across == 2 ? level : 0.5 * length_of(*grids[k], across), unit));
  map.bar_label = "porosity";
  map.scale = range_of_values(map.panels);
  return map;
}

}  // namespace

std::optional<Illustration> porosity_cuts(const Beside& list) {
  HeatMap map = cuts(list, {1, 0, 2});
  map.name = "porosity-cuts";
  map.title = "Porosity in three cuts through the middle of the powder";
  map.columns = 3;
  return illustrate(
      std::move(map),
      "Yellow is loose, dark blue is dense; all cuts have the same scale. White: no powder, or less than "
      "half of the cell is below its surface.");
}

std::optional<Illustration> porosity_upright_cuts(const Beside& list) {
  HeatMap map = cuts(list, {1});
  const std::vector<std::string> labels = labels_of(list);
  map.name = "porosity-phases";
  map.title = "Porosity in the upright cut across the second axis, after each phase";
  for (std::size_t k = 0; k < map.panels.size(); ++k) map.panels[k].title = labels[k];
  map.columns = 4;
  return illustrate(std::move(map), "The same scale for all phases.");
}

std::optional<Illustration> porosity_profiles(const Beside& list) {
  FigureSheet sheet{"porosity-profiles", "Porosity along the axes of the die", {}, 3, 250, 250, true};
  double longest = 0.0;
  Range shown{1.0, 0.0};
  for (const Labelled& one : list)
    if (one.phase->detail)
      for (const PorosityProfile& p : one.phase->detail->profiles) {
        longest = std::max(longest, largest_of(p.position));
        for (const double v : p.porosity)
          if (std::isfinite(v)) shown = {std::min(shown.low, v), std::max(shown.high, v)};
      }
  const DisplayUnit unit = display_unit(longest, "m");
  const double margin = 0.05 * (shown.high - shown.low);
  for (int axis = 0; axis < 3; ++axis) {
    Figure panel{
        "", fmt::format("along the {}", axis_words[axis]), with_unit(axis_words[axis], unit), "porosity", {}};
    if (shown.high > shown.low) panel.y_range = Range{shown.low - margin, shown.high + margin};
    double end = 0.0;
    for (const Labelled& one : list) {
      Curve curve{one.label, {}, {}};
      if (const auto* p = one.phase->detail ? one.phase->detail->profile(axis_names[axis]) : nullptr) {
        curve.x = scaled(p->position, unit), curve.y = p->porosity;
        // The first slice begins at 0, and the last ends as far beyond its middle.
        if (!curve.x.empty()) end = std::max(end, curve.x.back() + curve.x.front());
      }
      panel.curves.push_back(std::move(curve));
    }
    panel.x_range = Range{0.0, end};
    sheet.panels.push_back(std::move(panel));
  }
  return illustrate(std::move(sheet), "Each point is a slice across the axis, up to the powder's surface.");
}

std::optional<Illustration> porosity_histogram(const Beside& list) {
  Figure figure{
      "porosity-histogram", "How much powder has which porosity", "porosity", "share of the volume", {}};
  Range shown{1e300, -1e300};
  for (const Labelled& one : list) {
    if (!one.phase->detail || !one.phase->detail->porosity_histogram) continue;
    const Histogram& h = *one.phase->detail->porosity_histogram;
    Curve curve{one.label, h.edges, h.heights, false, true};
    curve.y.push_back(0.0);
    for (std::size_t k = 0; k < h.heights.size(); ++k)
      if (h.heights[k] > 0.0) shown = {std::min(shown.low, h.edges[k]), std::max(shown.high, h.edges[k + 1])};
    figure.curves.push_back(std::move(curve));
  }
  const double margin = 0.05 * (shown.high - shown.low);
  if (shown.high > shown.low) figure.x_range = Range{shown.low - margin, shown.high + margin};
  return illustrate(std::move(figure), "The narrower, the more uniform the powder.");
}

}  // namespace pulvis::report
