// SPDX-License-Identifier: Apache-2.0
// Nearest points of surfaces against a brute-force search over the surface.
#include "engine/walls/surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "validation/draw.hpp"

using namespace pulvis;
using pulvis::validation::Draw;

namespace {

/// Smallest distance from p to the image of [0,1]^2 under `at`: a grid, then ever finer grids around its best
/// point.
double searched_distance(const std::function<Vec3(double, double)>& at, const Vec3& p) {
  double u = 0.5, v = 0.5, width = 1.0, best = 1e300;
  for (int round = 0; round < 14; ++round) {
    double best_u = u, best_v = v;
    constexpr int half = 20;
    for (int i = -half; i <= half; ++i)
      for (int j = -half; j <= half; ++j) {
        const double a = std::clamp(u + 0.5 * width * i / half, 0.0, 1.0),
                     b = std::clamp(v + 0.5 * width * j / half, 0.0, 1.0);
        const double d = norm(at(a, b) - p);
        if (d < best) best = d, best_u = a, best_v = b;
      }
    u = best_u;
    v = best_v;
    width *= 0.2;
  }
  return best;
}

struct Frame {
  Vec3 u, v, w;
  explicit Frame(Draw& draw) {
    w = draw.direction();
    const Vec3 helper = cross(w, draw.direction());
    u = helper / norm(helper);
    v = cross(w, u);
  }
};

void expect_nearest(const Surface& s, const Vec3& p, const std::function<Vec3(double, double)>& at) {
  const NearestPoint nearest = nearest_point(s, p);
  const double ours = norm(nearest.point - p), searched = searched_distance(at, p);
  EXPECT_NEAR(ours, searched, 1e-9);
  // The point must lie on the surface itself.
  EXPECT_LT(searched_distance(at, nearest.point), 1e-8);
}

constexpr double two_pi = 6.283185307179586;

TEST(NearestPoint, OfARectangle) {
  int inside = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 61);
    const Frame f(draw);
    Surface s;
    s.kind = Surface::Kind::rectangle;
    s.centre = draw.vector(1.0);
    s.normal = f.w;
    s.side[0] = f.u;
    s.side[1] = f.v;
    s.half[0] = draw.between(0.1, 2.0);
    s.half[1] = draw.between(0.1, 2.0);
    const Vec3 p = s.centre + draw.vector(3.0);
    expect_nearest(s, p, [&](double a, double b) {
      return s.centre + ((2 * a - 1) * s.half[0]) * f.u + ((2 * b - 1) * s.half[1]) * f.v;
    });
    const Vec3 d = p - s.centre;
    const bool in_face = std::fabs(dot(d, f.u)) < s.half[0] && std::fabs(dot(d, f.v)) < s.half[1];
    EXPECT_EQ(nearest_point(s, p).in_face, in_face);
    EXPECT_NEAR(nearest_point(s, p).elevation, dot(d, f.w), 1e-14);
    inside += in_face;
  }
  EXPECT_GT(inside, 20);
}

TEST(NearestPoint, OfADisc) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 62);
    const Frame f(draw);
    Surface s;
    s.kind = Surface::Kind::disc;
    s.centre = draw.vector(1.0);
    s.normal = f.w;
    s.radius = draw.between(0.1, 2.0);
    const Vec3 p = s.centre + draw.vector(3.0);
    // A square of twice the radius, its corners pulled in to the rim.
    expect_nearest(s, p, [&](double a, double b) {
      const Vec3 in_square = (2 * a - 1) * f.u + (2 * b - 1) * f.v;
      return s.centre + (s.radius / std::max(1.0, norm(in_square))) * in_square;
    });
    const Vec3 d = p - s.centre;
    EXPECT_EQ(nearest_point(s, p).in_face, norm(d - dot(d, f.w) * f.w) <= s.radius);
    EXPECT_NEAR(nearest_point(s, p).elevation, dot(d, f.w), 1e-14);
  }
}

TEST(NearestPoint, OfATube) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 63);
    const Frame f(draw);
    Surface s;
    s.kind = Surface::Kind::frustum;
    s.centre = draw.vector(1.0);
    s.normal = f.w;
    s.radius = s.other_radius = draw.between(0.2, 2.0);
    s.height = draw.between(0.2, 3.0);
    const Vec3 p = s.centre + draw.vector(4.0);
    // The seam of the angle lies opposite to the point.
    const double seam = std::atan2(dot(p - s.centre, f.v), dot(p - s.centre, f.u)) + 0.5 * two_pi;
    expect_nearest(s, p, [&](double a, double b) {
      return s.centre + (a * s.height) * f.w +
             s.radius * (std::cos(seam + two_pi * b) * f.u + std::sin(seam + two_pi * b) * f.v);
    });
    const double along = dot(p - s.centre, f.w), across = norm(p - s.centre - along * f.w);
    EXPECT_EQ(nearest_point(s, p).in_face, along >= 0.0 && along <= s.height);
    EXPECT_NEAR(nearest_point(s, p).elevation, across - s.radius, 1e-14);
  }
}

