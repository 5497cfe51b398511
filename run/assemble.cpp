// SPDX-License-Identifier: Apache-2.0
#include "run/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "run/bed_file.hpp"

namespace pulvis {
namespace {

constexpr double densest_random_pack = 0.36;  // random sequential placement stops near 0.38

[[noreturn]] void fail(const Case& c, const std::string& message) {
  throw Failure(Exit::bad_case, fmt::format("{}: error: {}", c.file, message));
}

std::string in_mm(double metres) { return format_quantity(metres, dimension::length); }

void check_coarse_graining(const Case& c) {
  for (const Powder& p : c.powders)
    if (p.coarse_graining != c.powders.front().coarse_graining)
      fail(c,
           fmt::format("powders {} and {} have different coarse_graining ({:g} and {:g}); contacts between "
                       "them would have no similarity\n  give all powders of a case the same factor",
                       c.powders.front().name, p.name, c.powders.front().coarse_graining, p.coarse_graining));
}

ContactClasses contact_classes(const Case& c, const std::vector<Species>& species,
                               const std::vector<PairProperties>& pairs) {
  laws::Choices choices;
  choices.limit_includes_dashpot = c.contact.friction_limit == "total";
  choices.damping_on_jkr_radius = c.contact.damping_radius == "jkr_radius";
  ContactClasses classes(species.size());
  for (const PairProperties& p : pairs) {
    ContactClass contact;
    // Without adhesion JKR is Hertz (its formulas would divide zero by zero).
    const bool plain = c.contact.normal == "jkr" && p.simulated.work_of_adhesion == 0.0;
    contact.law = laws::find_law(plain ? "hertz" : c.contact.normal, c.contact.damping, c.contact.sliding,
                                 c.contact.rolling);
    contact.constants = laws::catalogue()[contact.law].mix(p.simulated, choices);
    contact.kernel = kernels::contact_kernel(contact.law, kernels::instruction_set());
    classes.set(p.first, p.second, contact);
  }
  return classes;
}

void check_against_parcels(const Case& c, const Wall& wall, double largest_diameter) {
  double narrowest = 1e300;
  if (wall.shape == Wall::Shape::box)
    for (int axis = 0; axis < 3; ++axis)
      narrowest = std::min(narrowest, wall.region.max[axis] - wall.region.min[axis]);
  else if (wall.shape == Wall::Shape::cylinder)
    narrowest = std::min(2.0 * wall.region.radius, wall.region.height);
  if (narrowest < 3.0 * largest_diameter)
    fail(c, fmt::format("walls.{} is only {} wide, less than three of the largest parcels ({})\n  lower "
                        "coarse_graining, or check the units of the wall: is it in mm?",
                        wall.name, in_mm(narrowest), in_mm(largest_diameter)));
}

void add_walls(const Case& c, const std::vector<Species>& species, double largest_diameter, Model& model) {
  for (const Wall& wall : c.walls) {
    check_against_parcels(c, wall, largest_diameter);
    Body body;
    body.name = wall.name;
    body.species = static_cast<std::uint32_t>(species_of_material(species, wall.material));
    body.motion = wall.motion;
    std::vector<Surface> surfaces;
    switch (wall.shape) {
      case Wall::Shape::plane:
        surfaces = {plane_surface(wall.name, wall.point, wall.normal)};
        break;
      case Wall::Shape::box:
        surfaces = box_surfaces(wall.name, wall.region, wall.open);
        break;
      case Wall::Shape::cylinder:
        surfaces = cylinder_surfaces(wall.name, wall.region, wall.open);
        break;
    }
    for (Surface& s : surfaces) {
      s.body = static_cast<std::uint32_t>(model.bodies.size());
      model.surfaces.push_back(s);
    }
    model.bodies.push_back(body);
  }
}

double volume_of(const Region& r) {
  if (r.shape == Region::Shape::cylinder) return 3.14159265358979323846 * square(r.radius) * r.height;
  const Vec3 e = r.max - r.min;
  return e.x * e.y * e.z;
}

void check_region(const Case& c, const Source& source, const SizeSampler& sizes) {
  const Region& r = source.region;
  const double narrowest = r.shape == Region::Shape::cylinder
                               ? std::min(2.0 * r.radius, r.height)
                               : std::min({r.max.x - r.min.x, r.max.y - r.min.y, r.max.z - r.min.z});
  if (narrowest < sizes.largest())
    fail(c, fmt::format(
                "sources.{}.region is {} thin and cannot hold the largest parcel ({})\n  enlarge the region "
                "or lower coarse_graining",
                source.name, in_mm(narrowest), in_mm(sizes.largest())));
  if (source.kind != Source::Kind::pack) return;
  const double parcels = expected_parcels(c, source);
  const double solid = parcels * sphere_volume(0.5) * sizes.mean_cube() / volume_of(r);
  if (solid > densest_random_pack)
    fail(c, fmt::format(
                "sources.{} asks for {:.0f} parcels, {:.0f} % of its region; a random pack without overlap "
                "holds at most about {:.0f} % ({:.0f} parcels)\n  ask for less, enlarge the region, or let "
                "it rain",
                source.name, parcels, 100 * solid, 100 * densest_random_pack,
                parcels * densest_random_pack / solid));
}

/// The parcels of each source that is a bed in a file.
std::vector<std::vector<Parcel>> read_beds(const Case& c, const Box& domain) {
  std::vector<std::vector<Parcel>> beds(c.sources.size());
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    const Source& source = c.sources[k];
    if (source.kind != Source::Kind::file) continue;
    beds[k] = read_bed(source.path, c.materials[c.powders[source.powder].material].density,
                       static_cast<std::uint32_t>(species_of_powder(source.powder)), domain);
  }
  return beds;
}

/// Radius of the smallest parcel of each powder, m, by species: a bed may have smaller ones than the case
/// says, and the time step must hold for them too.
std::vector<double> smallest_radii(const Case& c, const std::vector<Species>& species,
                                   const std::vector<std::vector<Parcel>>& beds) {
  std::vector<double> smallest(species.size(), 0.0);
  for (std::size_t k = 0; k < c.powders.size(); ++k)
    smallest[species_of_powder(k)] = 0.5 * SizeSampler(parcel_sizes(c.powders[k])).smallest();
  for (const auto& bed : beds)
    for (const Parcel& p : bed) smallest[p.species] = std::min(smallest[p.species], p.radius);
  return smallest;
}

SourceModel source_model(const Case& c, const Source& source, std::vector<Parcel> bed) {
  const Powder& powder = c.powders[source.powder];
  SourceModel m;
  m.name = source.name;
  m.species = static_cast<std::uint32_t>(species_of_powder(source.powder));
  m.density = c.materials[powder.material].density;
  m.sizes = SizeSampler(parcel_sizes(powder));
  m.region = source.region;
  m.velocity = source.velocity;
  m.rate = source.mass_rate;
  m.target_count = source.target.count;
  m.target_mass = source.target.mass;
  switch (source.kind) {
    case Source::Kind::pack:
      m.kind = SourceModel::Kind::pack;
      break;
    case Source::Kind::rain:
      m.kind = SourceModel::Kind::rain;
      break;
    case Source::Kind::file:
      m.kind = SourceModel::Kind::list;
      m.list = std::move(bed);
      return m;
  }
  check_region(c, source, *m.sizes);
  return m;
}

}  // namespace

