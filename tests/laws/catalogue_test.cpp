// SPDX-License-Identifier: Apache-2.0
// What must hold for every law of the catalogue, whatever its parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "engine/kernels/contact_block.hpp"
#include "validation/references/law.hpp"
#include "validation/references/law_list.hpp"

using namespace pulvis;
using namespace pulvis::validation;

namespace {

constexpr std::uint64_t states = 1000;

using laws::CohesionLimit;
const laws::Choices all_choices[] = {
    {},
    {true, false, true, CohesionLimit::with, true, true, 1.0},
    {false, true, false, CohesionLimit::without, false, false, 2.0},
    {true, true, true, CohesionLimit::shifted, true, true, 2.0},
};

void expect_finite(const laws::Response& r, const std::string& where) {
  const Vec3 numbers{r.history.plastic, r.history.adhesion, r.history.grip};
  for (const Vec3& v : {r.force, r.tangential, r.roll_torque, r.history.slide, r.history.roll, numbers})
    EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) << where;
  EXPECT_TRUE(r.touching == 0.0 || r.touching == 1.0) << where;
}

template <class Entry>
void expect_in_order_and_named_once(const std::vector<Entry>& list) {
  std::set<std::string_view> names;
  for (std::size_t k = 0; k < list.size(); ++k) {
    names.insert(list[k].name);
    EXPECT_EQ(list[k].index, k) << list[k].name;
  }
  EXPECT_EQ(names.size(), list.size());
}

TEST(Catalogue, HasEveryPartOnceAndFindsItByItsName) {
  const laws::Catalogue& all = laws::catalogue();
  expect_in_order_and_named_once(all.normal);
  expect_in_order_and_named_once(all.cohesion);
  expect_in_order_and_named_once(all.twisting);
  expect_in_order_and_named_once(all.damping);
  expect_in_order_and_named_once(all.sliding);
  expect_in_order_and_named_once(all.rolling);
  for (const laws::Law& law : laws_to_test()) {
    const laws::Law found = laws::find_law({law.normal->name, law.damping->name, law.sliding->name,
                                            law.rolling->name, law.cohesion->name, law.twisting->name});
    EXPECT_EQ(name_of(found), name_of(law));
  }
  EXPECT_ANY_THROW(laws::find_law("hooke's", "none", "none", "none"));
}

TEST(EveryLaw, AgreesWithTheEquationsIn1000RandomStates) {
  double worst_plain = 0.0, worst_solved = 0.0;
  for (const auto& law : laws_to_test()) {
    const double limit = law.normal->name == "jkr" ? 1e-10 : 1e-12;
    double worst = 0.0;
    int compared = 0;
    for (std::uint64_t k = 0; k < states; ++k) {
      const laws::Choices choices = all_choices[k % 4];
      const RandomState s = random_state(law, k);
      const ReferenceResponse truth = reference_response(law, s.touch, s.history, s.material, choices);
      if (truth.on_the_edge) continue;
      const laws::Response ours = law.evaluate(s.touch, s.history, law.mix(s.material, choices));
      ASSERT_EQ(ours.touching > 0.5, truth.touching) << name_of(law) << k;
      if (!truth.touching) continue;
      worst = std::max(worst, relative(distance(ours.force, truth.force), truth.force_terms));
      worst = std::max(worst, relative(distance(ours.tangential, truth.tangential), truth.tangential_terms));
      worst = std::max(worst, relative(distance(ours.roll_torque, truth.roll_torque), truth.torque_terms));
      worst = std::max(worst, relative(distance(ours.history.slide, truth.slide), truth.slide_terms));
      worst = std::max(worst, relative(distance(ours.history.roll, truth.roll), truth.torque_terms));
      const auto apart = [](double a, Quad b) { return static_cast<double>(quad_magnitude(a - b)); };
      worst = std::max(worst, relative(apart(ours.history.plastic, truth.plastic), truth.plastic_terms));
      worst = std::max(worst, relative(apart(ours.history.adhesion, truth.adhesion), truth.adhesion));
      worst = std::max(worst, relative(apart(ours.history.grip, truth.grip), truth.grip));
      ++compared;
    }
    EXPECT_LT(worst, limit) << name_of(law);
    double& record = law.normal->name == "jkr" ? worst_solved : worst_plain;
    record = std::max(record, worst);
    EXPECT_GT(compared, law.cohesion->reaches ? 500 : 800) << name_of(law);
  }
  RecordProperty("worst_e15", std::to_string(worst_plain * 1e15));
  RecordProperty("worst_with_a_root_solved_e15", std::to_string(worst_solved * 1e15));
}

