// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace pulvis {

/// One set of points of a figure; drawn as a line, or as points where they were measured.
struct Curve {
  std::string label;
  std::vector<double> x, y;
  bool points = false;
};

/// A plot of curves over one abscissa. Labels carry their unit: "overlap (m)".
struct Figure {
  std::string name;  ///< of its files: letters, digits, hyphens
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  bool log_x = false, log_y = false;
};

/// Whether gnuplot, which draws the figures, can be called.
bool can_draw_figures();

/// The figure as an SVG image without scripts or references, drawn by gnuplot. Colours are told apart by the
/// colour-blind and in print. Throws Failure(Exit::io) with the remedy if gnuplot is missing or fails.
std::string figure_svg(const Figure& figure);

/// The points as "curve,x,y" lines under a header with the axis labels.
std::string figure_csv(const Figure& figure);

/// Writes NAME.svg and NAME.csv into a folder; errors as figure_svg and write_file_safely.
void write_figure(const std::string& folder, const Figure& figure);

}  // namespace pulvis
