// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "engine/kernels/contact_block.hpp"
#include "engine/math/rigid.hpp"
#include "validation/law_scene.hpp"
#include "validation/references/law.hpp"
#include "validation/references/law_list.hpp"
#include "validation/symmetry.hpp"
#include "validation/worst.hpp"

namespace pulvis::validation {
namespace {

constexpr std::uint64_t states = 1000;

void add_count(Findings& f, const std::string& what, std::size_t count, std::size_t of) {
  f.compare(fmt::format("{} ({} laws, {} numbers)", what, laws_to_test().size(), of), "there must be none",
            0.0, static_cast<double>(count), Compare::bound, 0.0);
}

template <class Turn>
laws::Past turned_history(laws::Past h, const Turn& turn) {
  h.slide = turn(h.slide);
  h.roll = turn(h.roll);
  return h;
}

/// Largest error of a turned state of this law against the turned result, over the sum of the terms.
double turned_error(const laws::Law& law) {
  double worst = 0.0;
  for (std::uint64_t k = 0; k < states; ++k) {
    const RandomState s = random_state(law, k);
    const ReferenceResponse truth = reference_response(law, s.touch, s.history, s.material, {});
    if (truth.on_the_edge || !truth.touching) continue;
    Draw draw(k, 7);
    const Rigid place = Rigid::rotation(draw.between(0, 1), {}, draw.direction());
    const auto turn = [&](const Vec3& v) { return place.turn(v); };
    const auto constants = law.mix(s.material, {});
    laws::Touch turned = s.touch;
    turned.normal = turn(s.touch.normal);
    turned.half_normal = turn(s.touch.half_normal);
    turned.velocity = turn(s.touch.velocity);
    turned.spin = turn(s.touch.spin);
    const laws::Response a = law.evaluate(s.touch, s.history, constants);
    const laws::Response b = law.evaluate(turned, turned_history(s.history, turn), constants);
    raise(worst, relative(norm(turn(a.force) - b.force), truth.force_terms));
    raise(worst, relative(norm(turn(a.roll_torque) - b.roll_torque), truth.torque_terms));
    raise(worst, relative(norm(turn(a.history.slide) - b.history.slide), truth.slide_terms));
  }
  return worst;
}

/// The same contact with its bodies named the other way round; a wall stays the second.
laws::Touch named_the_other_way(const laws::Touch& touch) {
  laws::Touch t = touch;
  t.normal = -touch.normal;
  t.half_normal = -touch.half_normal;
  t.velocity = -touch.velocity;
  t.spin = -touch.spin;
  t.shared_spin = -touch.shared_spin;
  if (touch.radius_second == 0.0) return t;
  std::swap(t.radius_first, t.radius_second);
  std::swap(t.mass_first, t.mass_second);
  return t;
}

/// How many results are not exactly the opposite then.
std::size_t not_opposite(const laws::Law& law) {
  std::size_t count = 0;
  for (std::uint64_t k = 0; k < states; ++k) {
    const RandomState s = random_state(law, k);
    const auto constants = law.mix(s.material, choices_to_test[k % std::size(choices_to_test)]);
    const laws::Response a = law.evaluate(s.touch, s.history, constants);
    const laws::Response b = law.evaluate(
        named_the_other_way(s.touch), turned_history(s.history, [](const Vec3& v) { return -v; }), constants);
    count += !(a.force == -b.force) + !(a.tangential == -b.tangential) + !(a.roll_torque == -b.roll_torque);
  }
  return count;
}

/// Counts numbers, and those that are not finite.
struct Count {
  std::size_t all = 0, bad = 0;

