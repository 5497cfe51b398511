// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "validation/draw.hpp"
#include "validation/scene.hpp"
#include "validation/sums.hpp"

using namespace pulvis;
using namespace pulvis::scenes;

namespace {

struct Bed {
  Model model;
  std::vector<Parcel> parcels;
  double weight = 0.0;
};

/// 200 parcels of different size above a floor; walls in x, periodic in y.
Bed loose_bed(const char* normal) {
  Stuff stuff;
  stuff.young_modulus = 1e6;
  stuff.restitution = 0.3;
  stuff.work_of_adhesion = 0.02;
  LawParts parts;
  parts.normal = normal;
  Bed bed{
      one_material(stuff, parts, {-0.001, 0, -0.001}, {0.007, 0.006, 0.05}, 2e-5, 0.35e-3, 0.55e-3), {}, 0.0};
  bed.model.domain.periodic[1] = true;
  add_wall(bed.model, plane_surface("floor", {0, 0, 0}, {0, 0, 1}));
  add_wall(bed.model, plane_surface("left", {0, 0, 0}, {1, 0, 0}));
  add_wall(bed.model, plane_surface("right", {0.006, 0, 0}, {1, 0, 0}));
  for (std::uint32_t k = 0; k < 200; ++k) {
    pulvis::validation::Draw draw(k, 71);
    const Vec3 at{(0.6 + 1.2 * (k % 5)) * 1e-3, (0.6 + 1.2 * (k / 5 % 5)) * 1e-3,
                  (0.6 + 1.2 * (k / 25)) * 1e-3};
    bed.parcels.push_back(parcel(k, at, draw.between(0.35e-3, 0.55e-3), 2500.0, draw.vector(0.05)));
    bed.weight += bed.parcels.back().mass * 9.81;
  }
  return bed;
}

TEST(SettledBed, PressesOnItsWallsWithItsWeight) {
  for (const char* normal : {"hertz", "jkr"}) {
    const Bed bed = loose_bed(normal);
    Simulation s(bed.model, state_of(bed.model, bed.parcels), 1);
    for (int k = 0; k < 25000; ++k) s.step();
    Vec3 sum;
    for (std::size_t surface = 0; surface < 3; ++surface) sum += s.force_on_surface(surface);
    EXPECT_NEAR(sum.z / -bed.weight, 1.0, 1e-3) << normal;
    EXPECT_NEAR(sum.x / bed.weight, 0.0, 1e-3) << normal;
    EXPECT_NEAR(sum.y / bed.weight, 0.0, 1e-3) << normal;
    EXPECT_EQ(s.state().ledger.escaped, 0u);
    EXPECT_GT(touching(s.pairs()), 300u);
    RecordProperty(std::string(normal) + "_error_e9", std::to_string(1e9 * (sum.z / -bed.weight - 1.0)));
    RecordProperty(std::string(normal) + "_kinetic_energy_J",
                   std::to_string(kinetic_energy(s.state().parcels) * 1e15) + "e-15");
  }
}

}  // namespace
