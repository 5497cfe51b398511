// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/base/random.hpp"
#include "engine/laws/estimates.hpp"
#include "engine/simulation/simulation.hpp"

// Scenes for tests and benchmarks: a model put together by hand, without a case file.
namespace pulvis::scenes {

struct Stuff {
  double density = 2500.0, young_modulus = 5e6, poisson_ratio = 0.3;
  double restitution = 0.5, friction = 0.5, rolling_friction = 0.1, work_of_adhesion = 0.0;
  double cohesion_energy_density = 0.0;
};

struct LawParts {
  std::string normal = "hertz", damping = "restitution", sliding = "total_spring",
              rolling = "elastic_plastic";
  laws::Choices choices;
  std::string cohesion = "none", twisting = "none";
};

inline laws::Law law_of(const LawParts& parts) {
  return laws::find_law(parts.normal, parts.damping, parts.sliding, parts.rolling, parts.cohesion,
                        parts.twisting);
}

inline ContactClass contact_class(const laws::MaterialPair& pair, const LawParts& parts) {
  ContactClass c;
  c.law = law_of(parts);
  c.constants = c.law.mix(pair, parts.choices);
  c.kernel = kernels::contact_kernel(c.law, kernels::instruction_set());
  return c;
}

inline laws::MaterialPair material_pair(const Stuff& a, const Stuff& b) {
  laws::MaterialPair pair;
  pair.effective_modulus =
      laws::effective_modulus(a.young_modulus, a.poisson_ratio, b.young_modulus, b.poisson_ratio);
  pair.effective_shear_modulus =
      laws::effective_shear_modulus(a.young_modulus, a.poisson_ratio, b.young_modulus, b.poisson_ratio);
  pair.restitution = a.restitution;
  pair.friction = a.friction;
  pair.rolling_friction = a.rolling_friction;
  pair.work_of_adhesion = a.work_of_adhesion;
  pair.cohesion_energy_density = a.cohesion_energy_density;
  return pair;
}

/// A model of one contact class for parcels and walls alike, in a box, with gravity along -z and no walls.
inline Model one_pair(const laws::MaterialPair& pair, const LawParts& parts, const Vec3& low,
                      const Vec3& high, double dt, double smallest_radius, double largest_radius) {
  Model m;
  m.domain.min = low;
  m.domain.max = high;
  m.body_force.gravity = {0, 0, -9.81};
  m.dt = dt;
  m.classes = ContactClasses(1);
  m.classes.set(0, 0, contact_class(pair, parts));
  m.parcels_per_thread = 1;  // small scenes, but threads must be tried
  m.smallest_radius = smallest_radius;
  m.largest_radius = largest_radius;
  return m;
}

/// The same for one species, mixed with itself.
inline Model one_material(const Stuff& stuff, const LawParts& parts, const Vec3& low, const Vec3& high,
                          double dt, double smallest_radius, double largest_radius) {
  return one_pair(material_pair(stuff, stuff), parts, low, high, dt, smallest_radius, largest_radius);
}

inline void add_wall(Model& m, Surface surface) {
  if (m.walls.bodies.empty()) m.walls.bodies.push_back({"wall", {}});
  surface.body = 0;
  m.walls.surfaces.push_back(surface);
}

inline Parcel parcel(std::uint32_t id, const Vec3& position, double radius, double density,
                     const Vec3& velocity = {}, const Vec3& spin = {}) {
  Parcel p;
  p.id = id;
  p.position = position;
  p.radius = radius;
  p.mass = density * sphere_volume(radius);
  p.velocity = velocity;
  p.spin = spin;
  return p;
}

/// Initial state with these parcels at rest under gravity alone.
inline State state_of(const Model& m, const std::vector<Parcel>& parcels) {
  State s = Simulation::initial_state(m);
  s.parcels.body = parcels;
  for (const Parcel& p : parcels) {
    s.parcels.load.push_back({p.mass * m.body_force.gravity, {}});
    s.ledger.inserted++;
    s.ledger.inserted_mass += p.mass;
    s.next_id = p.id >= s.next_id ? p.id + 1 : s.next_id;
  }
  s.pairs.begin.assign(parcels.size() + 1, 0);
  s.walls.begin.assign(parcels.size() + 1, 0);
  return s;
}

/// The yardstick's material and floor: spheres of 1.25 mm radius in a column periodic in x and y.
inline Model yardstick_model(const Stuff& stuff, const LawParts& parts, double width, double height) {
  Model m = one_material(stuff, parts, {0, 0, -0.002}, {width, width, height}, 1e-5, 0.00125, 0.00125);
  m.parcels_per_thread = Model{}.parcels_per_thread;
  m.domain.periodic[0] = m.domain.periodic[1] = true;
  add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  return m;
}

/// A settled bed of the yardstick: `count` spheres put into a column at random and let fall for `steps`, after each
/// of which its number is told.
template <class Tell>
State settled_yardstick(const Stuff& stuff, const LawParts& parts, double width, std::size_t count, int steps,
                        int threads, Tell&& tell) {
  const double radius = 0.00125;
  const double height = static_cast<double>(count) * sphere_volume(radius) / (0.3 * width * width);
  Model m = yardstick_model(stuff, parts, width, 1.1 * height);
  SourceModel pack;
  pack.name = "pack";
  pack.density = stuff.density;
  SizeLaw single;
  single.diameter = single.smallest = single.largest = 2.0 * radius;
  pack.sizes = SizeSampler(single);
  pack.region.min = {-radius, -radius, 0.0};  // the periodic faces are no walls
  pack.region.max = {width + radius, width + radius, height};
  pack.velocity = {0, 0, -0.5};
  pack.target_count = count;
  m.sources.push_back(pack);
  Simulation simulation(m, Simulation::initial_state(m), threads);
  simulation.open_source(0);
  for (int k = 1; k <= steps; ++k) {
    simulation.step(k == steps ? Simulation::Then::look : Simulation::Then::go_on);
    tell(k);
  }
  State state = simulation.snapshot();
  state.sources.clear();
  return state;
}

/// A periodic bed side by side with itself, `tiles` times along x and y (contacts begin anew).
inline State tiled(const State& one, double width, std::uint32_t tiles) {
  State s = one;
  s.parcels = {};
  s.pairs = s.walls = {};
  const auto count = static_cast<std::uint32_t>(one.parcels.size());
  for (std::uint32_t ty = 0; ty < tiles; ++ty)
    for (std::uint32_t tx = 0; tx < tiles; ++tx)
      for (std::uint32_t k = 0; k < count; ++k) {
        Parcel p = one.parcels.body[k];
        p.position += Vec3{width * tx, width * ty, 0.0};
        p.id += (ty * tiles + tx) * count;
        s.parcels.body.push_back(p);
        s.parcels.load.push_back(one.parcels.load[k]);
      }
  s.pairs.begin.assign(s.parcels.size() + 1, 0);
  s.walls.begin.assign(s.parcels.size() + 1, 0);
  s.next_id = static_cast<std::uint32_t>(s.parcels.size());
  s.ledger.inserted = s.parcels.size();
  return s;
}

}  // namespace pulvis::scenes
