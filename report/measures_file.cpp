// SPDX-License-Identifier: Apache-2.0
#include "report/measures_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "engine/base/failure.hpp"
#include "report/json_entry.hpp"

namespace pulvis::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double version_read = 1;

template <std::size_t Size>
std::array<std::size_t, Size> counts_of(const JsonEntry& entry) {
  const auto items = entry.items();
  if (items.size() != Size) entry.fail(fmt::format("{} whole numbers", Size));
  std::array<std::size_t, Size> counts{};
  std::size_t all = 1;
  for (std::size_t k = 0; k < Size; ++k) {
    counts[k] = items[k].count();
    if (counts[k] == 0 || counts[k] > 100'000'000 / all) entry.fail("the size of a grid");
    all *= counts[k];
  }
  return counts;
}

template <std::size_t Size>
std::array<double, Size> spacing_of(const JsonEntry& entry) {
  const std::vector<double> numbers = entry.numbers(Size);
  std::array<double, Size> spacing{};
  for (std::size_t k = 0; k < Size; ++k) {
    if (!(numbers[k] > 0.0)) entry.fail("lengths above zero");
    spacing[k] = numbers[k];
  }
  return spacing;
}

PorosityGrid porosity_of(const JsonEntry& entry) {
  PorosityGrid grid{counts_of<3>(entry.at("cells")), spacing_of<3>(entry.at("spacing_m")), {}, {}};
  const std::size_t all = grid.cells[0] * grid.cells[1] * grid.cells[2];
  grid.values = entry.at("values").numbers(all);
  grid.volume = entry.at("volume_m3").numbers(all);
  return grid;
}

Histogram histogram_of(const JsonEntry& entry, const char* heights) {
  Histogram h{entry.at("edges").numbers(), entry.at(heights).numbers()};
  if (h.edges.size() != h.heights.size() + 1) entry.at("edges").fail("one edge more than bars");
  return h;
}

std::vector<PorosityProfile> profiles_of(const JsonEntry& entry) {
  std::vector<PorosityProfile> list;
  for (const JsonEntry& item : entry.items()) {
    PorosityProfile p{item.at("axis").text(), item.at("position_m").numbers(), {}, {}};
    p.porosity = item.at("porosity").numbers(p.position.size());
    p.volume = item.at("volume_m3").numbers(p.position.size());
    list.push_back(std::move(p));
  }
  return list;
}

std::vector<Part> parts_of(const JsonEntry& entry) {
  std::vector<Part> list;
  for (const JsonEntry& item : entry.items())
    list.push_back({item.at("name").text(), item.number_or("porosity", none),
                    item.number_or("porosity_std", none), item.number_or("volume_m3", none),
                    item.number_or("apparent_density_kg_m3", none), item.number_or("coordination", none)});
  return list;
}

FreeSurface surface_of(const JsonEntry& entry) {
  FreeSurface s{counts_of<2>(entry.at("columns")),
                spacing_of<2>(entry.at("spacing_m")),
                {},
                entry.number_or("mean_m", none),
                entry.number_or("roughness_m", none),
                entry.number_or("tilt_rad", none)};
  s.heights = entry.at("heights_m").numbers(s.columns[0] * s.columns[1]);
  return s;
}

Layers layers_of(const JsonEntry& entry) {
  Layers l;
  l.height = entry.at("height_m").numbers();
  const std::size_t size = l.height.size();
  const auto list = [&](const char* key) {
    return entry.has(key) ? entry.at(key).numbers(size) : std::vector<double>(size, none);
  };
  l.density = list("density_kg_m3");
  l.speed = list("speed_rms_m_s");
  l.vertical_stress.assign(size, none);
  if (const auto stress = entry.find("stress_Pa")) {
    const auto tensors = stress->items();
    if (tensors.size() != size) stress->fail(fmt::format("{} tensors", size));
    for (std::size_t k = 0; k < size; ++k) {
      const auto rows = tensors[k].items();
      if (rows.size() != 3) tensors[k].fail("three rows of three numbers");
      l.vertical_stress[k] = rows[2].numbers(3)[2];
    }
  }
  return l;
}

void require_version(const JsonEntry& file, const std::string& path) {
  const std::string format = file.text_or("format", "");
  if (format != "pulvis measures") file.at("format").fail("\"pulvis measures\"");
  const double version = file.at("version").number();
  if (version != version_read)
    throw Failure(
        Exit::bad_input,
        fmt::format("{} has measures in version {:.6g} of their format; pulvis {} reads version {:.6g}. "
                    "Use the pulvis that made the run, or make the run again",
                    path, version, PULVIS_VERSION, version_read));
}

}  // namespace

const PorosityProfile* MeasuresFile::profile(const std::string& axis) const {
  const auto at =
      std::find_if(profiles.begin(), profiles.end(), [&](const auto& p) { return p.axis == axis; });
  return at == profiles.end() ? nullptr : &*at;
}

const Part* MeasuresFile::part(const std::string& name) const {
  const auto at = std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
  return at == parts.end() ? nullptr : &*at;
}

std::optional<MeasuresFile> read_measures(const std::string& path) {
  const auto json = read_json(path);
  if (!json) return {};
  const JsonEntry file(*json, path);
  require_version(file, path);
  MeasuresFile m;
  m.phase = file.at("phase").text();
  m.time = file.at("time_s").number();
  if (const auto die = file.find("die")) m.die = Die{die->at("shape").text(), die->at("size_m").numbers()};
  if (const auto scalars = file.find("scalars"))
    for (const auto& [name, entry] : scalars->members())
      m.scalars.push_back(
          {name, entry.at("value").number(), entry.at("unit").text(), entry.text_or("window", "")});
  if (const auto entry = file.find("porosity")) m.porosity = porosity_of(*entry);
  if (const auto entry = file.find("porosity_profiles")) m.profiles = profiles_of(*entry);
  if (const auto entry = file.find("porosity_histogram"))
    m.porosity_histogram = histogram_of(*entry, "share");
  if (const auto entry = file.find("parts")) m.parts = parts_of(*entry);
  if (const auto entry = file.find("surface")) m.surface = surface_of(*entry);
  if (const auto entry = file.find("coordination")) m.coordination = entry->at("count").numbers();
  if (const auto entry = file.find("contact_forces")) {
    m.forces = histogram_of(*entry, "density");
    m.mean_force = entry->number_or("mean_N", none);
    m.pulling_share = entry->number_or("pulling_share", none);
  }
  if (const auto entry = file.find("layers")) m.layers = layers_of(*entry);
  const auto segregation = file.find("segregation");
  m.mean_diameter = segregation ? segregation->number_or("mean_diameter_m", none) : none;
  return m;
}

}  // namespace pulvis::report
