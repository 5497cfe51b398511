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
};

struct LawParts {
  std::string normal = "hertz", damping = "restitution", sliding = "total_spring", rolling = "elastic_plastic";
  laws::Choices choices;
};

inline ContactClass contact_class(const laws::MaterialPair& pair, const LawParts& parts) {
  ContactClass c;
  c.law = laws::find_law(parts.normal, parts.damping, parts.sliding, parts.rolling);
  c.constants = laws::catalogue()[c.law].mix(pair, parts.choices);
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
  return pair;
}

/// A model of one contact class for parcels and walls alike, in a box, with gravity along -z and no walls.
inline Model one_pair(const laws::MaterialPair& pair, const LawParts& parts, const Vec3& low, const Vec3& high,
                      double dt, double smallest_radius, double largest_radius) {
  Model m;
  m.domain.min = low;
  m.domain.max = high;
  m.gravity = {0, 0, -9.81};
  m.dt = dt;
  m.classes = ContactClasses(1);
  m.classes.set(0, 0, contact_class(pair, parts));
  m.parcels_per_thread = 1;  // small scenes, but threads must be tried
  m.smallest_radius = smallest_radius;
  m.largest_radius = largest_radius;
  return m;
}

/// The same for one species, mixed with itself.
inline Model one_material(const Stuff& stuff, const LawParts& parts, const Vec3& low, const Vec3& high, double dt,
                          double smallest_radius, double largest_radius) {
  return one_pair(material_pair(stuff, stuff), parts, low, high, dt, smallest_radius, largest_radius);
}

inline void add_wall(Model& m, Surface surface) {
  if (m.bodies.empty()) m.bodies.push_back({"wall", 0, {}});
  surface.body = 0;
  m.surfaces.push_back(surface);
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
    s.parcels.load.push_back({p.mass * m.gravity, {}});
    s.ledger.inserted++;
    s.ledger.inserted_mass += p.mass;
    s.next_id = p.id >= s.next_id ? p.id + 1 : s.next_id;
  }
  s.pairs.begin.assign(parcels.size() + 1, 0);
  s.walls.begin.assign(parcels.size() + 1, 0);
  return s;
}

/// The yardstick bed: spheres of 1.25 mm radius in a periodic 0.1 m x 0.1 m column, put on a loose lattice
/// with a little noise, ready to settle on a floor. 60,000 of them fill it to a height of about 75 mm.
inline Model yardstick_model(const LawParts& parts, double width, double height) {
  Stuff stuff;
  Model m = one_material(stuff, parts, {0, 0, -0.002}, {width, width, height}, 1e-5, 0.00125, 0.00125);
  m.domain.periodic[0] = m.domain.periodic[1] = true;
  add_wall(m, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  return m;
}

inline std::vector<Parcel> loose_lattice(std::size_t count, double width, double spacing, double radius,
                                         double density) {
  const auto along = static_cast<std::size_t>(width / spacing);
  std::vector<Parcel> list;
  for (std::size_t k = 0; k < count; ++k) {
    const auto noise = [&](std::uint32_t axis) {
      return (uniform(7, 0, k, axis) - 0.5) * 0.8 * (spacing - 2.0 * radius);
    };
    const Vec3 at{(static_cast<double>(k % along) + 0.5) * spacing + noise(0),
                  (static_cast<double>(k / along % along) + 0.5) * spacing + noise(1),
                  (static_cast<double>(k / along / along) + 0.5) * spacing + noise(2)};
    list.push_back(parcel(static_cast<std::uint32_t>(k), at, radius, density));
  }
  return list;
}

}  // namespace pulvis::scenes