double expected_parcels(const Case& c, const Source& source) {
  if (source.target.count) return static_cast<double>(*source.target.count);
  if (!source.target.mass) return 0.0;
  const Powder& powder = c.powders[source.powder];
  const double mean_mass = c.materials[powder.material].density * sphere_volume(0.5) *
                           SizeSampler(parcel_sizes(powder)).mean_cube();
  return std::round(*source.target.mass / mean_mass);
}

Assembly assemble(const Case& c) {
  if (c.powders.empty()) fail(c, "there is no powder\n  add a table [powders.NAME]");
  check_coarse_graining(c);
  Assembly a;
  a.species = species_of(c);
  a.pairs = mix_pairs(c, a.species);

  Model& m = a.model;
  m.domain.min = c.domain.min;
  m.domain.max = c.domain.max;
  for (int axis = 0; axis < 3; ++axis) m.domain.periodic[axis] = c.domain.periodic[axis];
  auto beds = read_beds(c, m.domain);
  a.time_step = choose_time_step(c, a.species, a.pairs, smallest_radii(c, a.species, beds));
  m.gravity = c.gravity;
  m.dt = a.time_step.step;
  m.seed = c.seed;
  m.smallest_radius = 1e300;
  for (const Powder& powder : c.powders) {
    const SizeSampler sizes(parcel_sizes(powder));
    m.smallest_radius = std::min(m.smallest_radius, 0.5 * sizes.smallest());
    m.largest_radius = std::max(m.largest_radius, 0.5 * sizes.largest());
  }
  for (int axis = 0; axis < 3; ++axis)
    if (m.domain.periodic[axis] && m.domain.extent()[axis] < 6.0 * m.largest_radius)
      fail(c, fmt::format(
                  "the periodic domain is narrower than three parcels ({}) along {}\n  enlarge it or lower "
                  "coarse_graining",
                  in_mm(2.0 * m.largest_radius), "xyz"[axis]));
  for (const Motion& motion : c.motions)
    m.motions.push_back({motion.amplitude, motion.frequency, motion.phase, motion.direction});
  m.classes = contact_classes(c, a.species, a.pairs);
  add_walls(c, a.species, 2.0 * m.largest_radius, m);
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    m.sources.push_back(source_model(c, c.sources[k], std::move(beds[k])));
    for (const Parcel& p : m.sources.back().list) {
      m.smallest_radius = std::min(m.smallest_radius, p.radius);
      m.largest_radius = std::max(m.largest_radius, p.radius);
    }
  }
  for (const SineMotion& motion : m.motions)
    if (motion.peak_speed() * m.dt > 0.05 * m.smallest_radius)
      fail(c, fmt::format(
                  "a wall moves {} in one time step, more than 5 % of the smallest radius ({})\n  lower the "
                  "motion's amplitude or frequency, or time.fraction",
                  in_mm(motion.peak_speed() * m.dt), in_mm(m.smallest_radius)));
  return a;
}

}  // namespace pulvis
