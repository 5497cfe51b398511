// SPDX-License-Identifier: Apache-2.0
#include "run/measuring.hpp"

#include "measures/continuum.hpp"
#include "measures/periodic_images.hpp"
#include "run/sheared_box.hpp"
#include "run/species.hpp"

namespace pulvis {
namespace {

/// Mean parcel diameter of the powder the case describes: fixed, so that grids do not change while filling.
double mean_parcel_diameter(const Case& c) { return SizeSampler(parcel_sizes(c.powders.front())).mean(); }

measures::FreeSurface surface_of(const Case& c, const DieSight& sight) {
  return measures::free_surface(sight.sight.spheres, sight.sight.contacts, sight.container,
                                c.measures.column_diameters * mean_parcel_diameter(c));
}

measures::PeriodicImages solid_of(const Simulation& simulation, const DieSight& sight) {
  const Box& domain = simulation.model().domain;
  return measures::periodic_images(sight.sight.spheres, {domain.min, domain.max},
                                   {domain.periodic[0], domain.periodic[1], domain.periodic[2]});
}

measures::PorosityField porosity_of(const Case& c, std::span<const measures::Sphere> solid,
                                    const DieSight& sight, const measures::FreeSurface& surface) {
  return measures::porosity(solid, surface, sight.container,
                            c.measures.cell_diameters * mean_parcel_diameter(c));
}

std::vector<measures::Part> parts_of(const Case& c, const measures::Container& container) {
  const auto halves = measures::halves(container);
  std::vector<measures::Part> parts(halves.begin(), halves.end());
  for (const MeasuredPart& part : c.measures.parts) parts.push_back({part.name, {part.min, part.max}});
  return parts;
}

std::vector<PartSurvey> survey_parts(const Case& c, const DieSight& sight, const DieSurvey& die,
                                     const measures::PeriodicImages& solid) {
  std::vector<double> masses;
  for (const std::uint32_t of : solid.original) masses.push_back(sight.sight.masses[of]);
  std::vector<PartSurvey> list;
  for (measures::Part& part : parts_of(c, sight.container)) {
    const auto inside = measures::centres_in_part(sight.sight.spheres, sight.container, part.box);
    list.push_back(
        {part,
         measures::part_porosity(solid.spheres, masses, die.surface, sight.container, die.porosity, part.box),
         measures::coordination(inside, sight.sight.contacts, sight.sight.wall_contacts).mean});
  }
  return list;
}

/// Of contacts between parcels of which one at least is in the die, N.
std::vector<double> normal_forces_in(const DieSight& sight) {
  std::vector<double> list;
  list.reserve(sight.forces.pairs.size());
  const auto is_in = [&](std::uint32_t k) {
    return measures::is_inside(sight.container, sight.particles[k].position);
  };
  for (const measures::PairForce& pair : sight.forces.pairs)
    if (is_in(pair.first) || is_in(pair.second)) list.push_back(normal_force(pair));
  return list;
}

std::optional<measures::Stress> stress_in(const DieSight& sight, const DieSurvey& die) {
  if (!(die.fill.volume > 0.0)) return {};
  std::vector<std::uint8_t> in_die;
  in_die.reserve(sight.particles.size());
  for (const measures::Particle& p : sight.particles)
    in_die.push_back(measures::is_inside(sight.container, p.position) ? 1 : 0);
  return measures::stress(sight.particles, in_die, sight.forces.pairs, sight.forces.walls, die.fill.volume);
}

}  // namespace

double field_support(const Case& c) { return measures::support_diameters * mean_parcel_diameter(c); }

std::optional<measures::PorosityField> porosity_of_die(const Case& c, const Simulation& simulation) {
  const auto sight = spheres_in_die(c, simulation);
  if (!sight) return {};
  return porosity_of(c, solid_of(simulation, *sight).spheres, *sight, surface_of(c, *sight));
}

DieSurvey survey_die(const Case& c, const Simulation& simulation, const DieSight& sight) {
  const Sight& seen = sight.sight;
  const measures::PeriodicImages solid = solid_of(simulation, sight);
  DieSurvey die;
  die.container = sight.container;
  die.surface = surface_of(c, sight);
  die.porosity = porosity_of(c, solid.spheres, sight, die.surface);
  die.profiles = measures::porosity_profiles(die.porosity);
  die.histogram = measures::porosity_histogram(die.porosity);
  die.inside = measures::fill_inside(seen.spheres, seen.masses, sight.container);
  die.fill = measures::fill_state(seen.spheres, seen.masses, die.surface, sight.container);
  die.coordination = measures::coordination(seen.spheres, seen.contacts, seen.wall_contacts, sight.container);
  die.parts = survey_parts(c, sight, die, solid);
  die.forces = measures::contact_forces(normal_forces_in(sight));
  die.stress = stress_in(sight, die);
  die.layers = measures::layers(sight.particles, sight.forces.pairs, sight.forces.walls, sight.container, 2,
                                measures::layer_diameters * mean_parcel_diameter(c));
  die.segregation = measures::segregation(seen.spheres, seen.masses, sight.container,
                                          measures::segregation_cell_diameters * mean_parcel_diameter(c));
  return die;
}

std::optional<DieSurvey> survey_die(const Case& c, const Simulation& simulation) {
  const auto sight = look_into_die(c, simulation);
  if (!sight) return {};
  return survey_die(c, simulation, *sight);
}

std::vector<Measure> measures_of(const Simulation& simulation, const std::optional<DieSurvey>& die) {
  std::vector<Measure> list;
  const auto add = [&](const char* name, std::optional<double> value, const char* unit) {
    list.push_back({name, value, unit, "instantaneous"});
  };
  if (die) {
    add("fill_mass", die->inside.mass, "kg");
    add("fill_count", static_cast<double>(die->inside.count), "1");
    add("fill_ratio", die->fill.ratio, "1");
    add("apparent_density", die->fill.density, "kg/m^3");
    add("porosity_mean", die->porosity.mean, "1");
    add("porosity_std", die->porosity.standard_deviation, "1");
    add("porosity_lower_half", die->parts[0].porosity.porosity, "1");
    add("porosity_upper_half", die->parts[1].porosity.porosity, "1");
    add("coordination_mean", die->coordination.mean, "1");
    add("coordination_walls_mean", die->coordination.mean_walls, "1");
    add("coordination_without_rattlers", die->coordination.mean_without_rattlers, "1");
    add("rattler_share", die->coordination.rattler_share, "1");
    add("free_surface_height_mean", die->surface.mean, "m");
    add("free_surface_roughness", die->surface.roughness, "m");
    add("free_surface_tilt", die->surface.tilt, "rad");
    add("contact_force_mean", die->forces.mean, "N");
    add("segregation_index", die->segregation.index, "1");
    add("segregation_intensity", die->segregation.intensity, "1");
    add("pressure_mean", die->stress ? std::optional(die->stress->pressure()) : std::nullopt, "Pa");
  }
  if (simulation.model().domain.shear.any()) {
    const ShearedBox box = look_at_sheared_box(simulation);
    add("pressure", box.stress.pressure(), "Pa");
    add("pressure_kinetic", box.stress.kinetic_pressure(), "Pa");
    add("shear_stress", box.shear_stress, "Pa");
    add("solid_fraction", box.solid_fraction, "1");
    add("coordination", box.coordination, "1");
    add("granular_temperature", box.temperature, "m^2/s^2");
  }
  const auto energies = measures::energies(look_at(simulation).bodies, simulation.field().gravity);
  add("kinetic_energy_translational", energies.translational, "J");
  add("kinetic_energy_rotational", energies.rotational, "J");
  add("potential_energy", energies.potential, "J");
  return list;
}

}  // namespace pulvis
