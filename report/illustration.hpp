// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/figure.hpp"
#include "output/heat_map.hpp"
#include "report/run_data.hpp"

namespace pulvis::report {

/// A figure that is ready to be drawn, with its data and what the page says below it.
struct Illustration {
  std::string name;  ///< of its files
  std::string title, caption;
  std::string script, csv;
};

/// Nothing if no curve or map has a point to show.
std::optional<Illustration> illustrate(Figure figure, std::string caption);
std::optional<Illustration> illustrate(FigureSheet sheet, std::string caption);
std::optional<Illustration> illustrate(HeatMap map, std::string caption);

/// What a figure sets beside each other: the phases of one run, or the same phase of several.
struct Labelled {
  std::string label;
  const PhaseData* phase = nullptr;
};
using Beside = std::vector<Labelled>;

// The figures. Each shows what there is of `list` in the same scales, or is nothing.
std::optional<Illustration> porosity_cuts(const Beside& list);          ///< three cuts through the middle
std::optional<Illustration> porosity_upright_cuts(const Beside& list);  ///< one of them, for many
std::optional<Illustration> porosity_profiles(const Beside& list);
std::optional<Illustration> porosity_histogram(const Beside& list);
std::optional<Illustration> surface_maps(const Beside& list);
std::optional<Illustration> surface_profiles(const Beside& list);
std::optional<Illustration> wall_pressure_maps(const Beside& list);
std::optional<Illustration> coordination_histogram(const Beside& list);
std::optional<Illustration> contact_force_distribution(const Beside& list);
std::optional<Illustration> layer_profiles(const Beside& list);

/// Measures over time: of one run with its halves and the borders of its phases, of several without.
std::optional<Illustration> time_series(const std::vector<const RunData*>& runs);

}  // namespace pulvis::report
