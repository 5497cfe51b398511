// SPDX-License-Identifier: Apache-2.0
#include "output/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "output/colour_map.hpp"

namespace pulvis {
namespace {

using gnuplot::quoted;

constexpr double left = 74, right = 18, top = 44, bottom = 72;  // pixels around a map
constexpr double title_height = 40, bar_width = 130;
constexpr double widest = 1080, highest = 340;  // all maps beside each other; one map
constexpr double smallest = 70;                 // side of a map, so that ticks have room

double extent(const Range& r) { return std::max(r.high - r.low, std::numeric_limits<double>::min()); }

/// Rows and columns, with their sizes in pixels.
struct Layout {
  std::size_t columns, rows;
  std::vector<double> widths, heights;
  double scale = 1.0;  ///< pixels per unit of length

  explicit Layout(const HeatMap& map)
      : columns(std::max<std::size_t>(1, std::min(map.columns, map.panels.size()))),
        rows((map.panels.size() + columns - 1) / columns),
        widths(columns, 0.0),
        heights(rows, 0.0) {
    for (std::size_t k = 0; k < map.panels.size(); ++k) {
      double& width = widths[k % columns];
      double& height = heights[k / columns];
      width = std::max(width, extent(map.panels[k].x));
      height = std::max(height, extent(map.panels[k].y));
    }
    double all = 0.0, tallest = 0.0;
    for (const double w : widths) all += w;
    for (const double h : heights) tallest = std::max(tallest, h);
    const double room = widest - bar_width - static_cast<double>(columns) * (left + right);
    scale = std::min(std::max(room, smallest) / all, highest / tallest);
    for (double& w : widths) w = std::max(smallest, w * scale);
    for (double& h : heights) h = std::max(smallest, h * scale);
  }

  double width() const {
    double sum = bar_width;
    for (const double w : widths) sum += left + w + right;
    return sum;
  }
  double height() const {
    double sum = title_height;
    for (const double h : heights) sum += top + h + bottom;
    return sum;
  }
  double x_of(std::size_t column) const {
    double x = left;
    for (std::size_t k = 0; k < column; ++k) x += widths[k] + right + left;
    return x;
  }
  double y_of(std::size_t row) const {
    double y = title_height + top;
    for (std::size_t k = 0; k < row; ++k) y += heights[k] + bottom + top;
    return y;
  }
};

/// A step of ticks that are at least so many pixels apart: 1, 2 or 5 times a power of ten.
double tick_step(const Range& range, double pixels, double apart) {
  const double rough = extent(range) * apart / std::max(pixels, 1.0);
  if (!(rough > 0.0) || !std::isfinite(rough)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= rough) return step * power;
  return 10.0 * power;
}

std::string palette() {
  std::string text = "set palette defined (";
  constexpr int parts = 32;
  for (int k = 0; k <= parts; ++k) {
    const float place = static_cast<float>(k) / parts;
    const Colour c = viridis(place);
    const auto byte = [](float part) { return static_cast<int>(std::lround(255.0f * part)); };
    text += fmt::format("{}{:.5f} '#{:02x}{:02x}{:02x}'", k ? ", " : "", place, byte(c.red), byte(c.green),
                        byte(c.blue));
  }
  return text + ")\n";
}

/// A title that does not reach into the next map; in UTF-8, so never cut within a character.
std::string shortened(const std::string& title, double pixels) {
  const auto room = static_cast<std::size_t>(std::max(8.0, pixels / 7.5));
  if (title.size() <= room) return title;
  std::size_t end = room - 2;
  while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xc0) == 0x80) --end;
  return title.substr(0, end) + "..";
}

