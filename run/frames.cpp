// SPDX-License-Identifier: Apache-2.0
#include "run/frames.hpp"

#include <fmt/format.h>

#include "measures/continuum.hpp"
#include "run/sight.hpp"
#include "run/wall_mesh.hpp"
#include "run/wall_results.hpp"

namespace pulvis {

namespace {

Grid grid_of(const measures::PorosityField& field) {
  Grid grid;
  grid.origin = field.origin;
  grid.spacing = field.spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) grid.cells[axis] = static_cast<int>(field.cells[axis]);
  return grid;
}

std::vector<double> flat(const std::vector<measures::Tensor>& tensors) {
  std::vector<double> numbers;
  numbers.reserve(9 * tensors.size());
  for (const measures::Tensor& t : tensors)
    for (const Vec3& row : t.rows) numbers.insert(numbers.end(), {row.x, row.y, row.z});
  return numbers;
}

}  // namespace

Frames::Frames(const RunFolder& folder, const WrittenFrames& written)
    : folder_(folder),
      written_(written),
      parcels_(folder.file("parcels.pvd"), written.parcels),
      walls_(folder.file("walls.pvd"), written.walls),
      porosity_(folder.file("porosity.pvd"), written.porosity),
      fields_(folder.file("fields.pvd"), written.fields) {}

const WrittenFrames& Frames::written() {
  written_.parcels = parcels_.frames();
  written_.walls = walls_.frames();
  written_.porosity = porosity_.frames();
  written_.fields = fields_.frames();
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
  const std::vector<Field> grid_fields = {
      {"porosity", std::span<const double>(porosity->values), 1, Stored::double_precision},
      {"counted_volume", std::span<const double>(porosity->counted_volume), 1, Stored::double_precision}};
  write_grid_vti(folder_.file(file("porosity", "vti")), grid_of(*porosity), grid_fields, time);
  porosity_.add(time, file("porosity", "vti"));
}

void Frames::add_fields(double time, const DieSight& sight, const measures::PorosityField& grid,
                        double support) {
  const auto fields =
      measures::continuum_fields(measures::grid_points(sight.container, grid.cells), sight.particles,
                                 sight.forces.pairs, sight.forces.walls, support);
  const std::vector<double> contact = flat(fields.contact_stress), kinetic = flat(fields.kinetic_stress);
  const std::vector<Field> list = {{"density", std::span<const double>(fields.density)},
                                   {"velocity", std::span<const Vec3>(fields.velocity)},
                                   {"contact_stress", std::span<const double>(contact), 9},
                                   {"kinetic_stress", std::span<const double>(kinetic), 9}};
  folder_.folder("frames");
  const std::string name = fmt::format("frames/fields-{:06}.vti", fields_.frames().size());
  write_grid_vti(folder_.file(name), grid_of(grid), list, time);
  fields_.add(time, name);
}

}  // namespace pulvis
