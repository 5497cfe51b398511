// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "output/figure.hpp"

namespace pulvis {

/// A rectangle of one colour. Not drawn if its value is not finite.
struct MapCell {
  double x = 0.0, y = 0.0;  ///< its centre
  double width = 0.0, height = 0.0;
  double value = 0.0;
};

/// One map of a figure: what a colour means, and the scale of lengths, are the same for all of them.
struct MapPanel {
  std::string title, x_label, y_label;
  Range x, y;
  std::vector<MapCell> cells;
  struct Label {
    double x = 0.0, y = 0.0;
    std::string text;
  };
  std::vector<Label> labels{};
  std::vector<MapCell> outlines{};  ///< rectangles without colour
};

/// Maps side by side in viridis, which prints and which the colour-blind can read, with one colour bar.
struct HeatMap {
  std::string name, title;
  std::string bar_label;  ///< with the unit: "porosity"
  Range scale;
  std::size_t columns = 3;
  std::vector<MapPanel> panels;
};

/// The smallest range over all values of a map that are finite; {0, 1} if there are none, widened if they
/// are all the same.
Range range_of_values(const std::vector<MapPanel>& panels);

/// As for figures.
std::string figure_script(const HeatMap& map);
std::string figure_csv(const HeatMap& map);

}  // namespace pulvis