std::string panel_script(const MapPanel& panel, double width, double height) {
  std::string script = fmt::format(
      "set title {} font ',12'\nset xlabel {}\nset ylabel {}\nset xrange [{}:{}]\nset yrange [{}:{}]\n"
      "set xtics {} out nomirror\nset ytics {} out nomirror\n",
      quoted(shortened(panel.title, width + left)), quoted(panel.x_label), quoted(panel.y_label), panel.x.low,
      panel.x.high, panel.y.low, panel.y.high, tick_step(panel.x, width, 46), tick_step(panel.y, height, 26));
  for (const MapCell& o : panel.outlines)
    script +=
        fmt::format("set object rectangle center {},{} size {},{} fs empty border lc rgb '#404040' front\n",
                    o.x, o.y, o.width, o.height);
  for (const MapPanel::Label& label : panel.labels)
    script +=
        fmt::format("set label {} at {},{} center font ',12' front\n", quoted(label.text), label.x, label.y);
  std::string data;
  // A little larger than they are: no seams shine through between them.
  for (const MapCell& c : panel.cells) {
    const double w = 0.505 * c.width, h = 0.505 * c.height;
    if (std::isfinite(c.value))
      data += gnuplot::data_line({c.x, c.y, c.x - w, c.x + w, c.y - h, c.y + h, c.value});
  }
  if (data.empty()) return script + "plot NaN notitle\n";
  return script +
         "plot '-' using 1:2:3:4:5:6:7 with boxxyerror lc palette fillstyle solid 1.0 noborder notitle\n" +
         data + "e\n";
}

}  // namespace

Range range_of_values(const std::vector<MapPanel>& panels) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const MapPanel& panel : panels)
    for (const MapCell& cell : panel.cells)
      if (std::isfinite(cell.value)) {
        range.low = std::min(range.low, cell.value);
        range.high = std::max(range.high, cell.value);
      }
  if (range.low > range.high) return {0.0, 1.0};
  if (range.high - range.low <= 1e-9 * std::abs(range.high)) {
    const double half = range.high == 0.0 ? 0.5 : 0.05 * std::abs(range.high);
    return {range.low - half, range.high + half};
  }
  return range;
}

std::string figure_script(const HeatMap& map) {
  const Layout layout(map);
  const double width = layout.width(), height = layout.height();
  std::string script =
      gnuplot::head(static_cast<int>(std::lround(width)), static_cast<int>(std::lround(height)));
  script += fmt::format("set multiplot title {}\nunset key\n{}set cbrange [{}:{}]\nset cblabel {}\n",
                        quoted(map.title), palette(), map.scale.low, map.scale.high, quoted(map.bar_label));
  const double bar_height = std::min(240.0, height - title_height - top - bottom);
  const double bar_foot = title_height + top + bar_height;
  for (std::size_t k = 0; k < map.panels.size(); ++k) {
    const MapPanel& panel = map.panels[k];
    const double w = std::max(smallest, extent(panel.x) * layout.scale);
    const double h = std::max(smallest, extent(panel.y) * layout.scale);
    const double x = layout.x_of(k % layout.columns);
    const double foot = layout.y_of(k / layout.columns) + layout.heights[k / layout.columns];
    script += fmt::format(
        "unset label\nunset object\nset lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n"
        "set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n",
        x / width, (x + w) / width, 1.0 - foot / height, 1.0 - (foot - h) / height);
    if (k + 1 == map.panels.size())
      script += fmt::format("set colorbox user origin screen {:.6f},{:.6f} size screen {:.6f},{:.6f}\n",
                            (width - bar_width + 10) / width, 1.0 - bar_foot / height, 18 / width,
                            bar_height / height);
    else
      script += "unset colorbox\n";
    script += panel_script(panel, w, h);
  }
  return script + "unset multiplot\n";
}

std::string figure_csv(const HeatMap& map) {
  std::string text = fmt::format("panel,x,y,width,height,{}\n", csv_quoted(map.bar_label));
  for (const MapPanel& panel : map.panels) {
    const std::string name =
        csv_quoted(fmt::format("{}: {} over {}", panel.title, panel.y_label, panel.x_label));
    for (const MapCell& c : panel.cells)
      if (std::isfinite(c.value))
        text += fmt::format("{},{},{},{},{},{}\n", name, c.x, c.y, c.width, c.height, c.value);
  }
  return text;
}

}  // namespace pulvis
