// SPDX-License-Identifier: Apache-2.0
#include "report/quantity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "case/units.hpp"

namespace pulvis::report {
namespace {

std::optional<Quantity> one_of(const std::string& unit) {
  if (unit.empty() || unit == "1") return Quantity{1.0, dimension::none};
  return read_quantity("1 " + unit).quantity;
}

constexpr auto words = std::to_array<std::pair<const char*, const char*>>({
    {"fill_mass", "mass in the die"},
    {"fill_count", "parcels in the die"},
    {"fill_ratio", "share of the die's volume below the powder's surface"},
    {"apparent_density", "apparent density"},
    {"porosity_mean", "mean porosity"},
    {"porosity_std", "scatter of the porosity between cells (standard deviation)"},
    {"porosity_lower_half", "porosity of the lower half"},
    {"porosity_upper_half", "porosity of the upper half"},
    {"free_surface_height_mean", "mean height of the surface"},
    {"free_surface_roughness", "roughness of the surface"},
    {"free_surface_tilt", "tilt of the surface"},
    {"coordination_mean", "contacts per parcel"},
    {"coordination_without_rattlers", "contacts per parcel without rattlers"},
    {"coordination_walls_mean", "contacts with walls per parcel"},
    {"rattler_share", "share of parcels with fewer than four contacts (rattlers)"},
    {"contact_force_mean", "mean contact force"},
    {"pressure_mean", "mean pressure in the powder"},
    {"wall_pressure_max", "largest wall pressure on a tile"},
    {"wall_pressure_mean", "mean wall pressure"},
    {"kinetic_energy_translational", "kinetic energy of motion"},
    {"kinetic_energy_rotational", "kinetic energy of spin"},
    {"potential_energy", "potential energy"},
});

}  // namespace

DisplayUnit display_unit(double largest, const std::string& unit) {
  const auto one = one_of(unit);
  if (!one) return {1.0, unit};
  if (one->dimension == dimension::none) return {one->value, ""};
  const double value = std::isfinite(largest) && largest != 0.0 ? std::abs(largest) * one->value : 1.0;
  const std::string text = format_quantity(value, one->dimension);
  const auto blank = text.find(' ');
  if (blank == std::string::npos) return {1.0, unit};
  const std::string name = text.substr(blank + 1);
  const auto shown = read_quantity("1 " + name).quantity;
  if (!shown || !(shown->value > 0.0)) return {1.0, unit};
  return {one->value / shown->value, name};
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  return largest;
}

DisplayUnit display_unit(const std::vector<double>& values, const std::string& unit) {
  return display_unit(largest_of(values), unit);
}

std::string number_text(double value, int digits) {
  const double size = std::abs(value);
  if (size < std::pow(10.0, digits) || !(size < 1e6)) return fmt::format("{:.{}g}", value, digits);
  return fmt::format("{:.0f}", value);
}

std::string value_text(double value, const std::string& unit, int digits) {
  if (!std::isfinite(value)) return "-";
  const DisplayUnit shown = display_unit(value, unit);
  const std::string number = number_text(value * shown.factor, digits);
  return shown.name.empty() ? number : number + " " + shown.name;
}

std::string with_unit(const std::string& words_of_it, const DisplayUnit& unit) {
  return unit.name.empty() ? words_of_it : fmt::format("{} ({})", words_of_it, unit.name);
}

std::vector<double> scaled(const std::vector<double>& values, const DisplayUnit& unit) {
  std::vector<double> list = values;
  for (double& v : list) v *= unit.factor;
  return list;
}

std::string percent_more(double ratio) {
  return std::isfinite(ratio) ? (ratio < 1.0 ? "" : "+") + number_text(100.0 * (ratio - 1.0), 2) + " %" : "-";
}

std::string measure_words(const std::string& name) {
  for (const auto& [known, text] : words)
    if (name == known) return text;
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

}  // namespace pulvis::report
