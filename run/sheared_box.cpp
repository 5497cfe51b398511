// SPDX-License-Identifier: Apache-2.0
#include "run/sheared_box.hpp"

#include "run/sight.hpp"

namespace pulvis {

ShearedBox look_at_sheared_box(const Simulation& simulation) {
  const Box& domain = simulation.model().domain;
  const Sight sight = look_at(simulation);
  const ForceSight forces = forces_in(simulation, sight);
  std::vector<measures::Particle> parcels;
  double mass = 0.0, solid = 0.0;
  for (const std::uint32_t k : sight.index) {
    const Parcel& p = simulation.state().parcels.body[k];
    parcels.push_back({p.position, p.velocity - domain.flow_velocity(p.position), p.mass, p.radius});
    mass += p.mass;
    solid += sphere_volume(p.radius);
  }
  const Vec3 extent = domain.extent();
  const double volume = extent.x * extent.y * extent.z;
  const std::vector<std::uint8_t> all(parcels.size(), 1);
  ShearedBox box;
  box.stress = measures::stress(parcels, all, forces.pairs, forces.walls, volume);
  const measures::Tensor total = box.stress.total();
  const double along_flow = total.rows[static_cast<std::size_t>(domain.shear.flow)][domain.shear.gradient];
  box.shear_stress = domain.shear.rate < 0.0 ? along_flow : -along_flow;
  box.solid_fraction = solid / volume;
  if (parcels.empty()) return box;
  box.coordination = 2.0 * static_cast<double>(sight.contacts.size()) / static_cast<double>(parcels.size());
  box.temperature = box.stress.kinetic.trace() * volume / (3.0 * mass);
  return box;
}

}  // namespace pulvis
