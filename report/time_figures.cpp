// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "report/illustration.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

struct Line {
  const char* column;
  const char* label;
};

/// One plot over time: from which table and columns; only the first column is shown where runs are compared.
struct Plot {
  const char* title;
  const char* unit;
  std::vector<Line> lines;
  bool from_log = false, logarithmic = false;
};

const std::vector<Plot>& plots() {
  static const std::vector<Plot> list = {
      {"porosity",
       "1",
       {{"porosity_mean", "mean"},
        {"porosity_lower_half", "lower half"},
        {"porosity_upper_half", "upper half"}}},
      {"mass in the die", "kg", {{"fill_mass_kg", ""}}},
      {"height of the surface", "m", {{"free_surface_height_mean_m", ""}}},
      {"kinetic energy", "J", {{"kinetic_energy_J", ""}}, true, true},
      {"largest wall pressure", "Pa", {{"wall_pressure_max_Pa", ""}}},
      {"contacts per parcel", "1", {{"coordination_mean", ""}}},
  };
  return list;
}

double last_time(const RunData& run) {
  double end = 0.0;
  for (const auto* table : {&run.log, &run.series})
    if (*table) end = std::max(end, largest_of((*table)->numbers("time_s")));
  return end;
}

struct Raw {
  std::string label;
  std::vector<double> time, value;
};

std::vector<Raw> raw_curves(const Plot& plot, const std::vector<const RunData*>& runs) {
  std::vector<Raw> list;
  for (const RunData* run : runs) {
    const auto& table = plot.from_log ? run->log : run->series;
    if (!table) continue;
    for (const Line& line : plot.lines) {
      if (table->has(line.column))
        list.push_back({runs.size() > 1 ? run->label : line.label, table->numbers("time_s"),
                        table->numbers(line.column)});
      if (runs.size() > 1) break;
    }
  }
  // A table without times shows nothing.
  std::erase_if(list, [](const Raw& r) { return r.time.size() != r.value.size(); });
  return list;
}

/// Flows through the surfaces of the case, which name their columns themselves.
Plot flow_plot(const RunData& run, std::vector<std::string>& names) {
  Plot plot{"flow through surfaces", "kg/s", {}};
  if (!run.series) return plot;
  for (const std::string& column : run.series->columns())
    if (column.starts_with("flow_") && column.ends_with("_kg_s")) names.push_back(column);
  for (const std::string& name : names) plot.lines.push_back({name.c_str(), name.c_str()});
  return plot;
}

}  // namespace

std::optional<Illustration> time_series(const std::vector<const RunData*>& runs) {
  FigureSheet sheet{"time-series", "Over time", {}, 1, 700, 150, false};
  double end = 0.0;
  for (const RunData* run : runs) end = std::max(end, last_time(*run));
  const DisplayUnit time = display_unit(end, "s");
  std::vector<Plot> all = plots();
  std::vector<std::string> flow_names;
  if (runs.size() == 1) all.push_back(flow_plot(*runs.front(), flow_names));
  for (const Plot& plot : all) {
    const std::vector<Raw> raw = raw_curves(plot, runs);
    double largest = 0.0;
    for (const Raw& r : raw) largest = std::max(largest, largest_of(r.value));
    const DisplayUnit unit = display_unit(largest, plot.unit);
    Figure panel{"", plot.title, with_unit("time", time), with_unit(plot.title, unit),
                 {}, false,      plot.logarithmic};
    panel.x_range = Range{0.0, end * time.factor};
    for (const Raw& r : raw) panel.curves.push_back({r.label, scaled(r.time, time), scaled(r.value, unit)});
    if (runs.size() == 1)
      for (const PhaseData& phase : runs.front()->phases)
        if (std::isfinite(phase.start))
          panel.marks.push_back({phase.start * time.factor, sheet.panels.empty() ? phase.name : ""});
    if (!panel.curves.empty()) sheet.panels.push_back(std::move(panel));
  }
  return illustrate(std::move(sheet), runs.size() == 1
                                          ? "Dotted lines: where phases begin."
                                          : "Each run from its beginning; phases may differ in length.");
}

}  // namespace pulvis::report
