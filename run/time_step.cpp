// SPDX-License-Identifier: Apache-2.0
#include "run/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/failure.hpp"
#include "engine/laws/time_limits.hpp"
#include "engine/parcels/parcels.hpp"
#include "run/body_pull.hpp"
#include "run/build_walls.hpp"
#include "run/pair_law.hpp"
#include "run/species.hpp"
#include "run/wall_mesh.hpp"

namespace pulvis {
namespace {

/// Depths (along gravity, m) of the corners of a box.
struct Depths {
  double shallowest = 1e300, deepest = -1e300;
  void add(double depth) {
    shallowest = least(shallowest, depth);
    deepest = greatest(deepest, depth);
  }
  void add_box(const Vec3& down, const Vec3& low, const Vec3& high) {
    for (int k = 0; k < 8; ++k)
      add(dot(down, Vec3{k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z}));
  }
  void add_region(const Vec3& down, const Region& r) {
    if (r.shape == Region::Shape::box) return add_box(down, r.min, r.max);
    const double along = dot(down, r.axis), reach = r.radius * root(greatest(1.0 - along * along, 0.0));
    for (const double end : {0.0, r.height})
      for (const double side : {-reach, reach}) add(dot(down, r.base) + end * along + side);
  }
};

/// Largest distance a parcel of this source can fall, m: to the deepest wall below it, or to the end of the
/// domain where there is none.
double fall_height(const Case& c, const Walls& built, const Source& source) {
  const Vec3 gravity = strongest_pull(c);
  const double g = norm(gravity);
  if (g == 0.0) return 0.0;
  const Vec3 down = gravity / g;
  const Box domain{c.domain.min, c.domain.max, {}};
  Depths start, end, walls;
  end.add_box(down, c.domain.min, c.domain.max);
  if (source.kind == Source::Kind::file)
    start.add(end.shallowest);
  else
    start.add_region(down, source.region);
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    Vec3 low, high;
    if (bounds_of_wall(built, w, low, high))
      walls.add_box(down, low, high);
    else  // a plane, as far as the domain reaches
      for (const Vec3& p :
           triangles_of(plane_surface("", c.walls[w].point, c.walls[w].normal), domain).points)
        walls.add(dot(down, p));
  }
  const double floor = walls.deepest > start.shallowest ? least(end.deepest, walls.deepest) : end.deepest;
  return greatest(floor - start.shallowest, 0.0);
}

std::string pair_name(const std::vector<Species>& species, const PairProperties& p) {
  return species[p.first].name + " / " + species[p.second].name;
}

}  // namespace

double characteristic_speed(const Case& c, const Walls& walls) {
  if (c.time.characteristic_speed) return *c.time.characteristic_speed;
  double highest = 1e-3;  // a case in which nothing moves still needs a limit
  for (const Phase& phase : c.phases) {
    double parcels = 0.0;
    for (const std::size_t s : phase.sources) {
      const Source& source = c.sources[s];
      const double fall = 2.0 * norm(strongest_pull(c)) * fall_height(c, walls, source);
      parcels = greatest(parcels, root(dot(source.velocity, source.velocity) + fall));
    }
    highest = greatest(highest, parcels + peak_wall_speed(c, walls, phase));
  }
  // Neighbours in a sheared domain pass each other at about rate times diameter, and dash about as fast again.
  for (const Powder& powder : c.powders)
    highest =
        greatest(highest, 2.0 * magnitude(c.domain.shear.rate) * SizeSampler(parcel_sizes(powder)).largest());
  return highest;
}

TimeStep choose_time_step(const Case& c, const std::vector<Species>& species,
                          const std::vector<PairProperties>& pairs, const Walls& walls,
                          const std::vector<double>& smallest_radius) {
  TimeStep result;
  result.characteristic_speed = characteristic_speed(c, walls);
  const std::vector<double>& radius = smallest_radius;
  std::vector<double> mass(species.size(), 0.0);
  for (std::size_t s = 0; s < species.size(); ++s) {
    if (!species[s].is_powder) continue;
    const Material& m = c.materials[species[s].material];
    mass[s] = m.density * sphere_volume(radius[s]);
    result.limits.push_back({"rayleigh", species[s].name,
                             laws::rayleigh_time(radius[s], m.density, species[s].modulus, m.poisson_ratio)});
  }
  for (const PairProperties& p : pairs) {
    const bool wall = !species[p.second].is_powder;
    const double r1 = radius[p.first], m1 = mass[p.first], r2 = radius[p.second], m2 = mass[p.second];
    const double r = wall ? r1 : r1 * r2 / (r1 + r2), m = wall ? m1 : m1 * m2 / (m1 + m2);
    for (const laws::TimeLimit& limit :
         laws::time_limits(pair_law(c.contact, p.simulated), p.simulated, law_choices(c.contact), m, r,
                           result.characteristic_speed))
      result.limits.push_back({limit.kind, pair_name(species, p), limit.time});
  }
  std::sort(result.limits.begin(), result.limits.end(),
            [](const StepLimit& a, const StepLimit& b) { return a.time < b.time; });
  if (result.limits.empty()) throw Failure(Exit::bad_case, c.file + ": error: the case has no powder");
  result.given = c.time.step.has_value();
  result.step = c.time.step.value_or(c.time.fraction * result.limits.front().time);
  return result;
}

std::string step_problem(const Case& c, const TimeStep& chosen) {
  const StepLimit& binding = chosen.limits.front();
  if (chosen.step <= binding.time) return "";
  return fmt::format(
      "time.step = {:.4g} s is too large: the {} limit of {} is {:.4g} s\n  remove time.step to have a safe "
      "step chosen ({:.4g} s), or set it below the limit",
      chosen.step, binding.kind, binding.of, binding.time, c.time.fraction * binding.time);
}

}  // namespace pulvis
