// SPDX-License-Identifier: Apache-2.0
#include "single_contact/curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "single_contact/adhesion.hpp"
#include "tests/single_contact/sample_contacts.hpp"

using namespace pulvis::testing;
using namespace pulvis::single_contact;

namespace {

TEST(Curve, RunsFromFirstTouchToTheLargestOverlapAndBackToSeparation) {
  for (const auto& [name, contact] : all_contacts()) {
    const double largest = *contact.overlap_under(5e-9);
    const Curve curve = load_unload_curve(contact, largest);
    ASSERT_EQ(curve.loading.size(), 400u) << name;
    ASSERT_EQ(curve.unloading.size(), 400u) << name;
    const double digits = 1e-9 * largest;
    EXPECT_NEAR(curve.loading.front().overlap, -contact.formation_gap(), digits) << name;
    EXPECT_NEAR(curve.loading.back().overlap, largest, digits) << name;
    EXPECT_NEAR(curve.unloading.front().overlap, largest, digits) << name;
    EXPECT_NEAR(curve.unloading.back().overlap, -contact.separation_gap(), digits) << name;
    EXPECT_NEAR(curve.loading.back().force, curve.unloading.front().force, 1e-12) << name;
    const auto by_overlap = [](const CurvePoint& a, const CurvePoint& b) { return a.overlap < b.overlap; };
    EXPECT_TRUE(std::is_sorted(curve.loading.begin(), curve.loading.end(), by_overlap)) << name;
    EXPECT_TRUE(std::is_sorted(curve.unloading.rbegin(), curve.unloading.rend(), by_overlap)) << name;
  }
}

TEST(Curve, HasThePullOffForceAsItsLowestPoint) {
  for (const auto& [name, contact] : all_contacts()) {
    const Adhesion a = adhesion(contact, 5e-9);
    const Curve curve = load_unload_curve(contact, a.pressed_overlap, 4000);
    double lowest = 0.0;
    for (const CurvePoint& p : curve.unloading) lowest = std::min(lowest, p.force);
    EXPECT_NEAR(-lowest, a.pull_off, 1e-3 * a.pull_off) << name;
    EXPECT_LE(-lowest, a.pull_off * (1 + 1e-12)) << name;
  }
}

}  // namespace
