// SPDX-License-Identifier: Apache-2.0
// The catalogue, and its kernels against the scalar law, whose numbers `pulvis validate --only laws` compares with
// the equations.
#include <gtest/gtest.h>

#include <bit>
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

using kernels::InstructionSet;
using kernels::Lanes3;
using kernels::SeparateBlock;

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
std::unique_ptr<SeparateBlock> random_block(const laws::Law& law, std::uint64_t number, int count,
                                            laws::MaterialPair& material, double& dt) {
  auto block = std::make_unique<SeparateBlock>();
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
    put(block->springs->slide, k, draw.vector(norm(base.history.slide)));
    put(block->springs->roll, k, draw.vector(norm(base.history.roll)));
    block->memory->plastic[k] = base.history.plastic * draw.between(0.0, 2.0);
    block->memory->adhesion[k] = base.history.adhesion * draw.between(0.0, 2.0);
    block->memory->grip[k] = base.history.grip * draw.between(0.0, 2.0);
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
      const int count = number % 3 == 0 ? kernels::block_size
                                        : 1 + static_cast<int>(number * 7 % (kernels::block_size - 1));
      laws::MaterialPair material;
      double dt = 0.0;
      const auto input = random_block(law, number, count, material, dt);
      const auto constants = law.mix(material, choices_to_test[number % 4]);
      for (const InstructionSet set : sets_of_this_processor()) {
        auto block = std::make_unique<SeparateBlock>(*input);
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
          const auto r =
              law.evaluate(touch,
                           {get(input->springs->slide, k), get(input->springs->roll, k),
                            input->memory->plastic[k], input->memory->adhesion[k], input->memory->grip[k]},
                           constants);
          ASSERT_EQ(block->touching[k], r.touching) << where;
          ASSERT_TRUE(same_bits(get(block->force, k), r.force)) << where;
          ASSERT_TRUE(same_bits(get(block->springs->slide, k), r.history.slide)) << where;
          ASSERT_TRUE(same_bits(get(block->springs->roll, k), r.history.roll)) << where;
          ASSERT_EQ(block->memory->plastic[k], r.history.plastic) << where;
          ASSERT_EQ(block->memory->adhesion[k], r.history.adhesion) << where;
          ASSERT_EQ(block->memory->grip[k], r.history.grip) << where;
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
      auto block = std::make_unique<SeparateBlock>(*input);
      block->count = 13;
      kernels::contact_kernel(law, set).parcels(*block, constants.data(), dt);
      for (int k = 13; k < kernels::block_size; ++k) {
        ASSERT_EQ(block->touching[k], input->touching[k]);
        ASSERT_TRUE(same_bits(get(block->springs->slide, k), get(input->springs->slide, k)));
        ASSERT_TRUE(same_bits(get(block->force, k), get(input->force, k)));
      }
    }
  }
}

}  // namespace
