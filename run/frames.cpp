// SPDX-License-Identifier: Apache-2.0
#include "run/frames.hpp"

#include <fmt/format.h>

#include "run/sight.hpp"
#include "run/wall_mesh.hpp"
#include "run/wall_results.hpp"

namespace pulvis {

Frames::Frames(const RunFolder& folder, const WrittenFrames& written)
    : folder_(folder),
      written_(written),
      parcels_(folder.file("parcels.pvd"), written.parcels),
      walls_(folder.file("walls.pvd"), written.walls),
      porosity_(folder.file("porosity.pvd"), written.porosity) {}

const WrittenFrames& Frames::written() {
  written_.parcels = parcels_.frames();
  written_.walls = walls_.frames();
  written_.porosity = porosity_.frames();
  return written_;
}

void Frames::add(const Simulation& simulation, const WallLoads& loads,
                 const std::optional<measures::PorosityField>& porosity) {
  const double time = simulation.time();
  if (time == written_.last) return;
  written_.last = time;
  const std::string number = fmt::format("{:06}", written_.count++);
  folder_.folder("frames");
  const auto file = [&](const char* kind, const char* ending) {
    return fmt::format("frames/{}-{}.{}", kind, number, ending);
  };

  // A frame of millions of parcels is large: only what is written is held while it is.
  std::vector<std::uint32_t> index;
  std::vector<std::int32_t> coordination;
  {
    Sight sight = look_at(simulation);
    coordination = contacts_of(sight);
    index = std::move(sight.index);
  }
  const std::size_t count = index.size();
  std::vector<Vec3> centres(count), velocity(count), spin(count), force(count);
  std::vector<double> radius(count);
  std::vector<std::uint32_t> id(count), species(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Parcel& p = simulation.state().parcels.body[index[k]];
    centres[k] = p.position;
    velocity[k] = p.velocity;
    spin[k] = p.spin;
    force[k] = simulation.state().parcels.load[index[k]].force;
    radius[k] = p.radius;
    id[k] = p.id;
    species[k] = p.species;
  }
  const std::vector<Field> fields = {{"id", std::span<const std::uint32_t>(id)},
                                     {"type", std::span<const std::uint32_t>(species)},
                                     {"radius", std::span<const double>(radius)},
                                     {"velocity", std::span<const Vec3>(velocity)},
                                     {"omega", std::span<const Vec3>(spin)},
                                     {"force", std::span<const Vec3>(force)},
                                     {"coordination", std::span<const std::int32_t>(coordination)}};
  write_points_vtp(folder_.file(file("parcels", "vtp")), centres, fields, time);
  parcels_.add(time, file("parcels", "vtp"));

  const WallMesh walls =
      mesh_of_walls(simulation.model().walls, simulation.model().domain,
                    [&](std::uint32_t body) -> const Pose& { return simulation.pose(body); });
  const WallFields bear = wall_fields(walls, loads, simulation);
  const std::vector<Field> on_walls = {{"body", std::span<const std::uint32_t>(walls.body)},
                                       {"wall", std::span<const std::uint32_t>(walls.wall)},
                                       {"surface", std::span<const std::uint32_t>(walls.surface)},
                                       {"pressure", std::span<const double>(bear.pressure)},
                                       {"shear_stress", std::span<const double>(bear.shear_stress)},
                                       {"normal_force", std::span<const double>(bear.normal_force)},
                                       {"shear_force", std::span<const double>(bear.shear_force)}};
  write_surface_vtp(folder_.file(file("walls", "vtp")), walls.mesh, on_walls, time);
  walls_.add(time, file("walls", "vtp"));

  if (!porosity) return;
  Grid grid;
  grid.origin = porosity->origin;
  grid.spacing = porosity->spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) grid.cells[axis] = static_cast<int>(porosity->cells[axis]);
  const std::vector<Field> grid_fields = {
      {"porosity", std::span<const double>(porosity->values), 1, Stored::double_precision},
      {"counted_volume", std::span<const double>(porosity->counted_volume), 1, Stored::double_precision}};
  write_grid_vti(folder_.file(file("porosity", "vti")), grid, grid_fields, time);
  porosity_.add(time, file("porosity", "vti"));
}

}  // namespace pulvis
