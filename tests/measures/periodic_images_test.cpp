// SPDX-License-Identifier: Apache-2.0
#include "measures/periodic_images.hpp"

#include <gtest/gtest.h>

#include "measures/porosity.hpp"
#include "measures/sphere_box.hpp"

namespace pulvis::measures {
namespace {

const Box domain{{0, 0, 0}, {10, 10, 10}};

TEST(PeriodicImages, OfASphereInACornerAreSeven) {
  const std::vector<Sphere> one{{{0.5, 9.5, 0.5}, 1.0}};
  const auto all = periodic_images(one, domain, {true, true, true}).spheres;
  EXPECT_EQ(all.size(), 8u);
  EXPECT_EQ(all.front().centre, one.front().centre);
  EXPECT_NEAR(1000 * solid_fraction_in_box(all, domain), sphere_volume(1.0), 1e-13);
}

TEST(PeriodicImages, AreMadeOnlyAlongPeriodicAxesAndOnlyWhereSpheresStickOut) {
  const std::vector<Sphere> spheres{{{0.5, 9.5, 0.5}, 1.0}, {{5, 5, 5}, 1.0}, {{1, 5, 9}, 1.0}};
  EXPECT_EQ(periodic_images(spheres, domain, {false, false, false}).spheres.size(), 3u);
  const auto all = periodic_images(spheres, domain, {false, true, false}).spheres;
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all.back().centre, (Vec3{0.5, -0.5, 0.5}));
}

}  // namespace
}  // namespace pulvis::measures
