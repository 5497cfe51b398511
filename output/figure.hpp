// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "output/gnuplot.hpp"

namespace pulvis {

/// One set of points of a figure; drawn as a line, or as points where they were measured.
struct Curve {
  std::string label;
  std::vector<double> x, y;
  bool points = false;
  bool steps = false;  ///< a histogram: y holds from its x to the next
};

/// The ends of an axis.
struct Range {
  double low = 0.0, high = 0.0;
};

/// A line across the figure at an abscissa, with what begins there.
struct Mark {
  double x = 0.0;
  std::string label;
};

/// A plot of curves over one abscissa. Labels carry their unit: "overlap (m)".
struct Figure {
  std::string name;  ///< of its files: letters, digits, hyphens
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  bool log_x = false, log_y = false;
  std::optional<Range> x_range{}, y_range{};  ///< else as the points need
  std::vector<Mark> marks{};
};

/// Several plots on one sheet, row by row.
struct FigureSheet {
  std::string name, title;
  std::vector<Figure> panels;
  std::size_t columns = 1;
  int panel_width = 300, panel_height = 240;  ///< pixels between the axes
  bool common_key = false;                    ///< all panels show the same curves: one key for them
};

/// The figure as a script that draws it when given to gnuplot: all points are within.
std::string figure_script(const Figure& figure);
std::string figure_script(const FigureSheet& sheet);

/// The figure as an SVG image without scripts or references, drawn by gnuplot. Colours are told apart by the
/// colour-blind and in print. Throws Failure(Exit::io) with the remedy if gnuplot is missing or fails.
std::string figure_svg(const Figure& figure);

/// The points as "curve,x,y" lines under a header with the axis labels.
std::string figure_csv(const Figure& figure);
/// The same for all panels, which the first column names.
std::string figure_csv(const FigureSheet& sheet);

/// Writes NAME.svg and NAME.csv into a folder; errors as figure_svg and write_file_safely.
void write_figure(const std::string& folder, const Figure& figure);

}  // namespace pulvis