/// A rotation by a unit quaternion, as a matrix.
struct Rotation {
  Vec3 row[3];
  explicit Rotation(Draw& draw) {
    const double u = draw.between(0, 1), a = draw.between(0, 6.283185307179586),
                 b = draw.between(0, 6.283185307179586);
    const double w = std::sqrt(1 - u) * std::sin(a), x = std::sqrt(1 - u) * std::cos(a),
                 y = std::sqrt(u) * std::sin(b), z = std::sqrt(u) * std::cos(b);
    row[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)};
    row[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)};
    row[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)};
  }
  Vec3 operator()(const Vec3& v) const { return {dot(row[0], v), dot(row[1], v), dot(row[2], v)}; }
};

template <class Turn>
laws::Past turned_history(laws::Past h, const Turn& turn) {
  h.slide = turn(h.slide);
  h.roll = turn(h.roll);
  return h;
}

TEST(EveryLaw, DoesNotCareHowTheFrameIsTurned) {
  for (const auto& law : laws_to_test()) {
    double worst = 0.0;
    for (std::uint64_t k = 0; k < states; ++k) {
      const RandomState s = random_state(law, k);
      const ReferenceResponse truth = reference_response(law, s.touch, s.history, s.material, {});
      if (truth.on_the_edge || !truth.touching) continue;
      Draw draw(k, 7);
      const Rotation turn(draw);
      const auto constants = law.mix(s.material, {});
      laws::Touch turned = s.touch;
      turned.normal = turn(s.touch.normal);
      turned.half_normal = turn(s.touch.half_normal);
      turned.velocity = turn(s.touch.velocity);
      turned.spin = turn(s.touch.spin);
      const laws::Response a = law.evaluate(s.touch, s.history, constants);
      const laws::Response b = law.evaluate(turned, turned_history(s.history, turn), constants);
      worst = std::max(worst, relative(norm(turn(a.force) - b.force), truth.force_terms));
      worst = std::max(worst, relative(norm(turn(a.roll_torque) - b.roll_torque), truth.torque_terms));
      worst = std::max(worst, relative(norm(turn(a.history.slide) - b.history.slide), truth.slide_terms));
    }
    EXPECT_LT(worst, 1e-13) << name_of(law);
  }
}

laws::Touch with_sizes_of(laws::Touch touch, const laws::Touch& other) {
  touch.radius_first = other.radius_first;
  touch.radius_second = other.radius_second;
  touch.mass_first = other.mass_first;
  touch.mass_second = other.mass_second;
  return touch;
}

TEST(EveryLaw, GivesTheSecondExactlyTheOppositeOfTheFirst) {
  // The same contact named the other way round.
  for (const auto& law : laws_to_test())
    for (std::uint64_t k = 0; k < states; ++k) {
      const RandomState s = random_state(law, k);
      const auto constants = law.mix(s.material, all_choices[k % 4]);
      laws::Touch swapped = s.touch;
      swapped.normal = -s.touch.normal;
      swapped.half_normal = -s.touch.half_normal;
      swapped.velocity = -s.touch.velocity;
      swapped.spin = -s.touch.spin;
      swapped.shared_spin = -s.touch.shared_spin;
      std::swap(swapped.radius_first, swapped.radius_second);
      std::swap(swapped.mass_first, swapped.mass_second);
      if (s.touch.radius_second == 0.0) swapped = with_sizes_of(swapped, s.touch);  // the wall stays second
      const laws::Response a = law.evaluate(s.touch, s.history, constants);
      const laws::Response b =
          law.evaluate(swapped, turned_history(s.history, [](const Vec3& v) { return -v; }), constants);
      ASSERT_EQ(a.force, -b.force) << name_of(law) << k;
      ASSERT_EQ(a.tangential, -b.tangential) << name_of(law) << k;
      ASSERT_EQ(a.roll_torque, -b.roll_torque) << name_of(law) << k;
    }
}

