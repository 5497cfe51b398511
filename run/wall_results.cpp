// SPDX-License-Identifier: Apache-2.0
#include "run/wall_results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/contacts/near_walls.hpp"
#include "output/safe_file.hpp"

namespace pulvis {
namespace {

/// Whether a body is nothing but the wall that gave it its name.
bool is_single_wall(const Walls& walls, std::uint32_t body) {
  return std::all_of(walls.surfaces.begin(), walls.surfaces.end(), [&](const Surface& s) {
    return s.body != body || walls.names[s.wall] == walls.bodies[body].name;
  });
}

/// Walls by their names, then bodies of more than one wall.
std::vector<std::string> names_of_loads(const Walls& walls) {
  std::vector<std::string> names = walls.names;
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b)
    if (!is_single_wall(walls, b)) names.push_back("body " + walls.bodies[b].name);
  return names;
}

/// In the order of their names.
std::vector<const WallLoad*> loads_of(const Walls& walls, const WallWindow& w) {
  std::vector<const WallLoad*> loads;
  for (const WallLoad& load : w.walls) loads.push_back(&load);
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b)
    if (!is_single_wall(walls, b)) loads.push_back(&w.bodies[b]);
  return loads;
}

std::vector<std::string> columns_for(const Walls& walls) {
  std::vector<std::string> columns{"time_s", "window_s", "phase"};
  for (const std::string& name : names_of_loads(walls)) {
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{} force_{}_N", name, axis));
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{} torque_{}_N_m", name, axis));
  }
  return columns;
}

constexpr const char* log_file = "wall-forces.csv";

}  // namespace

WallResults::WallResults(const RunFolder& folder, const Walls& walls, std::uint64_t length)
    : folder_(folder) {
  if (length > 0) log_.emplace(CsvLog::continued(folder.file(log_file), columns_for(walls), length));
}

void WallResults::log(const WallLoads& loads, const Simulation& simulation, const std::string& phase) {
  const Walls& walls = simulation.model().walls;
  const WallWindow& w = loads.window();
  if (!log_) log_.emplace(folder_.file(log_file), columns_for(walls));
  std::vector<CsvCell> cells{w.end, w.end - w.start, std::string_view(phase)};
  for (const WallLoad* load : loads_of(walls, w))
    for (const Vec3& v : {load->force, load->torque})
      for (int axis = 0; axis < 3; ++axis) cells.push_back(v[axis]);
  log_->add(cells);
}

std::string WallResults::write_pressures(const WallLoads& loads, const Simulation& simulation,
                                         const std::string& phase) {
  const Walls& walls = simulation.model().walls;
  const WallWindow& w = loads.window();
  folder_.folder("wall-pressure");
  const std::string name = "wall-pressure/after-" + phase + ".csv";
  CsvTable table({"wall", "surface", "x_m", "y_m", "z_m", "u_m", "v_m", "area_m2", "pressure_Pa",
                  "shear_stress_Pa", "window_s"});
  for (std::size_t t = 0; t < w.tiles.size(); ++t) {
    const measures::WallTile& tile = loads.tiling().tiles()[t];
    const Surface& surface = walls.surfaces[tile.surface];
    const Vec3 place = simulation.pose(surface.body).now(tile.centre);
    table.add({std::string_view(walls.names[surface.wall]), std::string_view(surface.name), place.x, place.y,
               place.z, tile.u, tile.v, tile.area, w.tiles[t].normal / tile.area,
               norm(w.tiles[t].shear) / tile.area, w.end - w.start});
  }
  table.save(folder_.file(name));
  return name;
}

WallFields wall_fields(const WallMesh& mesh, const WallLoads& loads, const Simulation& simulation) {
  const WallWindow& w = loads.window();
  const Walls& walls = simulation.model().walls;
  WallFields fields;
  for (std::size_t t = 0; t < mesh.surface.size(); ++t) {
    const auto& corners = mesh.mesh.triangles[t];
    const Vec3 middle =
        (mesh.mesh.points[corners[0]] + mesh.mesh.points[corners[1]] + mesh.mesh.points[corners[2]]) / 3.0;
    const Surface& surface = walls.surfaces[mesh.surface[t]];
    const Vec3 at = simulation.pose(surface.body).now.back(middle);
    const std::uint32_t tile = loads.tiling().tile_of(mesh.surface[t], mesh.facet[t], at);
    const double area = loads.tiling().tiles()[tile].area;
    fields.pressure.push_back(w.tiles[tile].normal / area);
    fields.shear_stress.push_back(norm(w.tiles[tile].shear) / area);
    const bool of_mesh = mesh.facet[t] != NearWalls::no_facet;
    const TileLoad facet = of_mesh ? w.facets[surface.mesh][mesh.facet[t]] : TileLoad{};
    fields.normal_force.push_back(facet.normal);
    fields.shear_force.push_back(norm(facet.shear));
  }
  return fields;
}

std::vector<Measure> wall_measures(const Case& c, const WallLoads& loads, const Simulation& simulation) {
  const auto& bodies = simulation.model().walls.bodies;
  double largest = 0.0, mean = 0.0;
  for (std::uint32_t b = 0; b < bodies.size(); ++b) {
    if (c.measures.die && bodies[b].name != c.walls[*c.measures.die].body) continue;
    largest = std::max(largest, loads.largest_pressure(b));
    mean = std::max(mean, loads.mean_pressure(b));
  }
  const std::string window = loads.window_text();
  return {{"wall_pressure_max", largest, "Pa", window}, {"wall_pressure_mean", mean, "Pa", window}};
}

std::vector<WallForce> wall_forces(const WallLoads& loads, const Simulation& simulation) {
  std::vector<WallForce> list;
  const Walls& walls = simulation.model().walls;
  const std::vector<std::string> names = names_of_loads(walls);
  const std::vector<const WallLoad*> bear = loads_of(walls, loads.window());
  for (std::size_t k = 0; k < names.size(); ++k) list.push_back({names[k], *bear[k], loads.window_text()});
  return list;
}

}  // namespace pulvis
