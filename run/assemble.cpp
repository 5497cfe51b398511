// SPDX-License-Identifier: Apache-2.0
#include "run/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/reader.hpp"
#include "case/units.hpp"
#include "engine/base/failure.hpp"
#include "run/bed_file.hpp"
#include "run/source_checks.hpp"

namespace pulvis {
namespace {

constexpr double rounding = 1e-9;              // m; shapes that touch do not cut each other
constexpr double most_parcels = 2147483647.0;  // ids have 31 bits

/// What does not fit together in a case, collected so that the user sees all of it at once.
class Problems {
 public:
  explicit Problems(const Case& c) : case_(c) {}
  /// `key`: the key or table of the case to point at.
  void add(const std::string& key, const std::string& message) {
    text_ += fmt::format("{}{}: error: {}", text_.empty() ? "" : "\n", place_of(case_, key), message);
  }
  void throw_if_any() const {
    if (!text_.empty()) throw Failure(Exit::bad_case, text_);
  }

 private:
  const Case& case_;
  std::string text_;
};

std::string in_mm(double metres) { return format_quantity(metres, dimension::length); }

void check_coarse_graining(const Case& c, Problems& problems) {
  const Powder& first = c.powders.front();
  for (const Powder& p : c.powders)
    if (p.coarse_graining != first.coarse_graining)
      problems.add(
          fmt::format("powders.{}.coarse_graining", p.name),
          fmt::format("powders {} and {} have different coarse_graining ({:g} and {:g}); contacts between "
                      "them would have no similarity\n  give all powders of a case the same factor",
                      first.name, p.name, first.coarse_graining, p.coarse_graining));
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
                    first.name, second.name));
  }
}

ContactClasses contact_classes(const Case& c, const std::vector<Species>& species,
                               const std::vector<PairProperties>& pairs) {
  laws::Choices choices;
  choices.limit_includes_dashpot = c.contact.friction_limit == "total";
  choices.damping_on_jkr_radius = c.contact.damping_radius == "jkr_radius";
  ContactClasses classes(species.size());
  for (const PairProperties& p : pairs) {
    ContactClass contact;
    // Without adhesion Hertz is the limit of JKR, and cheaper.
    const bool plain = c.contact.normal == "jkr" && p.simulated.work_of_adhesion == 0.0;
    contact.law = laws::find_law(plain ? "hertz" : c.contact.normal, c.contact.damping, c.contact.sliding,
                                 c.contact.rolling);
    contact.constants = laws::catalogue()[contact.law].mix(p.simulated, choices);
    contact.kernel = kernels::contact_kernel(contact.law, kernels::instruction_set());
    classes.set(p.first, p.second, contact);
  }
  return classes;
}

void check_against_parcels(const Wall& wall, double largest_diameter, Problems& problems) {
  double narrowest = 1e300;
  if (wall.shape == Wall::Shape::box)
    for (int axis = 0; axis < 3; ++axis)
      narrowest = std::min(narrowest, wall.region.max[axis] - wall.region.min[axis]);
  else if (wall.shape == Wall::Shape::cylinder)
    narrowest = std::min(2.0 * wall.region.radius, wall.region.height);
  if (narrowest < 3.0 * largest_diameter)
    problems.add("walls." + wall.name,
                 fmt::format("walls.{} is only {} wide, less than three of the largest parcels ({})\n  lower "
                             "coarse_graining, or check the units of the wall: is it in mm?",
                             wall.name, in_mm(narrowest), in_mm(largest_diameter)));
}

