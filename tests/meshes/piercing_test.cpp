// SPDX-License-Identifier: Apache-2.0
#include "meshes/piercing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "meshes/mending.hpp"
#include "shapes.hpp"
#include "validation/draw.hpp"

namespace pulvis {
namespace {

using namespace test;

constexpr double tolerance = 1e-6;

TriangleMesh box(const Vec3& min, const Vec3& max) { return mend(box_soup(min, max), 1.0).mesh; }

bool pierce(const TriangleMesh& a, const TriangleMesh& b) {
  const bool one = first_piercing(a, b, tolerance).has_value();
  EXPECT_EQ(first_piercing(b, a, tolerance).has_value(), one);
  return one;
}

TEST(Piercing, BoxesThatCrossDo) {
  const auto a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 0.5, 0.7}, {3, 1.5, 1.4});
  const auto piercing = first_piercing(a, b, tolerance);
  ASSERT_TRUE(piercing.has_value());
  EXPECT_NEAR(piercing->place.x, 2.0, 1e-12);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(a.corner(piercing->triangle_a, k).x, 2.0);
  EXPECT_TRUE(pierce(a, b));
}

TEST(Piercing, BodiesApartTouchingOrInsideEachOtherDoNot) {
  const auto a = box({0, 0, 0}, {2, 2, 2});
  EXPECT_FALSE(pierce(a, box({3, 0, 0}, {4, 1, 1})));
  EXPECT_FALSE(pierce(a, box({2, 0, 0}, {4, 2, 2})));               // the same face
  EXPECT_FALSE(pierce(a, box({2, 0.5, 0.5}, {4, 3, 1})));           // a part of the face
  EXPECT_FALSE(pierce(a, box({2 - 0.9e-6, 0.5, 0.5}, {4, 3, 1})));  // less than the tolerance
  EXPECT_TRUE(pierce(a, box({2 - 3e-6, 0.5, 0.5}, {4, 3, 1})));
  EXPECT_FALSE(pierce(a, box({2, 2, 0}, {4, 4, 2})));  // along an edge
  EXPECT_FALSE(pierce(a, box({2, 2, 2}, {4, 4, 4})));  // at a corner
  EXPECT_FALSE(pierce(a, box({0.5, 0.5, 0.5}, {1, 1, 1})));
  EXPECT_FALSE(pierce(a, a));
  EXPECT_FALSE(pierce(a, {}));
}

TEST(Piercing, ABodyThatSlidesFlushOnAnotherNeverDoes) {
  const auto plate = box({-3, -3, -1}, {3, 3, 0}), wall = box({1, -3, 0}, {2, 3, 2});
  for (int k = 0; k <= 400; ++k) {
    const double x = -3.5 + 0.01 * k;
    const auto shoe = box({x, -1, 0}, {x + 1, 1, 1});
    EXPECT_FALSE(pierce(plate, shoe));
    EXPECT_EQ(pierce(wall, shoe), x > 1e-5) << x;  // flush with the side of the wall at first
  }
}

TEST(Piercing, ARidgeThatRestsOnARidgeDoesNot) {
  const auto roof = sheet(2, 2.0, [](double x, double) { return -std::fabs(x - 1); });
  const auto valley = sheet(2, 2.0, [](double, double y) { return std::fabs(y - 1); });
  EXPECT_FALSE(pierce(roof, moved(valley, {0, 0, 1e-7})));
  EXPECT_FALSE(pierce(roof, moved(valley, {0, 0, 0})));
  EXPECT_FALSE(pierce(roof, moved(valley, {0.3, -0.2, 0})));
  EXPECT_TRUE(pierce(roof, moved(valley, {0.3, -0.2, -0.01})));
}

