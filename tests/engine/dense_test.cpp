// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/insertion/source.hpp"
#include "validation/draw.hpp"

using namespace pulvis;

namespace {

/// A source of `count` parcels of 1 mm (or 0.8 to 1.2 mm) for a box in which they fill `fraction`.
std::pair<SourceModel, Box> dense(double fraction, std::uint64_t count, bool of_one_size = true) {
  SourceModel m;
  m.kind = SourceModel::Kind::dense;
  m.density = 2500.0;
  SizeLaw law;
  law.kind = of_one_size ? SizeKind::single : SizeKind::uniform;
  law.diameter = 1e-3;
  law.smallest = of_one_size ? 1e-3 : 0.8e-3;
  law.largest = of_one_size ? 1e-3 : 1.2e-3;
  m.sizes = SizeSampler(law);
  m.target_count = count;
  const double volume = static_cast<double>(count) * sphere_volume(0.5) * m.sizes->mean_cube() / fraction;
  Box box;
  const double width = std::cbrt(volume);
  box.min = {-1e-3, 0, 2e-3};
  box.max = box.min + Vec3{width, 2.0 * width, 0.5 * width};
  for (bool& periodic : box.periodic) periodic = true;
  return {m, box};
}

std::vector<Parcel> drawn(const SourceModel& m, const Box& box, std::uint64_t seed = 5) {
  SourceState state;
  auto parcels = draw_parcels(m, state, seed, 0, 0, 1e-5, {}, box);
  EXPECT_TRUE(state.done);
  EXPECT_EQ(state.count, parcels.size());
  return parcels;
}

/// Largest overlap over the sum of both radii.
double deepest(const std::vector<Parcel>& parcels, const Box& box) {
  double worst = 0.0;
  for (std::size_t i = 0; i < parcels.size(); ++i)
    for (std::size_t j = i + 1; j < parcels.size(); ++j) {
      const double touch = parcels[i].radius + parcels[j].radius;
      const double distance = norm(NearestImage::of(box)(parcels[j].position - parcels[i].position));
      worst = std::max(worst, (touch - distance) / touch);
    }
  return worst;
}

TEST(DenseSource, FillsABoxToItsFractionWithHardlyAnyOverlap) {
  for (const double fraction : {0.2, 0.5, 0.6}) {
    const auto [m, box] = dense(fraction, 800);
    const auto parcels = drawn(m, box);
    ASSERT_EQ(parcels.size(), 800u);
    EXPECT_LE(deepest(parcels, box), 0.0101) << fraction;
    for (const Parcel& p : parcels)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p.position[axis], box.min[axis]);
        EXPECT_LE(p.position[axis], box.max[axis]);
      }
  }
}

TEST(DenseSource, PressesParcelsTogetherAboveRandomClosePacking) {
  const auto [m, box] = dense(0.68, 800);
  const double overlap = deepest(drawn(m, box), box);
  EXPECT_GT(overlap, 0.0101);
  EXPECT_LT(overlap, 0.1);
}

TEST(DenseSource, KnowsSizes) {
  const auto [m, box] = dense(0.55, 800, false);
  const auto parcels = drawn(m, box);
  EXPECT_LE(deepest(parcels, box), 0.0101);
  const auto smaller = [](const Parcel& a, const Parcel& b) { return a.radius < b.radius; };
  const auto [least, most] = std::minmax_element(parcels.begin(), parcels.end(), smaller);
  EXPECT_LT(least->radius, 0.41e-3);
  EXPECT_GT(most->radius, 0.59e-3);
}

TEST(DenseSource, LeavesNoOrderBehind) {
  // In a lattice neighbours lie along few directions; here as many along each octant's diagonal as along its axes.
  const auto [m, box] = dense(0.6, 800);
  const auto parcels = drawn(m, box);
  std::size_t near = 0, along_axes = 0;
  for (std::size_t i = 0; i < parcels.size(); ++i)
    for (std::size_t j = i + 1; j < parcels.size(); ++j) {
      const Vec3 d = NearestImage::of(box)(parcels[j].position - parcels[i].position);
      if (norm(d) > 1.1e-3) continue;
      ++near;
      const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
      along_axes +=
          largest > std::cos(0.35) * norm(d);  // six caps of 0.35 rad: 3 (1 - cos 0.35) of all directions
    }
  EXPECT_GT(near, 2000u);
  EXPECT_NEAR(static_cast<double>(along_axes) / static_cast<double>(near), 6.0 * 0.5 * (1.0 - std::cos(0.35)),
              0.03);
}

TEST(DenseSource, IsTheSameForTheSameSeedOnly) {
  const auto [m, box] = dense(0.6, 200);
  const auto one = drawn(m, box), same = drawn(m, box), other = drawn(m, box, 6);
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_TRUE(one[k].position == same[k].position);
  EXPECT_FALSE(one[7].position == other[7].position);
}

}  // namespace