  void add(double x) { ++all, bad += !std::isfinite(x); }
  void add(const Vec3& v) { add(v.x), add(v.y), add(v.z); }
  void add(const laws::Response& r) {
    for (const Vec3& v : {r.force, r.tangential, r.roll_torque, r.history.slide, r.history.roll}) add(v);
    for (const double x : {r.history.plastic, r.history.adhesion, r.history.grip}) add(x);
    ++all, bad += !(r.touching == 0.0 || r.touching == 1.0);
    if (r.touching == 0.0) bad += !(r.force == Vec3{}) + !(r.history.roll == Vec3{});
  }
};

/// Calls use(material, overlap, was touching, speed) for each combination of what may be zero.
template <class Use>
void for_each_zero(Use&& use) {
  for (const double overlap : {0.0, 1e-300, 1e-18, 1e-9, -1e-9, -1e-3, 1e-4})
    for (const double was : {0.0, 1.0})
      for (const double speed : {0.0, 0.1})
        for (const double friction : {0.0, 0.5})
          for (const double restitution : {1.0, 0.5})
            for (const double work : {0.0, 1e-9, 0.1}) {
              scenes::Stuff stuff{2500.0, 5e6, 0.3, restitution, friction, friction, work};
              use(with_every_property(stuff, stuff), overlap, was, speed);
            }
}

laws::Touch degenerate_touch(double overlap, double was, double speed, bool wall) {
  const Vec3 n{0, 0, 1};
  laws::Touch t{overlap, wall ? 1e-3 : 0.5e-3, wall ? 1e-6 : 0.5e-6, was, n,
                n,       {speed, 0, speed},    {speed, 0, 0},        1e-6};
  t.shared_spin = speed;
  t.radius_first = 1e-3, t.mass_first = 1e-6;
  if (!wall) t.radius_second = 1e-3, t.mass_second = 1e-6;
  return t;
}

Count scalar_law(const laws::Law& law) {
  Count count;
  for_each_zero([&](const laws::MaterialPair& m, double overlap, double was, double speed) {
    for (const bool wall : {false, true})
      count.add(law.evaluate(degenerate_touch(overlap, was, speed, wall), {}, law.mix(m, {})));
  });
  for (std::uint64_t k = 0; k < states; ++k) {
    RandomState s = random_state(law, k);
    for (const double was : {0.0, 1.0})
      for (const double sign : {1.0, -1.0}) {
        laws::Touch t = s.touch;
        t.was_touching = was;
        t.overlap *= sign;
        count.add(law.evaluate(t, s.history, law.mix(s.material, {})));
      }
  }
  return count;
}

void put(kernels::Lanes3& lanes, int k, const Vec3& v) {
  lanes.x[k] = v.x, lanes.y[k] = v.y, lanes.z[k] = v.z;
}
Vec3 get(const kernels::Lanes3& lanes, int k) { return {lanes.x[k], lanes.y[k], lanes.z[k]}; }

/// One more contact of two spheres (or one and a wall) without slip and spin unless there is a `speed`.
void stage(kernels::ContactBlock& b, double overlap, double was, double speed) {
  const int k = b.count++;
  const Vec3 n{0, 0, 1};
  put(b.offset, k, (2e-3 - overlap) * n);
  put(b.velocity, k, {speed, 0, speed});
  put(b.spin_first, k, {speed, 0, 0});
  b.radius_first[k] = b.radius_second[k] = b.radius[k] = 1e-3;
  b.mass_first[k] = b.mass_second[k] = b.mass[k] = 1e-6;
  b.touching[k] = was;
  put(b.normal, k, n);
  put(b.half_normal, k, n);
  b.overlap[k] = overlap;
  b.arm_first[k] = b.half_arm_first[k] = 1e-3 - overlap;
}

Count kernel_of(const laws::Law& law, kernels::InstructionSet set, bool wall) {
  Count count;
  const auto kernel = kernels::contact_kernel(law, set);
  for_each_zero([&](const laws::MaterialPair& m, double overlap, double was, double speed) {
    auto block = std::make_unique<kernels::SeparateBlock>();
    for (int k = 0; k < 9; ++k) stage(*block, overlap, was, speed);  // vectors of each width and a rest
    const auto constants = law.mix(m, {});
    if (wall)
      kernel.walls(*block, constants.data(), 1e-6);
    else
      kernel.parcels(*block, constants.data(), 1e-6);
    for (int k = 0; k < block->count; ++k) {
      for (const auto* lanes : {&block->force, &block->torque_first, &block->torque_second,
                                &block->springs->slide, &block->springs->roll})
        count.add(get(*lanes, k));
      count.add(block->memory->plastic[k]), count.add(block->memory->adhesion[k]),
          count.add(block->memory->grip[k]);
    }
  });
  return count;
}

std::vector<kernels::InstructionSet> sets_up_to(kernels::InstructionSet best) {
  using enum kernels::InstructionSet;
  std::vector<kernels::InstructionSet> sets;
  for (const auto set : {baseline, avx2, avx512})
    if (set <= best) sets.push_back(set);
  return sets;
}

/// Two spheres and a wall that just touch, at rest and without gravity.
Count engine(const laws::Law& law) {
  const scenes::Stuff stuff{2500.0, 5e6, 0.3, 0.7, 0.4, 0.05, 0.02};
  Model m = scenes::one_pair(with_every_property(stuff, stuff), scenes::parts_of(law), {-1, -1, -1},
                             {1, 1, 1}, 1e-6, 0.0009765625, 0.0009765625);
  m.body_force.gravity = {};
  const double radius = 0.0009765625;  // 2^-10 m: the overlap is exactly zero
  scenes::add_wall(m, plane_surface("wall", {0, 0, 0}, {0, 0, 1}));
  Simulation s(m,
               scenes::state_of(m, {scenes::parcel(0, {0, 0, radius}, radius, 2500),
                                    scenes::parcel(1, {0, 0, 3 * radius}, radius, 2500)}),
               1);
  Count count;
  for (int k = 0; k < 20; ++k) {
    s.step();
    for (std::size_t i = 0; i < 2; ++i) {
      const Parcel& p = s.state().parcels.body[i];
      const Load& load = s.state().parcels.load[i];
      for (const Vec3& v : {p.position, p.velocity, p.spin, load.force, load.torque}) count.add(v);
    }
  }
  return count;
}

template <class Of>
void add_finite(Findings& f, const std::string& what, Of&& of) {
  Count sum;
  for (const laws::Law& law : laws_to_test()) {
    const Count one = of(law);
    sum.all += one.all;
    sum.bad += one.bad;
  }
  add_count(f, what, sum.bad, sum.all);
}

}  // namespace

void symmetry_of_laws(Findings& f) {
  double turned = 0.0;
  std::size_t other = 0;
  for (const laws::Law& law : laws_to_test()) {
    raise(turned, turned_error(law));
    other += not_opposite(law);
  }
  f.compare(fmt::format("one contact seen in a turned frame, worst of {} laws in 1,000 states",
                        laws_to_test().size()),
            "2.2e-16 for each rounding, over the sum of the terms", 0.0, turned, Compare::bound, 1e-13);
  add_count(f, "results that are not the exact opposite with the bodies named the other way", other,
            laws_to_test().size() * states * 3);
}

void finite_at_zero(Findings& f) {
  const std::string zero = "not finite at zero overlap, slip, spin, friction, adhesion: ";
  add_finite(f, zero + "the scalar law, also in 1,000 states touching or not", scalar_law);
  for (const auto set : sets_up_to(kernels::instruction_set())) {
    add_finite(f, zero + fmt::format("kernel between spheres, {}", kernels::name_of(set)),
               [&](const laws::Law& law) { return kernel_of(law, set, false); });
    add_finite(f, zero + fmt::format("kernel at walls, {}", kernels::name_of(set)),
               [&](const laws::Law& law) { return kernel_of(law, set, true); });
  }
  add_finite(f, "not finite with spheres at rest that just touch each other and a wall, 20 steps", engine);
}

}  // namespace pulvis::validation