TEST(Piercing, EdgesThatCrossOnlyEdgesDo) {
  // Bars of the same cross-section through each other: their sides are flush, their edges meet.
  const auto along_x = box({-3, -1, -1}, {3, 1, 1}), along_y = box({-1, -3, -1}, {1, 3, 1});
  EXPECT_TRUE(pierce(along_x, along_y));
  // A blade whose edge comes down exactly on the diagonal of a square.
  const auto square = sheet(1, 2.0, [](double, double) { return 0.0; });
  TriangleMesh blade;
  blade.points = {{1, 1, 1}, {1, 1, -1}, {5, -3, 0}};
  blade.triangles = {{0, 1, 2}};
  EXPECT_TRUE(pierce(square, blade));
}

// Whether the segment goes through the triangle, by volumes of tetrahedra: another formula than that tested.
bool segment_through(const std::array<Vec3, 3>& t, const Vec3& p, const Vec3& q, bool& doubtful) {
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(a - d, cross(b - d, c - d));
  };
  const double below = volume(t[0], t[1], t[2], p), above = volume(t[0], t[1], t[2], q);
  const double u = volume(p, q, t[0], t[1]), v = volume(p, q, t[1], t[2]), w = volume(p, q, t[2], t[0]);
  for (const double x : {below, above, u, v, w}) doubtful |= std::fabs(x) < 1e-6;
  return below * above < 0 && ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0));
}

bool pierce_by_brute_force(const TriangleMesh& a, const TriangleMesh& b, bool& doubtful) {
  bool found = false;
  for (std::size_t s = 0; s < a.triangles.size(); ++s)
    for (std::size_t t = 0; t < b.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        found |= segment_through({b.corner(t, 0), b.corner(t, 1), b.corner(t, 2)}, a.corner(s, k),
                                 a.corner(s, (k + 1) % 3), doubtful);
  return found;
}

TriangleMesh random_triangles(validation::Draw& draw, int count, double size) {
  TriangleMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vec3 centre = 3.0 * Vec3{draw.between(0, 1), draw.between(0, 1), draw.between(0, 1)};
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int k = 0; k < 3; ++k) mesh.points.push_back(centre + draw.vector(size));
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Piercing, AgreesWithBruteForceOnRandomTriangles) {
  int found = 0, compared = 0;
  for (std::uint64_t trial = 0; trial < 2000; ++trial) {
    validation::Draw draw(trial);
    const int count = 1 + static_cast<int>(draw.between(0, 30));
    const double size = draw.between(0.2, 0.8);
    const auto a = random_triangles(draw, count, size), b = random_triangles(draw, count, size);
    bool doubtful = false;
    const bool one = pierce_by_brute_force(a, b, doubtful), other = pierce_by_brute_force(b, a, doubtful);
    if (doubtful && !(one || other)) continue;
    ++compared;
    found += one || other;
    EXPECT_EQ(first_piercing(a, b, 1e-9).has_value(), one || other) << "trial " << trial;
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(found, 200);
  EXPECT_GT(compared - found, 200);
}

TEST(Piercing, IsFastForTenThousandTrianglesApartOrTouching) {
  const auto wave = [](double x, double y) { return 0.05 * std::sin(7 * x) * std::cos(5 * y); };
  const auto a = sheet(71, 1.0, wave), flat = sheet(71, 1.0, [](double, double) { return 0.0; });
  ASSERT_GT(a.triangles.size(), 10'000u);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(first_piercing(a, moved(a, {0, 0, 1e-3}), tolerance));  // close above each other
  EXPECT_FALSE(first_piercing(a, a, tolerance));
  EXPECT_FALSE(first_piercing(flat, moved(flat, {0.3e-2, 0.7e-2, 0}), tolerance));
  EXPECT_FALSE(first_piercing(a, moved(a, {0, 0, 1}), tolerance));
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  RecordProperty("seconds_for_four", std::to_string(taken.count()));
  EXPECT_LT(taken.count(), 10.0);  // a quarter of a second on an ordinary machine; sanitizers take longer
  EXPECT_TRUE(first_piercing(a, flat, tolerance));
}

}  // namespace
}  // namespace pulvis
