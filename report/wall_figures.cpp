// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/illustration.hpp"
#include "report/quantity_text.hpp"

namespace pulvis::report {
namespace {

constexpr std::size_t most_surfaces = 12;  // of one run; a mesh may have hundreds

/// A tile of a wall, in the coordinates of its surface.
struct Tile {
  double u = 0.0, v = 0.0, width = 0.0, height = 0.0;  ///< m
  double pressure = 0.0;                               ///< Pa
};

struct Surface {
  std::string wall, name;
  std::vector<Tile> tiles;
  double largest() const {
    double p = 0.0;
    for (const Tile& t : tiles) p = std::max(p, std::isfinite(t.pressure) ? std::abs(t.pressure) : 0.0);
    return p;
  }
};

std::vector<double> distinct(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double near = 1e-6 * (values.back() - values.front());
  values.erase(std::unique(values.begin(), values.end(), [&](double a, double b) { return b - a <= near; }),
               values.end());
  return values;
}

/// Even grids have tiles of the grid's spacing; others are shown as squares of their area.
void size_tiles(Surface& s, const std::vector<double>& areas) {
  std::vector<double> us, vs;
  for (const Tile& t : s.tiles) us.push_back(t.u), vs.push_back(t.v);
  us = distinct(std::move(us)), vs = distinct(std::move(vs));
  const auto spacing = [](const std::vector<double>& x) {
    return (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  };
  for (std::size_t k = 0; k < s.tiles.size(); ++k) {
    Tile& t = s.tiles[k];
    const double side = std::sqrt(areas[k]);
    t.width = t.height = side;
    if (us.size() * vs.size() != s.tiles.size()) continue;
    if (us.size() > 1) t.width = spacing(us), t.height = areas[k] / t.width;
    if (vs.size() > 1) t.height = spacing(vs), t.width = us.size() > 1 ? t.width : areas[k] / t.height;
  }
}

std::vector<Surface> surfaces_of(const CsvTable& table) {
  const auto walls = table.texts("wall"), names = table.texts("surface");
  const auto u = table.numbers("u_m"), v = table.numbers("v_m"), area = table.numbers("area_m2"),
             pressure = table.numbers("pressure_Pa");
  std::vector<Surface> list;
  std::vector<std::vector<double>> areas;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (!std::isfinite(u[k]) || !std::isfinite(v[k]) || !(area[k] > 0.0) || !std::isfinite(area[k])) continue;
    if (list.empty() || list.back().wall != walls[k] || list.back().name != names[k])
      list.push_back({walls[k], names[k], {}}), areas.emplace_back();
    list.back().tiles.push_back({u[k], v[k], 0.0, 0.0, pressure[k]});
    areas.back().push_back(area[k]);
  }
  for (std::size_t k = 0; k < list.size(); ++k) size_tiles(list[k], areas[k]);
  return list;
}

/// "-x" of a box's surface "die.-x"; nothing for others.
std::string side_of(const Surface& s) {
  const std::string side =
      s.name.size() >= 3 && s.name.starts_with(s.wall + ".") ? s.name.substr(s.wall.size() + 1) : "";
  const bool known =
      side.size() == 2 && (side[0] == '-' || side[0] == '+') && side[1] >= 'x' && side[1] <= 'z';
  return known ? side : "";
}

double extent(const Surface& s, bool along_u) {
  double low = 1e300, high = -1e300;
  for (const Tile& t : s.tiles) {
    const double c = along_u ? t.u : t.v, half = 0.5 * (along_u ? t.width : t.height);
    low = std::min(low, c - half), high = std::max(high, c + half);
  }
  return high - low;
}

/// A box unfolded to a cross: the floor in the middle, walls fallen outwards, a lid beyond +x. On walls across x and
/// y the height is v, see `upright`; on floor and lid, u and v run along x and y.
MapPanel cross_of(const std::map<std::string, Surface>& sides, const DisplayUnit& unit) {
  double x = 0.0, y = 0.0, z = 0.0;
  for (const auto& [side, s] : sides) {
    (side[1] == 'x' ? y : x) = extent(s, true);
    (side[1] == 'z' ? y : z) = extent(s, false);
  }
  MapPanel panel;
  const double f = unit.factor, beside = 0.12 * (x + y + z);
  const auto place = [&](const std::string& side, double u, double v) -> std::pair<double, double> {
    const double up = v + 0.5 * z, sign = side[0] == '-' ? -1.0 : 1.0;
    if (side[1] == 'x') return {sign * (0.5 * x + up), u};
    if (side[1] == 'y') return {u, sign * (0.5 * y + up)};
    return side == "-z" ? std::pair{u, v} : std::pair{x + z - u, v};
  };
  for (const auto& [side, s] : sides) {
    const bool lying = side[1] == 'x';
    for (const Tile& t : s.tiles) {
      const auto [px, py] = place(side, t.u, t.v);
      panel.cells.push_back(
          {f * px, f * py, f * (lying ? t.height : t.width), f * (lying ? t.width : t.height), t.pressure});
    }
    const auto [cx, cy] = place(side, 0.0, 0.0);
    panel.outlines.push_back({f * cx, f * cy, f * (lying ? z : x),
                              f * (lying            ? y
                                   : side[1] == 'y' ? z
                                                    : y),
                              0.0});
    const double sign = side[0] == '-' ? -1.0 : 1.0;
    if (lying) panel.labels.push_back({f * sign * (0.5 * x + z + 0.5 * beside), 0.0, side});
    if (side[1] == 'y') panel.labels.push_back({0.0, f * sign * (0.5 * y + z + 0.5 * beside), side});
  }
  const double right = 0.5 * x + z + beside + (sides.contains("+z") ? x : 0.0);
  panel.x = {-f * (0.5 * x + z + beside), f * right};
  panel.y = {-f * (0.5 * y + z + beside), f * (0.5 * y + z + beside)};
  return panel;
}

/// On a box's walls across y, u runs along z and v along x (on those across x along y and z): turned so that v is the
/// height.
Surface upright(Surface s, const std::string& side) {
  if (side[1] == 'y')
    for (Tile& t : s.tiles) std::swap(t.u, t.v), std::swap(t.width, t.height);
  return s;
}

MapPanel flat_panel(const Surface& s, const DisplayUnit& unit) {
  MapPanel panel;
  panel.x = panel.y = {1e300, -1e300};
  for (const Tile& t : s.tiles) {
    const MapCell c{t.u * unit.factor, t.v * unit.factor, t.width * unit.factor, t.height * unit.factor,
                    t.pressure};
    panel.x = {std::min(panel.x.low, c.x - 0.5 * c.width), std::max(panel.x.high, c.x + 0.5 * c.width)};
    panel.y = {std::min(panel.y.low, c.y - 0.5 * c.height), std::max(panel.y.high, c.y + 0.5 * c.height)};
    panel.cells.push_back(c);
  }
  return panel;
}

std::vector<MapPanel> panels_of(const Labelled& one, bool with_label, const DisplayUnit& unit) {
  std::map<std::string, std::map<std::string, Surface>> boxes;
  std::vector<Surface> others;
  for (Surface& s : surfaces_of(*one.phase->wall_pressure)) {
    const std::string side = side_of(s);
    if (side.empty())
      others.push_back(std::move(s));
    else
      boxes[s.wall][side] = upright(s, side);
  }
  // Powder of one side alone says nothing of a wall that nobody touches.
  std::erase_if(others, [](const Surface& s) { return !(s.largest() > 0.0); });
  std::stable_sort(others.begin(), others.end(),
                   [](const Surface& a, const Surface& b) { return a.largest() > b.largest(); });
  if (others.size() > most_surfaces) others.resize(most_surfaces);
  std::vector<MapPanel> panels;
  const auto add = [&](MapPanel panel, const std::string& name) {
    panel.title = with_label ? one.label + ": " + name : name;
    panel.x_label = panel.y_label = fmt::format("({})", unit.name);
    panels.push_back(std::move(panel));
  };
  for (const auto& [wall, sides] : boxes) add(cross_of(sides, unit), wall);
  for (const Surface& s : others) add(flat_panel(s, unit), s.name);
  return panels;
}

}  // namespace

std::optional<Illustration> wall_pressure_maps(const Beside& list) {
  double longest = 0.0, largest = 0.0;
  for (const Labelled& one : list) {
    if (!one.phase->wall_pressure) continue;
    longest = std::max({longest, largest_of(one.phase->wall_pressure->numbers("u_m")),
                        largest_of(one.phase->wall_pressure->numbers("v_m"))});
    largest = std::max(largest, largest_of(one.phase->wall_pressure->numbers("pressure_Pa")));
  }
  const DisplayUnit length = display_unit(2.0 * longest, "m"), pressure = display_unit(largest, "Pa");
  HeatMap map{"wall-pressure", "Pressure on the walls, unfolded", with_unit("pressure", pressure), {}, 2, {}};
  for (const Labelled& one : list)
    if (one.phase->wall_pressure)
      for (MapPanel& panel : panels_of(one, list.size() > 1, length)) {
        for (MapCell& cell : panel.cells) cell.value *= pressure.factor;
        map.panels.push_back(std::move(panel));
      }
  map.scale = range_of_values(map.panels);
  return illustrate(
      std::move(map),
      fmt::format("A box is unfolded: its floor in the middle, the walls fallen outwards, the same scale "
                  "for all. Other walls surface by surface, each along its own u (across) and v (up); of "
                  "more than {}, those with the largest pressure. Positive pressure presses.",
                  most_surfaces));
}

}  // namespace pulvis::report
