// SPDX-License-Identifier: Apache-2.0
#include "output/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "output/safe_file.hpp"

namespace pulvis {
namespace {

using gnuplot::quoted;

std::string range_text(const char* axis, const std::optional<Range>& range) {
  return range ? fmt::format("set {}range [{}:{}]\n", axis, range->low, range->high)
               : fmt::format("set {}range [*:*]\n", axis);
}

std::string style_of(const Curve& curve, std::size_t k) {
  const char* colour = gnuplot::colour(k);
  if (curve.points) return fmt::format("with points pt {} ps 0.7 lc rgb '{}'", 4 + k % 10, colour);
  return fmt::format("with {} lw 1.8 dt {} lc rgb '{}'", curve.steps ? "steps" : "lines", 1 + k / 8, colour);
}

/// The commands from the axes' labels to the points.
std::string plot_of(const Figure& figure, bool with_key) {
  std::string script = fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nset grid lc rgb '#d0d0d0'\n",
                                   quoted(figure.title), quoted(figure.x_label), quoted(figure.y_label));
  script += range_text("x", figure.x_range) + range_text("y", figure.y_range);
  if (figure.log_x) script += "set logscale x\nset format x '%.0e'\n";
  if (figure.log_y) script += "set logscale y\nset format y '%.0e'\n";
  for (const Mark& mark : figure.marks) {
    script += fmt::format(
        "set arrow from first {0}, graph 0 to first {0}, graph 1 nohead dt 3 lc rgb '#606060'\n", mark.x);
    if (!mark.label.empty())
      script += fmt::format(
          "set label {} at first {}, graph 0.97 right rotate by 90 offset character 0.8,0 font ',10' front\n",
          quoted(mark.label), mark.x);
  }
  std::string plot = "plot", data;
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    const Curve& curve = figure.curves[k];
    plot += fmt::format("{} '-' using 1:2 {} {}", k ? "," : "",
                        with_key ? "title " + quoted(curve.label) : "notitle", style_of(curve, k));
    // A histogram rises from nothing.
    if (curve.steps && !curve.x.empty()) data += gnuplot::data_line({curve.x.front(), 0.0});
    for (std::size_t j = 0; j < curve.x.size(); ++j) data += gnuplot::data_line({curve.x[j], curve.y[j]});
    data += "e\n";
  }
  return script + plot + "\n" + data;
}

/// Where a sheet has what, in pixels.
struct Layout {
  static constexpr int left = 86, right = 24, top = 36, bottom = 66, title = 40;
  const FigureSheet& sheet;
  std::size_t columns = std::max<std::size_t>(1, std::min(sheet.columns, sheet.panels.size()));
  std::size_t rows = (sheet.panels.size() + columns - 1) / columns;
  int cell_width = left + sheet.panel_width + right, cell_height = top + sheet.panel_height + bottom;
  int width = static_cast<int>(columns) * cell_width + key_width();
  int height = title + static_cast<int>(rows) * cell_height;

  int key_width() const {
    std::size_t longest = 0;
    for (const Figure& panel : sheet.panels)
      if (panel.curves.size() > 1)
        for (const Curve& curve : panel.curves) longest = std::max(longest, curve.label.size());
    return longest == 0 ? 0 : 40 + 8 * static_cast<int>(std::min<std::size_t>(longest, 40));
  }

  std::string margins(std::size_t k) const {
    const int x = static_cast<int>(k % columns) * cell_width + left;
    const int y = title + static_cast<int>(k / columns) * cell_height + top;
    const auto across = [&](int pixel) { return static_cast<double>(pixel) / width; };
    const auto up = [&](int pixel) { return 1.0 - static_cast<double>(pixel) / height; };
    return fmt::format(
        "set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n"
        "set bmargin at screen {:.6f}\n",
        across(x), across(x + sheet.panel_width), up(y), up(y + sheet.panel_height));
  }
};

}  // namespace

std::string figure_script(const Figure& figure) {
  return gnuplot::head(720, 440) + "set key outside right top vertical Left reverse samplen 2\n" +
         plot_of(figure, true);
}

std::string figure_script(const FigureSheet& sheet) {
  const Layout layout{sheet};
  std::string script = gnuplot::head(layout.width, layout.height);
  script += fmt::format(
      "set multiplot title {}\n"
      "set key at graph 1.04, graph 1 left top vertical Left reverse samplen 2\n",
      quoted(sheet.title));
  for (std::size_t k = 0; k < sheet.panels.size(); ++k) {
    const Figure& panel = sheet.panels[k];
    const bool with_key = panel.curves.size() > 1 && (!sheet.common_key || k + 1 == layout.columns);
    script += "unset logscale\nunset arrow\nunset label\nset format\n" + layout.margins(k) +
              plot_of(panel, with_key);
  }
  return script + "unset multiplot\n";
}

std::string figure_svg(const Figure& figure) { return drawn_by_gnuplot(figure_script(figure), figure.name); }

std::string figure_csv(const Figure& figure) {
  std::string text = fmt::format("curve,{},{}\n", csv_quoted(figure.x_label), csv_quoted(figure.y_label));
  for (const Curve& curve : figure.curves)
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      text += fmt::format("{},{},{}\n", csv_quoted(curve.label), curve.x[k], curve.y[k]);
  return text;
}

std::string figure_csv(const FigureSheet& sheet) {
  std::string text = "panel,curve,x_label,x,y_label,y\n";
  for (const Figure& panel : sheet.panels)
    for (const Curve& curve : panel.curves)
      for (std::size_t k = 0; k < curve.x.size(); ++k)
        text += fmt::format("{},{},{},{},{},{}\n", csv_quoted(panel.title), csv_quoted(curve.label),
                            csv_quoted(panel.x_label), curve.x[k], csv_quoted(panel.y_label), curve.y[k]);
  return text;
}

void write_figure(const std::string& folder, const Figure& figure) {
  const std::filesystem::path base = std::filesystem::path(folder) / figure.name;
  write_file_safely(base.string() + ".csv", figure_csv(figure));
  write_file_safely(base.string() + ".svg", figure_svg(figure));
}

}  // namespace pulvis