void add_walls(const Case& c, const std::vector<Species>& species, Model& model, Problems& problems) {
  for (const Wall& wall : c.walls) {
    check_against_parcels(wall, 2.0 * model.largest_radius, problems);
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

/// Points of a region, its corners and rims among them.
std::vector<Vec3> samples_of(const Region& r) {
  constexpr int steps = 16;
  std::vector<Vec3> points;
  const Vec3 u = perpendicular(r.axis), v = cross(r.axis, u);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k) {
        const double a = i / double(steps), b = j / double(steps), h = k / double(steps);
        const Vec3 e = r.max - r.min;
        const double turn = 2.0 * pi * b, out = a * r.radius;
        points.push_back(r.shape == Region::Shape::box
                             ? r.min + Vec3{a * e.x, b * e.y, h * e.z}
                             : r.base + h * r.height * r.axis + out * std::cos(turn) * u +
                                   out * std::sin(turn) * v);
      }
  return points;
}

/// Whether parts of a region lie on both sides of a surface, within its edges. Regions are convex, so that
/// the surface then passes through; of a finite one a corner can go unseen between the samples.
bool passes_through(const Surface& s, const std::vector<Vec3>& samples) {
  bool before = false, behind = false;
  for (const Vec3& p : samples) {
    const NearestPoint nearest = nearest_point(s, p);
    if (!nearest.in_face) continue;
    behind = behind || nearest.elevation < -rounding;
    before = before || nearest.elevation > rounding;
  }
  return before && behind;
}

/// The same for a rectangle along the axes and a box, exactly.
bool rectangle_passes_through(const Surface& s, const Region& box) {
  for (int axis = 0; axis < 3; ++axis) {
    const double half = std::abs(s.side[0][axis]) * s.half[0] + std::abs(s.side[1][axis]) * s.half[1];
    if (s.centre[axis] + half <= box.min[axis] + rounding) return false;
    if (s.centre[axis] - half >= box.max[axis] - rounding) return false;
  }
  return true;
}

/// Parcels that appear in a wall are pushed out of it at any speed, on either side.
void check_walls_in_region(const Source& source, const std::vector<Surface>& surfaces, Problems& problems) {
  const bool box = source.region.shape == Region::Shape::box;
  const std::vector<Vec3> samples = samples_of(source.region);
  for (const Surface& s : surfaces) {
    const bool exact = box && s.kind == Surface::Kind::rectangle;
    if (!(exact ? rectangle_passes_through(s, source.region) : passes_through(s, samples))) continue;
    problems.add(
        fmt::format("sources.{}.region", source.name),
        fmt::format("the wall {} passes through sources.{}.region; parcels would appear in the wall\n"
                    "  keep the region on one side of it",
                    s.name, source.name));
  }
}

void check_source(const Case& c, const Source& source, const SourceModel& model, Problems& problems) {
  for (const auto& [key, message] : source_problems(source, model, expected_parcels(c, source)))
    problems.add("sources." + source.name + (key.empty() ? "" : "." + key), message);
}

void check_count(const Case& c, Problems& problems) {
  for (const Source& source : c.sources)
    if (const double parcels = expected_parcels(c, source); parcels > most_parcels)
      problems.add(
          "sources." + source.name,
          fmt::format("sources.{} asks for {:.4g} parcels; a run holds at most {:.0f}\n  ask for less, "
                      "or raise coarse_graining",
                      source.name, parcels, most_parcels));
}

/// The parcels of each source that is a bed in a file.
std::vector<Bed> read_beds(const Case& c, const Box& domain) {
  std::vector<Bed> beds(c.sources.size());
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

void check_periodic_widths(const Model& m, Problems& problems) {
  for (int axis = 0; axis < 3; ++axis)
    if (m.domain.periodic[axis] && m.domain.extent()[axis] < 6.0 * m.largest_radius)
      problems.add(
          "domain",
          fmt::format(
              "the periodic domain is narrower than three parcels ({}) along {}\n  enlarge it or lower "
              "coarse_graining",
              in_mm(2.0 * m.largest_radius), "xyz"[axis]));
}

/// Distance of a centre to the nearest surface over the radius, and which surface that is.
std::pair<double, const Surface*> nearest_surface(const std::vector<Surface>& surfaces, const Parcel& p) {
  std::pair<double, const Surface*> result{1e300, nullptr};
  for (const Surface& s : surfaces) {
    const double distance = norm(nearest_point(s, p.position).point - p.position) / p.radius;
    if (distance < result.first) result = {distance, &s};
  }
  return result;
}

/// A bed that sits in a wall was made for another die; its parcels would be thrown out of the wall.
void check_bed_against_walls(const std::string& path, const Bed& bed, const std::vector<Surface>& surfaces) {
  constexpr double closest = 0.5;  // radii; contacts never come near it
  std::size_t count = 0, worst = 0;
  std::pair<double, const Surface*> least{closest, nullptr};
  for (std::size_t k = 0; k < bed.parcels.size(); ++k) {
    const auto found = nearest_surface(surfaces, bed.parcels[k]);
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
                  path, count, bed.parcels.size(), bed.ids[worst], least.first, least.second->name));
}

void check_motions(const Case& c, const Model& m, Problems& problems) {
  for (std::size_t k = 0; k < m.motions.size(); ++k)
    if (const double leap = m.motions[k].peak_speed() * m.dt; leap > 0.05 * m.smallest_radius)
      problems.add(
          "motions." + c.motions[k].name,
          fmt::format(
              "a wall moves {} in one time step, more than 5 % of the smallest radius ({})\n  lower the "
              "motion's amplitude or frequency, or time.fraction",
              in_mm(leap), in_mm(m.smallest_radius)));
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
  if (!source.target.mass) return 0.0;
  const Powder& powder = c.powders[source.powder];
  const double mean_mass = c.materials[powder.material].density * sphere_volume(0.5) *
                           SizeSampler(parcel_sizes(powder)).mean_cube();
  return std::round(*source.target.mass / mean_mass);
}

Assembly assemble(const Case& c) {
  Problems problems(c);
  if (c.powders.empty()) problems.add("powders", "there is no powder\n  add a table [powders.NAME]");
  problems.throw_if_any();
  check_coarse_graining(c, problems);
  check_count(c, problems);
  Assembly a;
  a.species = species_of(c);
  a.pairs = mix_pairs(c, a.species);
  check_keep(c, a, problems);

  Model& m = a.model;
  m.domain.min = c.domain.min;
  m.domain.max = c.domain.max;
  for (int axis = 0; axis < 3; ++axis) m.domain.periodic[axis] = c.domain.periodic[axis];
  auto beds = read_beds(c, m.domain);
  find_radii(c, beds, m);
  a.time_step = choose_time_step(c, a.species, a.pairs, smallest_radii(c, a.species, beds));
  if (const std::string wrong = step_problem(c, a.time_step); !wrong.empty())
    problems.add("time.step", wrong);
  m.gravity = c.gravity;
  m.dt = a.time_step.step;
  m.seed = c.seed;
  check_periodic_widths(m, problems);
  for (const Motion& motion : c.motions)
    m.motions.push_back({motion.amplitude, motion.frequency, motion.phase, motion.direction});
  m.classes = contact_classes(c, a.species, a.pairs);
  add_walls(c, a.species, m, problems);
  for (std::size_t k = 0; k < c.sources.size(); ++k) {
    m.sources.push_back(source_model(c, c.sources[k], beds[k].parcels));
    if (c.sources[k].kind == Source::Kind::file) continue;
    check_source(c, c.sources[k], m.sources.back(), problems);
    check_walls_in_region(c.sources[k], m.surfaces, problems);
  }
  check_motions(c, m, problems);
  problems.throw_if_any();
  for (std::size_t k = 0; k < c.sources.size(); ++k)
    check_bed_against_walls(c.sources[k].path, beds[k], m.surfaces);
  return a;
}

}  // namespace pulvis
