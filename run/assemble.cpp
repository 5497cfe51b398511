// SPDX-License-Identifier: Apache-2.0
#include "run/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "run/bed_file.hpp"
#include "run/build_walls.hpp"
#include "run/pair_law.hpp"
#include "run/problems.hpp"
#include "run/source_checks.hpp"

namespace pulvis {
namespace {

constexpr double most_parcels = 2147483647.0;  // ids have 31 bits

void check_coarse_graining(const Case& c, Problems& problems) {
  const Powder& first = c.powders.front();
  for (const Powder& p : c.powders)
    if (p.coarse_graining != first.coarse_graining)
      problems.add(
          fmt::format("powders.{}.coarse_graining", p.name),
          fmt::format("powders {} and {} have different coarse_graining ({:g} and {:g}); contacts between "
                      "them would have no similarity\n  give all powders of a case the same factor",
                      first.name, p.name, first.coarse_graining, p.coarse_graining),
          {fmt::format("powders.{}.coarse_graining", first.name)});
}

void check_similarity(const Case& c, Problems& problems) {
  if (const std::string why = named_law(c.contact).why_not(similarity(c.contact)); !why.empty())
    problems.add("contact.similarity",
                 fmt::format("contact.similarity = \"{}\" has no rule for this law: {}\n  take \"stress\", "
                             "or \"none\" and scale the numbers by hand",
                             c.contact.similarity, why));
}

/// A pair of softened powders has one adhesion, which cannot keep both the pull-off and the sticking speed.
void check_keep(const Case& c, const Assembly& a, Problems& problems) {
  for (const PairProperties& pair : a.pairs) {
    const Species &s1 = a.species[pair.first], &s2 = a.species[pair.second];
    if (!s1.is_softened() || !s2.is_softened() || pair.real.work_of_adhesion == 0.0) continue;
    const Powder &first = c.powders[s1.powder], &second = c.powders[s2.powder];
    if (first.keep == second.keep) continue;
    problems.add(
        fmt::format("powders.{}.keep", second.name),
        fmt::format("powders {} and {} are both softened, but differ in what they keep; the adhesion "
                    "between them cannot follow both\n  give them the same keep",
                    first.name, second.name),
        {fmt::format("powders.{}.keep", first.name)});
  }
}

/// What the law itself refuses, said once for each pair of species.
void check_law(const Case& c, const std::vector<Species>& species, const std::vector<PairProperties>& pairs,
               Problems& problems) {
  for (const PairProperties& p : pairs) {
    laws::Law law = named_law(c.contact);
    // A pair may have no bridges or no tail, which the law itself does not know as a value.
    if (law.cohesion->reaches) law.cohesion = pair_law(c.contact, p.real).cohesion;
    for (const std::string& problem : law.problems(p.real, law_choices(c.contact)))
      problems.add("contact",
                   fmt::format("{} / {}: {}", species[p.first].name, species[p.second].name, problem),
                   {"materials", "powders", "pairs"});
  }
}

ContactClasses contact_classes(const Case& c, const std::vector<Species>& species,
                               const std::vector<PairProperties>& pairs) {
  const laws::Choices choices = law_choices(c.contact);
  ContactClasses classes(species.size());
  for (const PairProperties& p : pairs) {
    ContactClass contact;
    contact.law = pair_law(c.contact, p.simulated);
    contact.constants = contact.law.mix(p.simulated, choices);
    contact.kernel = kernels::contact_kernel(contact.law, kernels::instruction_set());
    classes.set(p.first, p.second, contact);
  }
  return classes;
}

/// Tables of the case that say how many parcels a source gives, and how large they are.
std::vector<std::string> amount_follows_from(const Case& c, const Source& source) {
  const Powder& powder = c.powders[source.powder];
  return {"sources." + source.name, "powders." + powder.name,
          "materials." + c.materials[powder.material].name};
}

void check_source(const Case& c, const Source& source, const SourceModel& model, Problems& problems) {
  for (const auto& [key, message] : source_problems(source, model, expected_parcels(c, source)))
    problems.add("sources." + source.name + (key.empty() ? "" : "." + key), message,
                 amount_follows_from(c, source));
}

void check_count(const Case& c, Problems& problems) {
  for (const Source& source : c.sources)
    if (const double parcels = expected_parcels(c, source); parcels > most_parcels)
      problems.add(
          "sources." + source.name,
          fmt::format("sources.{} asks for {:.4g} parcels; a run holds at most {:.0f}\n  ask for less, "
                      "or raise coarse_graining",
                      source.name, parcels, most_parcels),
          amount_follows_from(c, source));
}

/// The parcels of each source that is a bed in a file.
std::vector<Bed> read_beds(const Case& c, const Box& domain) {
  std::vector<Bed> beds(c.sources.size());
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    const Source& source = c.sources[k];
    if (source.kind != Source::Kind::file) continue;
    beds[k] = named_by(c, fmt::format("sources.{}.path", source.name), [&] {
      return read_bed(source.path, c.materials[c.powders[source.powder].material].density,
                      static_cast<std::uint32_t>(species_of_powder(source.powder)), domain);
    });
  }
  return beds;
}

/// Radius of the smallest parcel of each powder, m, by species: a bed may have smaller ones than the case
/// says, and the time step must hold for them too.
std::vector<double> smallest_radii(const Case& c, const std::vector<Species>& species,
                                   const std::vector<Bed>& beds) {
  std::vector<double> smallest(species.size(), 0.0);
  for (std::size_t k = 0; k < c.powders.size(); ++k)
    smallest[species_of_powder(k)] = 0.5 * SizeSampler(parcel_sizes(c.powders[k])).smallest();
  for (const Bed& bed : beds)
    for (const Parcel& p : bed.parcels) smallest[p.species] = std::min(smallest[p.species], p.radius);
  return smallest;
}

/// Radii of all parcels that can appear: those of the powders and of the beds.
void find_radii(const Case& c, const std::vector<Bed>& beds, Model& m) {
  m.smallest_radius = 1e300;
  const auto add = [&](double smallest, double largest) {
    m.smallest_radius = std::min(m.smallest_radius, smallest);
    m.largest_radius = std::max(m.largest_radius, largest);
  };
  for (const Powder& powder : c.powders) {
    const SizeSampler sizes(parcel_sizes(powder));
    add(0.5 * sizes.smallest(), 0.5 * sizes.largest());
  }
  for (const Bed& bed : beds)
    for (const Parcel& p : bed.parcels) add(p.radius, p.radius);
}

/// A part of the die that is measured by itself must hold a parcel.
void check_parts(const Case& c, double largest_diameter, Problems& problems) {
  for (const MeasuredPart& part : c.measures.parts) {
    const Vec3 size = part.max - part.min;
    const double width = std::min({size.x, size.y, size.z});
    if (width >= largest_diameter) continue;
    problems.add(
        "measures.parts." + part.name,
        fmt::format("measures.parts.{} is {} thin, less than the largest parcel ({})\n  enlarge it or lower "
                    "coarse_graining",
                    part.name, in_mm(width), in_mm(largest_diameter)));
  }
}

void check_periodic_widths(const Model& m, Problems& problems) {
  for (int axis = 0; axis < 3; ++axis)
    if (const double least = m.domain.shear.any() ? 5.0 : 3.0;
        m.domain.periodic[axis] && m.domain.extent()[axis] < least * 2.0 * m.largest_radius)
      problems.add("domain",
                   fmt::format("the {} domain is narrower than {:g} parcels ({}) along {}\n  enlarge "
                               "it or lower coarse_graining",
                               m.domain.shear.any() ? "sheared" : "periodic", least,
                               in_mm(2.0 * m.largest_radius), "xyz"[axis]),
                   {"powders"});
}

/// Distance of a centre to the nearest wall over the radius, and the name of that wall.
std::pair<double, std::string> nearest_wall(const Walls& walls, const Parcel& p) {
  std::pair<double, std::string> result{1e300, ""};
  for (const Surface& s : walls.surfaces) {
    if (s.kind == Surface::Kind::patch) continue;
    const double distance = norm(nearest_point(s, p.position).point - p.position) / p.radius;
    if (distance < result.first) result = {distance, s.name};
  }
  for (const FacetedWall& mesh : walls.meshes)
    mesh.for_near(p.position, p.radius, [&](std::uint32_t triangle) {
      const double distance = norm(mesh.nearest(triangle, p.position).point - p.position) / p.radius;
      if (distance < result.first) result = {distance, walls.names[walls.surfaces[mesh.first_surface].wall]};
    });
  return result;
}

/// A bed that sits in a wall was made for another die; its parcels would be thrown out of the wall.
void check_bed_against_walls(const std::string& path, const Bed& bed, const Walls& walls) {
  constexpr double closest = 0.5;  // radii; contacts never come near it
  std::size_t count = 0, worst = 0;
  std::pair<double, std::string> least{closest, ""};
  for (std::size_t k = 0; k < bed.parcels.size(); ++k) {
    const auto found = nearest_wall(walls, bed.parcels[k]);
    if (found.first >= closest) continue;
    ++count;
    if (found.first < least.first) least = found, worst = k;
  }
  if (count == 0) return;
  throw Failure(
      Exit::bad_input,
      fmt::format("{}: error: {} of {} parcels lie in a wall, with their centres closer to it than "
                  "half a radius; worst is parcel {}, {:.2g} radii from {}\n  was the bed made with "
                  "these walls? Move them, or take another bed",
                  path, count, bed.parcels.size(), bed.ids[worst], least.first, least.second));
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
  if (source.sieve_pitch) m.sieve = Sieve{*source.sieve_pitch, *source.sieve_opening};
  m.target_count = source.target.count;
  m.target_mass = source.target.mass;
  switch (source.kind) {
    case Source::Kind::dense:
      m.kind = SourceModel::Kind::dense;
      m.target_count = static_cast<std::uint64_t>(expected_parcels(c, source));
      break;
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
  return m;
}

}  // namespace

double expected_parcels(const Case& c, const Source& source) {
  if (source.target.count) return static_cast<double>(*source.target.count);
  const Powder& powder = c.powders[source.powder];
  if (source.kind == Source::Kind::dense)
    return std::round(source.solid_fraction * volume(source.region) /
                      (sphere_volume(0.5) * SizeSampler(parcel_sizes(powder)).mean_cube()));
  if (!source.target.mass) return 0.0;
  const double mean_mass = c.materials[powder.material].density * sphere_volume(0.5) *
                           SizeSampler(parcel_sizes(powder)).mean_cube();
  return std::round(*source.target.mass / mean_mass);
}

Assembly assemble(const Case& c) {
  Problems problems(c);
  if (c.powders.empty()) problems.add("powders", "there is no powder\n  add a table [powders.NAME]");
  problems.throw_if_any();
  check_coarse_graining(c, problems);
  check_similarity(c, problems);
  check_count(c, problems);
  problems.throw_if_any();  // pairs need the rules
  Assembly a;
  a.species = species_of(c);
  a.pairs = mix_pairs(c, a.species);
  check_keep(c, a, problems);

  Model& m = a.model;
  m.domain.min = c.domain.min;
  m.domain.max = c.domain.max;
  for (int axis = 0; axis < 3; ++axis) m.domain.periodic[axis] = c.domain.periodic[axis];
  m.domain.shear = c.domain.shear;
  auto beds = read_beds(c, m.domain);
  find_radii(c, beds, m);
  BuiltWalls built = build_walls(c, a.species, m.largest_radius);
  m.walls = std::move(built.walls);
  a.notes = std::move(built.notes);
  a.warnings = std::move(built.warnings);
  check_walls(c, m.walls, m.largest_radius, problems);
  problems.throw_if_any();  // what follows asks where walls are
  a.time_step = choose_time_step(c, a.species, a.pairs, m.walls, smallest_radii(c, a.species, beds));
  if (const std::string wrong = step_problem(c, a.time_step); !wrong.empty())
    problems.add("time.step", wrong, {"materials", "powders", "contact", "pairs"});
  m.body_force = c.body_force;
  m.dt = a.time_step.step;
  m.seed = c.seed;
  if (m.domain.shear.any())
    a.notes.push_back(
        fmt::format("the domain is sheared along {} across {}: a strain of 1 takes {} or {:.3g} steps",
                    "xyz"[m.domain.shear.flow], "xyz"[m.domain.shear.gradient],
                    format_quantity(1.0 / magnitude(m.domain.shear.rate), dimension::time),
                    1.0 / (magnitude(m.domain.shear.rate) * m.dt)));
  m.energy_ledger = c.measures.energy_ledger;
  if (m.energy_ledger && m.domain.shear.any())
    problems.add("measures.energy_ledger",
                 "the ledger of energy does not know the work of sheared faces\n  leave it out where the "
                 "domain is sheared");
  check_periodic_widths(m, problems);
  check_parts(c, 2.0 * m.largest_radius, problems);
  for (const Motion& motion : c.motions) m.motions.push_back(motion.motion);
  check_law(c, a.species, a.pairs, problems);
  m.classes = contact_classes(c, a.species, a.pairs);
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    m.sources.push_back(source_model(c, c.sources[k], beds[k].parcels));
    if (c.sources[k].kind == Source::Kind::file) continue;
    check_source(c, c.sources[k], m.sources.back(), problems);
    check_walls_in_region(c, c.sources[k], m.walls, m.domain, problems);
  }
  check_wall_speeds(c, m.walls, m.dt, m.smallest_radius, problems);
  problems.throw_if_any();
  check_bodies_keep_apart(c, m.walls, m.domain, m.dt, problems);
  problems.throw_if_any();
  for (std::size_t k = 0; k < c.sources.size(); ++k)
    check_bed_against_walls(c.sources[k].path, beds[k], m.walls);
  return a;
}

}  // namespace pulvis