TEST(EveryLaw, IsFiniteAtZeroOverlapZeroSlipZeroSpinAndWithoutFrictionDampingOrAdhesion) {
  for (const auto& law : laws_to_test())
    for (const double overlap : {0.0, 1e-300, 1e-18, 1e-9, -1e-9, -1e-3, 1e-4})
      for (const double was : {0.0, 1.0})
        for (const double friction : {0.0, 0.5})
          for (const double restitution : {1.0, 0.5})
            for (const double work : {0.0, 1e-9, 0.1})
              for (const double speed : {0.0, 0.1}) {
                laws::MaterialPair m = random_state(law, 1).material;
                m.effective_modulus = 5e6, m.effective_shear_modulus = 1.5e6, m.work_of_adhesion = work;
                m.restitution = restitution, m.friction = m.rolling_friction = friction;
                const Vec3 n{0, 0, 1};
                laws::Touch t{overlap, 1e-3, 1e-6, was, n, n, {speed, 0, speed}, {speed, 0, 0}, 1e-6};
                t.shared_spin = speed;
                t.radius_first = 1e-3, t.mass_first = 1e-6;
                const auto r = law.evaluate(t, {}, law.mix(m, {}));
                expect_finite(r,
                              name_of(law) + " at " + std::to_string(overlap) + " W " + std::to_string(work));
                if (r.touching == 0.0) {
                  EXPECT_EQ(r.force, Vec3{});
                  EXPECT_EQ(r.history.roll, Vec3{});
                }
              }
}

TEST(EveryLaw, IsFiniteInEveryRandomStateTouchingOrNot) {
  for (const auto& law : laws_to_test())
    for (std::uint64_t k = 0; k < states; ++k) {
      RandomState s = random_state(law, k);
      for (const double was : {0.0, 1.0})
        for (const double sign : {1.0, -1.0}) {
          s.touch.was_touching = was;
          laws::Touch t = s.touch;
          t.overlap *= sign;
          expect_finite(law.evaluate(t, s.history, law.mix(s.material, {})), name_of(law));
        }
    }
}

// --- compiled kernels ------------------------------------------------------------------------------------

using kernels::ContactBlock;
using kernels::InstructionSet;
using kernels::Lanes3;