TEST(NearestPoint, OfATruncatedCone) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 65);
    const Frame f(draw);
    const double low = draw.between(0.0, 2.0), high = draw.between(0.0, 2.0), height = draw.between(0.2, 3.0);
    const Surface s = frustum_surfaces("c", draw.vector(1.0), f.w, low, high, height, {}).front();
    const Vec3 p = s.centre + draw.vector(4.0);
    const double seam = std::atan2(dot(p - s.centre, f.v), dot(p - s.centre, f.u)) + 0.5 * two_pi;
    expect_nearest(s, p, [&](double a, double b) {
      return s.centre + (a * height) * f.w +
             (low + a * (high - low)) *
                 (std::cos(seam + two_pi * b) * f.u + std::sin(seam + two_pi * b) * f.v);
    });
  }
}

TEST(NearestPoint, OfASphereAndARing) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 66);
    const Surface ball = sphere_surface("s", draw.vector(1.0), draw.between(0.5, 2.0));
    const Vec3 p = ball.centre + draw.vector(4.0);
    const NearestPoint on_ball = nearest_point(ball, p);
    EXPECT_NEAR(norm(on_ball.point - ball.centre), ball.radius, 1e-14);
    EXPECT_NEAR(norm(on_ball.point - p), std::fabs(norm(p - ball.centre) - ball.radius), 1e-14);
    const Frame f(draw);
    const Surface ring = disc_surface("r", draw.vector(1.0), f.w, 2.0, 0.8);
    const Vec3 q = ring.centre + draw.vector(4.0);
    const double seam = std::atan2(dot(q - ring.centre, f.v), dot(q - ring.centre, f.u)) + 0.5 * two_pi;
    expect_nearest(ring, q, [&](double a, double b) {
      return ring.centre +
             (0.8 + 1.2 * a) * (std::cos(seam + two_pi * b) * f.u + std::sin(seam + two_pi * b) * f.v);
    });
  }
}

TEST(NearestPoint, OfAPlane) {
  for (std::uint64_t k = 0; k < 200; ++k) {
    Draw draw(k, 64);
    const Surface s = plane_surface("p", draw.vector(1.0), draw.direction());
    const Vec3 p = draw.vector(5.0);
    const NearestPoint n = nearest_point(s, p);
    EXPECT_TRUE(n.in_face);
    EXPECT_NEAR(dot(n.point - s.centre, s.normal), 0.0, 1e-14);
    EXPECT_NEAR(norm(cross(p - n.point, s.normal)), 0.0, 1e-14);
    EXPECT_NEAR(n.elevation, dot(p - s.centre, s.normal), 1e-14);
  }
}

TEST(NearestPoint, OnATubesAxisIsOneOfItsPoints) {
  Surface s;
  s.kind = Surface::Kind::frustum;
  for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
    s.normal = axis;
    s.radius = s.other_radius = 2.0;
    s.height = 4.0;
    EXPECT_NEAR(norm(nearest_point(s, 1.5 * axis).point - 1.5 * axis), 2.0, 1e-15);
  }
}

TEST(BoxSurfaces, CloseTheBoxButForTheFacesLeftOpen) {
  Region box;
  box.min = {-1, 0, 2};
  box.max = {3, 5, 4};
  EXPECT_EQ(box_surfaces("die", box, {}).size(), 6u);
  const auto open = box_surfaces("die", box, {"+z", "-x"});
  ASSERT_EQ(open.size(), 4u);
  std::set<std::string> names;
  for (const Surface& s : open) names.insert(s.name);
  EXPECT_EQ(names, (std::set<std::string>{"die.+x", "die.-y", "die.+y", "die.-z"}));
  // From the middle of the box each face is half an edge away; from a corner three faces are at no distance.
  double sum = 0.0;
  int at_corner = 0;
  for (const Surface& s : box_surfaces("die", box, {})) {
    sum += norm(nearest_point(s, {1, 2.5, 3}).point - Vec3{1, 2.5, 3});
    at_corner += norm(nearest_point(s, {-1, 5, 2}).point - Vec3{-1, 5, 2}) < 1e-15;
  }
  EXPECT_NEAR(sum, 2 * (2 + 2.5 + 1), 1e-14);
  EXPECT_EQ(at_corner, 3);
}

TEST(CylinderSurfaces, AreASideAndTwoEnds) {
  Region r;
  r.shape = Region::Shape::cylinder;
  r.base = {1, 1, 1};
  r.axis = {0, 1, 0};
  r.radius = 2.0;
  r.height = 3.0;
  const auto all = cylinder_surfaces("cup", r, {});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(cylinder_surfaces("cup", r, {"top"}).size(), 2u);
  EXPECT_EQ(cylinder_surfaces("cup", r, {"top", "base"}).size(), 1u);
  const Vec3 p{1.5, 2.0, 1.0};
  EXPECT_NEAR(norm(nearest_point(all[0], p).point - p), 1.5, 1e-15);
  EXPECT_NEAR(norm(nearest_point(all[1], p).point - p), 1.0, 1e-15);
  EXPECT_NEAR(norm(nearest_point(all[2], p).point - p), 2.0, 1e-15);
}

}  // namespace
