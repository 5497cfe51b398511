// SPDX-License-Identifier: Apache-2.0
#include "run/measuring.hpp"

#include <algorithm>
#include <numeric>

#include "measures/coordination.hpp"
#include "measures/fill.hpp"
#include "measures/periodic_images.hpp"
#include "run/species.hpp"

namespace pulvis {
namespace {

measures::Container container_of(const Region& region, const Vec3& moved, const Vec3& gravity) {
  measures::Container m;
  m.shape = region.shape == Region::Shape::box ? measures::Container::Shape::box
                                               : measures::Container::Shape::cylinder;
  m.min = region.min + moved;
  m.max = region.max + moved;
  m.base = region.base + moved;
  m.axis = region.axis;
  m.radius = region.radius;
  m.height = region.height;
  m.up = -gravity;
  return m;
}

const Pose& pose_of_die(const Case& c, const Simulation& simulation) {
  const std::string& body = c.walls[*c.measures.die].body;
  const auto& bodies = simulation.model().walls.bodies;
  const auto at = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == body; });
  return simulation.pose(static_cast<std::size_t>(at - bodies.begin()));
}

bool has_turned(const Pose& pose) { return !(pose.now == Rigid::translation(pose.now.shift)); }

/// Mean parcel diameter of the powder the case describes: fixed, so that grids do not change while filling.
double mean_parcel_diameter(const Case& c) { return SizeSampler(parcel_sizes(c.powders.front())).mean(); }

}  // namespace

std::optional<measures::Container> measured_container(const Case& c, const Simulation& simulation) {
  const Vec3 pull = simulation.field().at(0.5 * (c.domain.min + c.domain.max));
  if (c.measures.region) return container_of(*c.measures.region, {}, pull);
  if (!c.measures.die) return {};
  const Pose& pose = pose_of_die(c, simulation);
  const Region& region = c.walls[*c.measures.die].region;
  if (!has_turned(pose)) return container_of(region, pose.now.shift, pull);
  return container_of(region, {}, pose.now.turn_back(pull));  // its own frame
}

Sight look_at_die(const Case& c, const Simulation& simulation) {
  Sight sight = look_at(simulation);
  if (!c.measures.die || !has_turned(pose_of_die(c, simulation))) return sight;
  for (measures::Sphere& sphere : sight.spheres)
    sphere.centre = pose_of_die(c, simulation).now.back(sphere.centre);
  return sight;
}

Measurement measure(const Case& c, const Simulation& simulation) {
  const Sight sight = look_at_die(c, simulation);
  Measurement m;
  const std::string window = "instantaneous";
  const auto add = [&](const char* name, std::optional<double> value, const char* unit) {
    m.list.push_back({name, value, unit, window});
  };
  if (const auto die = measured_container(c, simulation)) {
    const double diameter = mean_parcel_diameter(c);
    const auto surface =
        measures::free_surface(sight.spheres, sight.contacts, *die, c.measures.column_diameters * diameter);
    const Box& domain = simulation.model().domain;
    const auto solid =
        measures::with_periodic_images(sight.spheres, {domain.min, domain.max},
                                       {domain.periodic[0], domain.periodic[1], domain.periodic[2]});
    m.porosity = measures::porosity(solid, surface, *die, c.measures.cell_diameters * diameter);
    const auto fill = measures::fill_inside(sight.spheres, sight.masses, *die);
    const auto coordination =
        measures::coordination(sight.spheres, sight.contacts, sight.wall_contacts, *die);
    add("fill_mass", fill.mass, "kg");
    add("fill_count", static_cast<double>(fill.count), "1");
    add("porosity_mean", m.porosity->mean, "1");
    add("porosity_std", m.porosity->standard_deviation, "1");
    add("coordination_mean", coordination.mean, "1");
    add("coordination_walls_mean", coordination.mean_walls, "1");
    add("free_surface_height_mean", surface.mean, "m");
  }
  const auto energies = measures::energies(sight.bodies, simulation.field().gravity);
  add("kinetic_energy_translational", energies.translational, "J");
  add("kinetic_energy_rotational", energies.rotational, "J");
  add("potential_energy", energies.potential, "J");
  return m;
}

}  // namespace pulvis
