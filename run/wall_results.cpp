// SPDX-License-Identifier: Apache-2.0
#include "run/wall_results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/contacts/near_walls.hpp"

namespace pulvis {
namespace {

/// Whether a body is nothing but the wall that gave it its name.
bool is_single_wall(const Walls& walls, std::uint32_t body) {
  return std::all_of(walls.surfaces.begin(), walls.surfaces.end(), [&](const Surface& s) {
    return s.body != body || walls.names[s.wall] == walls.bodies[body].name;
  });
}

/// Walls by their names, then bodies of more than one wall.
std::vector<std::pair<std::string, const WallLoad*>> named_loads(const Walls& walls, const WallWindow& w) {
  std::vector<std::pair<std::string, const WallLoad*>> list;
  for (std::size_t k = 0; k < walls.names.size(); ++k) list.push_back({walls.names[k], &w.walls[k]});
  for (std::size_t b = 0; b < walls.bodies.size(); ++b)
    if (!is_single_wall(walls, static_cast<std::uint32_t>(b)))
      list.push_back({"body " + walls.bodies[b].name, &w.bodies[b]});
  return list;
}

std::vector<std::string> columns_for(const Walls& walls, const WallWindow& w) {
  std::vector<std::string> columns{"time_s", "window_s", "phase"};
  for (const auto& [name, load] : named_loads(walls, w)) {
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{} force_{}_N", name, axis));
    for (const char* axis : {"x", "y", "z"}) columns.push_back(fmt::format("{} torque_{}_N_m", name, axis));
  }
  return columns;
}

}  // namespace

void WallResults::log(const WallLoads& loads, const Simulation& simulation, const std::string& phase) {
  const Walls& walls = simulation.model().walls;
  const WallWindow& w = loads.window();
  if (!log_) log_ = std::make_unique<CsvLog>(folder_.file("wall-forces.csv"), columns_for(walls, w));
  std::vector<CsvCell> cells{w.end, w.end - w.start, std::string_view(phase)};
  for (const auto& [name, load] : named_loads(walls, w))
    for (const Vec3& v : {load->force, load->torque})
      for (int axis = 0; axis < 3; ++axis) cells.push_back(v[axis]);
  log_->add(cells);
}

void WallResults::write_pressures(const WallLoads& loads, const Simulation& simulation,
                                  const std::string& phase) {
  const Walls& walls = simulation.model().walls;
  const WallWindow& w = loads.window();
  CsvLog table(folder_.folder("wall-pressure") + "/after-" + phase + ".csv",
               {"wall", "surface", "x_m", "y_m", "z_m", "u_m", "v_m", "area_m2", "pressure_Pa",
                "shear_stress_Pa", "window_s"});
  for (std::size_t t = 0; t < w.tiles.size(); ++t) {
    const measures::WallTile& tile = loads.tiling().tiles()[t];
    const Surface& surface = walls.surfaces[tile.surface];
    const Vec3 place = simulation.pose(surface.body).now(tile.centre);
    table.add({std::string_view(walls.names[surface.wall]), std::string_view(surface.name), place.x, place.y,
               place.z, tile.u, tile.v, tile.area, w.tiles[t].normal / tile.area,
               norm(w.tiles[t].shear) / tile.area, w.end - w.start});
  }
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
  for (const auto& [name, load] : named_loads(simulation.model().walls, loads.window()))
    list.push_back({name, *load, loads.window_text()});
  return list;
}

}  // namespace pulvis
