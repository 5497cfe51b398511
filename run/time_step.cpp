// SPDX-License-Identifier: Apache-2.0
#include "run/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/failure.hpp"
#include "engine/laws/estimates.hpp"
#include "engine/parcels/parcels.hpp"
#include "run/body_pull.hpp"
#include "run/build_walls.hpp"
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

/// Limits of the laws that are neither Hertz nor JKR, for one pair with reduced mass `m` and radius `r`.
std::vector<StepLimit> limits_of_law(const ContactChoice& c, const laws::MaterialPair& pair,
                                     const std::string& name, double m, double r, double speed) {
  std::vector<StepLimit> limits;
  if (c.normal == "hooke" || c.normal == "luding") {
    const double k = pair.normal_stiffness > 0.0
                         ? pair.normal_stiffness
                         : laws::linear_stiffness(m, r, pair.effective_modulus, pair.characteristic_speed);
    limits.push_back({"linear spring", name, pi * root(m / (k * greatest(pair.plastic_ratio, 1.0)))});
  }
  if (c.normal == "edinburgh")
    limits.push_back(
        {"unloading", name,
         laws::hertz_contact_time(m, r, pair.effective_modulus, speed) / root(pair.unloading_ratio)});
  if (pair.liquid_viscosity > 0.0 && pair.surface_tension > 0.0)
    limits.push_back({"liquid", name, m * pair.shortest_bridge_gap / (6.0 * pi * pair.liquid_viscosity * r)});
  if (c.cohesion == "hamaker" && pair.hamaker_constant > 0.0)
    limits.push_back(
        {"van der Waals", name,
         root(3.0 * m * pair.shortest_gap * square(pair.shortest_gap) / (pair.hamaker_constant * r))});
  return limits;
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
    const double e = p.simulated.effective_modulus, w = p.simulated.work_of_adhesion;
    const std::string name = pair_name(species, p);
    result.limits.push_back({"hertz", name, laws::hertz_contact_time(m, r, e, result.characteristic_speed)});
    for (const StepLimit& limit :
         limits_of_law(c.contact, p.simulated, name, m, r, result.characteristic_speed))
      result.limits.push_back(limit);
    if (c.contact.normal != "jkr" || w == 0.0) continue;
    result.limits.push_back({"cohesive stiffness", name, root(m / laws::jkr_stiffness_at_touch(r, e, w))});
    result.limits.push_back(
        {"cohesive speed", name, laws::jkr_stretch(r, e, w) / (10.0 * laws::jkr_sticking_speed(m, r, e, w))});
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