std::vector<InstructionSet> sets_of_this_processor() {
  std::vector<InstructionSet> sets{InstructionSet::baseline};
  if (__builtin_cpu_supports("avx2")) sets.push_back(InstructionSet::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    sets.push_back(InstructionSet::avx512);
  return sets;
}

void put(Lanes3& lanes, int k, const Vec3& v) { lanes.x[k] = v.x, lanes.y[k] = v.y, lanes.z[k] = v.z; }
Vec3 get(const Lanes3& lanes, int k) { return {lanes.x[k], lanes.y[k], lanes.z[k]}; }

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

/// The torque about a centre: of the tangential force, of rolling, and of the drag, which the kernels add last.
bool same_torque(const Vec3& torque, double arm, const Vec3& normal, const laws::Response& r, double sign,
                 bool viscous) {
  const Vec3 slid = arm * cross(normal, r.tangential) + sign * r.roll_torque;
  return same_bits(torque, viscous ? slid + arm * cross(normal, r.drag) : slid);
}

/// Fills a block with random contacts of one material; every fifth does not touch.
std::unique_ptr<ContactBlock> random_block(const laws::Law& law, std::uint64_t number, int count,
                                           laws::MaterialPair& material, double& dt) {
  auto block = std::make_unique<ContactBlock>();
  block->count = count;
  const RandomState base = random_state(law, number);
  material = base.material;
  dt = base.touch.dt;
  const double stretch = law.separation_gap(base.touch.radius, law.mix(material, {}));
  for (int k = 0; k < count; ++k) {
    Draw draw(number * 1000 + static_cast<std::uint64_t>(k), 11);
    const double r1 = base.touch.radius * draw.between(1.0, 4.0),
                 r2 = base.touch.radius * draw.between(1.0, 4.0);
    const double overlap = k % 5 == 4 ? -draw.between(0.0, 2.0) * (stretch + 1e-3 * r1)
                                      : draw.between(-0.3, 3.0) * stretch + r1 * draw.decades(1e-8, 1e-2);
    const Vec3 n = draw.direction();
    put(block->offset, k, (r1 + r2 - overlap) * n);
    put(block->velocity, k, draw.vector(5.0 * norm(base.touch.velocity)));
    put(block->spin_first, k, draw.vector(norm(base.touch.spin)));
    put(block->spin_second, k, draw.vector(norm(base.touch.spin)));
    block->radius_first[k] = r1;
    block->radius_second[k] = r2;
    block->mass_first[k] = base.touch.mass * draw.between(0.5, 2.0);
    block->mass_second[k] = base.touch.mass * draw.between(0.5, 2.0);
    block->touching[k] = draw.chance(0.7) ? 1.0 : 0.0;
    put(block->slide, k, draw.vector(norm(base.history.slide)));
    put(block->roll, k, draw.vector(norm(base.history.roll)));
    block->plastic[k] = base.history.plastic * draw.between(0.0, 2.0);
    block->adhesion[k] = base.history.adhesion * draw.between(0.0, 2.0);
    block->grip[k] = base.history.grip * draw.between(0.0, 2.0);
    // For the walls' entry point; the parcels' one derives these itself.
    Vec3 half = n + draw.vector(0.01);
    put(block->normal, k, n);
    put(block->half_normal, k, half / norm(half));
    block->overlap[k] = overlap;
    block->radius[k] = r1;
    block->mass[k] = block->mass_first[k];
    block->arm_first[k] = r1 - overlap;
    block->arm_second[k] = 0.0;
    block->half_arm_first[k] = r1 - 0.9 * overlap;
    block->half_arm_second[k] = 0.0;
  }
  return block;
}

void expect_kernel_equals_scalar_law(bool walls) {
  for (const laws::Law& law : laws_to_test()) {
    for (std::uint64_t number = 0; number < 12; ++number) {
      // Full blocks, and counts that leave a remainder in every vector width.
      const int count = number % 3 == 0 ? kernels::block_size : 1 + static_cast<int>(number * 7 % 63);
      laws::MaterialPair material;
      double dt = 0.0;
      const auto input = random_block(law, number, count, material, dt);
      const auto constants = law.mix(material, all_choices[number % 4]);
      for (const InstructionSet set : sets_of_this_processor()) {
        auto block = std::make_unique<ContactBlock>(*input);
        const auto kernel = kernels::contact_kernel(law, set);
        if (walls)
          kernel.walls(*block, constants.data(), dt);
        else
          kernel.parcels(*block, constants.data(), dt);
        for (int k = 0; k < count; ++k) {
          const std::string where = name_of(law) + kernels::name_of(set) + " lane " + std::to_string(k);
          const Vec3 normal = get(block->normal, k), half = get(block->half_normal, k);
          const Vec3 spin_first = get(input->spin_first, k), spin_second = get(input->spin_second, k);
          const double arm_first = block->arm_first[k], arm_second = block->arm_second[k];
          const Vec3 velocity =
              get(input->velocity, k) +
              cross(block->half_arm_first[k] * spin_first + block->half_arm_second[k] * spin_second, half);
          const laws::Touch touch{block->overlap[k],
                                  block->radius[k],
                                  block->mass[k],
                                  input->touching[k],
                                  normal,
                                  half,
                                  velocity,
                                  spin_first - spin_second,
                                  dt,
                                  0.5 * dot(spin_first + spin_second, half),
                                  walls ? input->radius[k] : input->radius_first[k],
                                  walls ? 0.0 : input->radius_second[k],
                                  walls ? input->mass[k] : input->mass_first[k],
                                  walls ? 0.0 : input->mass_second[k]};
          const auto r = law.evaluate(touch,
                                      {get(input->slide, k), get(input->roll, k), input->plastic[k],
                                       input->adhesion[k], input->grip[k]},
                                      constants);
          ASSERT_EQ(block->touching[k], r.touching) << where;
          ASSERT_TRUE(same_bits(get(block->force, k), r.force)) << where;
          ASSERT_TRUE(same_bits(get(block->slide, k), r.history.slide)) << where;
          ASSERT_TRUE(same_bits(get(block->roll, k), r.history.roll)) << where;
          ASSERT_EQ(block->plastic[k], r.history.plastic) << where;
          ASSERT_EQ(block->adhesion[k], r.history.adhesion) << where;
          ASSERT_EQ(block->grip[k], r.history.grip) << where;
          ASSERT_TRUE(
              same_torque(get(block->torque_first, k), arm_first, normal, r, 1.0, law.cohesion->is_viscous))
              << where;
          ASSERT_TRUE(same_torque(get(block->torque_second, k), arm_second, normal, r, -1.0,
                                  law.cohesion->is_viscous))
              << where;
          if (walls) continue;
          // The geometry the kernel derived, against 113 bits.
          const Quad r1 = input->radius_first[k], r2 = input->radius_second[k];
          const Quad m1 = input->mass_first[k], m2 = input->mass_second[k];
          const QuadVec offset = quad(get(input->offset, k));
          const QuadVec before = offset + (static_cast<Quad>(dt) / 2) * quad(get(input->velocity, k));
          ASSERT_LT(distance(normal, (1 / norm(offset)) * offset), 1e-15) << where;
          ASSERT_LT(distance(half, (1 / norm(before)) * before), 1e-15) << where;
          const Quad overlap = r1 + r2 - norm(offset);
          ASSERT_LT(quad_magnitude(block->overlap[k] - overlap), 4e-16 * (r1 + r2)) << where;
          ASSERT_LT(quad_magnitude(block->radius[k] * (r1 + r2) / (r1 * r2) - 1), 1e-15) << where;
          ASSERT_LT(quad_magnitude(block->mass[k] * (m1 + m2) / (m1 * m2) - 1), 1e-15) << where;
          ASSERT_LT(quad_magnitude(arm_first - (r1 - overlap / 2)), 4e-16 * (r1 + r2)) << where;
          ASSERT_LT(quad_magnitude(arm_second - (r2 - overlap / 2)), 4e-16 * (r1 + r2)) << where;
          const Quad half_overlap = r1 + r2 - norm(before);
          ASSERT_LT(quad_magnitude(block->half_arm_first[k] - (r1 - half_overlap / 2)), 4e-16 * (r1 + r2))
              << where;
          ASSERT_LT(quad_magnitude(block->half_arm_second[k] - (r2 - half_overlap / 2)), 4e-16 * (r1 + r2))
              << where;
        }
      }
    }
  }
}

TEST(EveryKernel, GivesTheBitsOfTheScalarLawBetweenParcels) { expect_kernel_equals_scalar_law(false); }
TEST(EveryKernel, GivesTheBitsOfTheScalarLawAtWalls) { expect_kernel_equals_scalar_law(true); }

TEST(EveryKernel, LeavesLanesBeyondTheCountAlone) {
  for (const laws::Law& law : laws_to_test()) {
    laws::MaterialPair material;
    double dt = 0.0;
    const auto input = random_block(law, 5, kernels::block_size, material, dt);
    const auto constants = law.mix(material, {});
    for (const InstructionSet set : sets_of_this_processor()) {
      auto block = std::make_unique<ContactBlock>(*input);
      block->count = 13;
      kernels::contact_kernel(law, set).parcels(*block, constants.data(), dt);
      for (int k = 13; k < kernels::block_size; ++k) {
        ASSERT_EQ(block->touching[k], input->touching[k]);
        ASSERT_TRUE(same_bits(get(block->slide, k), get(input->slide, k)));
        ASSERT_TRUE(same_bits(get(block->force, k), get(input->force, k)));
      }
    }
  }
}

}  // namespace
