// SPDX-License-Identifier: Apache-2.0
#include "validation/symmetry.hpp"

#include <fmt/format.h>

#include <string>

#include "validation/chapters.hpp"
#include "validation/law_scene.hpp"
#include "validation/meshes.hpp"
#include "validation/references/law_list.hpp"
#include "validation/sums.hpp"
#include "validation/worst.hpp"

namespace pulvis::validation {
namespace {

const scenes::Stuff soft{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, 0.02};
const scenes::Stuff hard{7800.0, 2e7, 0.25, 0.7, 0.4, 0.05, 0.02};
constexpr double dt = 4e-6;  // about a hundredth of the contact time

/// The largest deviation over all laws, and the law that has it.
struct WorstLaw {
  double deviation = 0.0;
  std::string law = "none deviates";

  void add(const laws::Law& of, double error) {
    if (error <= deviation) return;
    raise(deviation, error);
    law = name_of(of);
  }
};

void add_row(Findings& f, const std::string& name, const std::string& source, const WorstLaw& worst,
             double limit) {
  f.compare(fmt::format("{}, worst of {} laws", name, laws_to_test().size()),
            fmt::format("{}; worst: {}", source, worst.law), 0.0, worst.deviation, Compare::bound, limit);
}

// --- action and reaction ---------------------------------------------------------------------------------

/// Two spheres of different size and material that meet askew and spinning.
Simulation two_spheres(const laws::Law& law, std::uint64_t number) {
  Model m = scenes::one_pair(with_every_property(soft, soft), scenes::parts_of(law), {-0.1, -0.1, -0.1},
                             {0.1, 0.1, 0.1}, dt, 1e-3, 1.7e-3);
  m.body_force.gravity = {};
  m.classes = ContactClasses(2);
  m.classes.set(0, 0, scenes::contact_class(with_every_property(soft, soft), scenes::parts_of(law)));
  m.classes.set(0, 1, scenes::contact_class(with_every_property(soft, hard), scenes::parts_of(law)));
  m.classes.set(1, 1, scenes::contact_class(with_every_property(hard, hard), scenes::parts_of(law)));
  Draw draw(number, 121);
  const Vec3 towards = draw.direction(), at = draw.vector(5e-3);
  const Vec3 aside = cross(towards, draw.direction());
  const double gap = 2e-5;
  std::vector<Parcel> spheres{
      scenes::parcel(0, at, 1e-3, soft.density, 0.2 * towards + 0.1 * aside, draw.vector(200)),
      scenes::parcel(1, at + (2.7e-3 + gap) * towards, 1.7e-3, hard.density, -0.1 * towards,
                     draw.vector(200))};
  spheres[1].species = 1;
  return Simulation(m, scenes::state_of(m, spheres), 1);
}

struct Balance {
  double forces = 0.0, torques = 0.0, momentum = 0.0, angular_momentum = 0.0;
};

/// Forces and torques against each other at every step, momenta against those of the start.
Balance balance_of(const laws::Law& law, std::uint64_t number) {
  Simulation s = two_spheres(law, number);
  const Vec3 start = scenes::momentum(s.state().parcels),
             turning = scenes::angular_momentum(s.state().parcels);
  double momentum_scale = 0.0, angular_scale = 0.0;
  for (const Parcel& p : s.state().parcels.body) {
    momentum_scale += p.mass * norm(p.velocity);
    angular_scale += p.mass * norm(p.position) * norm(p.velocity) + inertia(p) * norm(p.spin);
  }
  Balance b;
  int touching = 0;
  for (int k = 0; k < 400; ++k) {
    s.step();
    if (scenes::touching(s.pairs()) == 0) continue;
    ++touching;
    const Parcels& parcels = s.state().parcels;
    const Load &one = parcels.load[0], &two = parcels.load[1];
    const Vec3 arm = parcels.body[0].position - parcels.body[1].position;  // about the other's centre
    const double forces = norm(one.force) + norm(two.force);
    const double torques = norm(arm) * norm(one.force) + norm(one.torque) + norm(two.torque);
    if (forces > 0.0) raise(b.forces, norm(one.force + two.force) / forces);
    if (torques > 0.0) raise(b.torques, norm(one.torque + two.torque + cross(arm, one.force)) / torques);
  }
  raise(b.momentum, norm(scenes::momentum(s.state().parcels) - start) / momentum_scale);
  raise(b.angular_momentum, norm(scenes::angular_momentum(s.state().parcels) - turning) / angular_scale);
  if (touching < 50) raise(b.forces, NAN);  // they have not met
  return b;
}

void action_and_reaction(Findings& f, int scenes_per_law) {
  WorstLaw forces, torques, momentum, angular_momentum;
  for (const laws::Law& law : laws_to_test())
    for (int number = 0; number < scenes_per_law; ++number) {
      const Balance b = balance_of(law, static_cast<std::uint64_t>(number));
      forces.add(law, b.forces);
      torques.add(law, b.torques);
      momentum.add(law, b.momentum);
      angular_momentum.add(law, b.angular_momentum);
    }
  const std::string rounding = "2.2e-16 for each rounding of the terms that are summed";
  add_row(f, "forces of two spheres on each other: their sum", "equal and opposite", forces, 1e-15);
  add_row(f, "torques about a common point: their sum", rounding, torques, 1e-15);
  // Four hundred steps, each of which rounds.
  add_row(f, "momentum gained in a collision", rounding, momentum, 1e-14);
  add_row(f, "angular momentum gained in a collision", rounding, angular_momentum, 1e-13);
}

// --- rotation and translation ----------------------------------------------------------------------------

/// Three spheres that meet each other and a wall at once, all moved from where it was drawn.
Simulation placed(const laws::Law& law, const Rigid& place, bool triangles, std::uint64_t number) {
  Model m = scenes::one_pair(with_every_property(soft, soft), scenes::parts_of(law), {-0.2, -0.2, -0.2},
                             {0.2, 0.2, 0.2}, dt, 1e-3, 1.3e-3);
  m.body_force.gravity = place.turn({0, 0, -9.81});
  Draw draw(number, 122);
  const double half = 8e-3;
  if (triangles) {
    TriangleMesh mesh =
        scenes::random_triangles({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}, 6, 6, 0.2, draw);
    for (Vec3& p : mesh.points) p = place(p);
    scenes::add_mesh(m, mesh);
  } else {
    scenes::add_wall(m, rectangle_surface("wall", place({-half, -half, 0}), place.turn({2 * half, 0, 0}),
                                          place.turn({0, 2 * half, 0})));
  }
  const double gap = 1e-5;
  std::vector<Parcel> spheres;
  const auto add = [&](const Vec3& at, double radius, const Vec3& velocity) {
    spheres.push_back(scenes::parcel(static_cast<std::uint32_t>(spheres.size()), place(at), radius,
                                     soft.density, place.turn(velocity + draw.vector(0.05)),
                                     place.turn(draw.vector(200))));
  };
  add({-1e-3, 0, 1e-3 + gap}, 1e-3, {0.1, 0, -0.1});
  add({1.3e-3 + gap, 0, 1.3e-3 + gap}, 1.3e-3, {-0.1, 0, -0.1});
  add({0, 0.2e-3, 3.1e-3}, 1.2e-3, {0, 0, -0.3});
  return Simulation(m, scenes::state_of(m, spheres), 1);
}

const Load& load_of(const Simulation& s, std::uint32_t id) {
  const Parcels& parcels = s.state().parcels;
  return parcels.load[static_cast<std::size_t>(&scenes::parcel_with_id(s, id) - parcels.body.data())];
}

/// Runs a scene here and elsewhere; the largest difference of positions over the radius, of velocities and spins
/// over the largest there were, and of forces and torques over the run.
double moved_difference(const laws::Law& law, const Rigid& place, bool triangles, std::uint64_t number) {
  Simulation here = placed(law, {}, triangles, number), there = placed(law, place, triangles, number);
  Scaled way, speed, turning, push, twist;
  for (int k = 0; k < 300; ++k) {
    here.step();
    there.step();
    for (std::uint32_t id = 0; id < 3; ++id) {
      const Parcel &p = scenes::parcel_with_id(here, id), &q = scenes::parcel_with_id(there, id);
      const Load &a = load_of(here, id), &b = load_of(there, id);
      way.add(place(p.position), q.position);
      speed.add(place.turn(p.velocity), q.velocity);
      turning.add(place.turn(p.spin), q.spin);
      push.add(place.turn(a.force), b.force);
      twist.add(place.turn(a.torque), b.torque);
    }
  }
  double worst = way.difference / 1e-3;
  for (const Scaled& s : {speed, turning}) raise(worst, s.of_largest());
  for (const Scaled& s : {push, twist}) raise(worst, s.of_mean());
  return worst;
}

/// Three bodies that collide spread what roundings begin, most where a force is steep: JKR's curve is vertical at
/// rupture. How exact the laws themselves are says the row of one contact in a turned frame.
void rotation_and_translation(Findings& f, int places) {
  WorstLaw turned, shifted;
  for (const laws::Law& law : laws_to_test())
    for (int k = 0; k < places; ++k) {
      const auto number = static_cast<std::uint64_t>(k);
      Draw draw(number, 123);
      const Rigid rotation = Rigid::rotation(draw.between(0, 1), {}, draw.direction());
      const Vec3 way = 8e-3 * draw.direction();
      for (const bool triangles : {false, true}) {
        turned.add(law, moved_difference(law, rotation, triangles, number));
        shifted.add(law, moved_difference(law, Rigid::translation(way), triangles, number));
      }
    }
  add_row(f, "three spheres and a wall, all turned: path, spin, force, torque",
          "roundings of places (4e-19 m) over overlaps (1e-6 m), 300 steps, more where JKR breaks", turned,
          1e-10);
  add_row(f, "three spheres and a wall, all shifted by 8 mm: path, spin, force, torque",
          "roundings of places (2e-18 m) over overlaps (1e-6 m), 300 steps, more where JKR breaks", shifted,
          1e-10);
}

}  // namespace

void symmetry(Findings& f, Effort effort) {
  const int repeats = effort == Effort::quick ? 2 : 20;
  action_and_reaction(f, repeats);
  rotation_and_translation(f, repeats);
  symmetry_of_laws(f);
  finite_at_zero(f);
}

}  // namespace pulvis::validation
