// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/faceted_wall.hpp"

#include <algorithm>
#include <numeric>

#include "engine/math/functions.hpp"

namespace pulvis {
namespace {

/// One side of a triangle, to be matched with the same side of its neighbour.
struct Side {
  std::uint32_t low, high;  ///< the points it joins
  std::uint32_t triangle;
  std::uint8_t corner;  ///< it starts at
  bool forward;         ///< it runs from low to high
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1u) % 3u];
      sides.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
  });
  return sides;
}

/// Height of a triangle over one of its sides, m.
double height_over(const TriangleMesh& mesh, const Side& side) {
  const Vec3 &a = mesh.corner(side.triangle, side.corner),
             &b = mesh.corner(side.triangle, (side.corner + 1) % 3),
             &c = mesh.corner(side.triangle, (side.corner + 2) % 3);
  return norm(cross(b - a, c - a)) / norm(b - a);
}

std::uint32_t find_root(std::vector<std::uint32_t>& parent, std::uint32_t t) {
  while (parent[t] != t) t = parent[t] = parent[parent[t]];
  return t;
}

bool are_smooth(const TriangleMesh& mesh, const Side& a, const Side& b, Vec3 normal_a, const Vec3& normal_b,
                const Smoothness& smoothness) {
  if (a.forward == b.forward) normal_a = -normal_a;     // one of them is turned round
  const double tilt = norm(cross(normal_a, normal_b));  // sine of the angle between them
  const double feature = smoothness.feature_angle;
  const bool gentle = dot(normal_a, normal_b) > 0.0 && tilt < sine_of_cycles(feature / (2.0 * pi));
  // Below this the rounding of STL's short numbers can bend small triangles.
  constexpr double least_bend = 0.035;
  if (!gentle || tilt < least_bend) return gentle;
  const double bend_radius = least(height_over(mesh, a), height_over(mesh, b)) / tilt;
  return bend_radius >= smoothness.largest_radius;
}

}  // namespace

FacetedWall::FacetedWall(TriangleMesh mesh, const Smoothness& smoothness)
    : mesh_(std::move(mesh)), facet_(mesh_.triangles.size()), tree_(mesh_) {
  for (std::size_t t = 0; t < facet_.size(); ++t) {
    const Vec3 across =
        cross(mesh_.corner(t, 1) - mesh_.corner(t, 0), mesh_.corner(t, 2) - mesh_.corner(t, 0));
    facet_[t].normal = across / norm(across);
  }
  gather_patches(smoothness);
}

void FacetedWall::gather_patches(const Smoothness& smoothness) {
  std::vector<std::uint32_t> parent(facet_.size());
  std::iota(parent.begin(), parent.end(), 0u);
  std::vector<bool> on_rim(mesh_.points.size(), false);
  const std::vector<Side> sides = sorted_sides(mesh_);
  for (std::size_t from = 0, to = 0; from < sides.size(); from = to) {
    while (to < sides.size() && sides[to].low == sides[from].low && sides[to].high == sides[from].high) ++to;
    const Side &a = sides[from], &b = sides[to - 1];
    if (to - from == 2 &&
        are_smooth(mesh_, a, b, facet_[a.triangle].normal, facet_[b.triangle].normal, smoothness)) {
      for (const Side* side : {&a, &b})
        facet_[side->triangle].smooth_edge |= static_cast<std::uint8_t>(1u << side->corner);
      const std::uint32_t ra = find_root(parent, a.triangle), rb = find_root(parent, b.triangle);
      parent[std::max(ra, rb)] = std::min(ra, rb);
    } else {
      on_rim[a.low] = on_rim[a.high] = true;
    }
  }
  std::vector<std::uint32_t> number(facet_.size());
  for (std::uint32_t t = 0; t < facet_.size(); ++t) {  // numbered in the order of their first triangles
    const std::uint32_t root_of_t = find_root(parent, t);
    if (root_of_t == t) number[t] = patches_++;
    facet_[t].patch = number[root_of_t];
    for (unsigned k = 0; k < 3; ++k)
      if (!on_rim[mesh_.triangles[t][k]]) facet_[t].smooth_corner |= static_cast<std::uint8_t>(1u << k);
  }
}

void FacetedWall::include(Vec3& low, Vec3& high) const {
  for (const Vec3& p : mesh_.points)
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = least(low[axis], p[axis]);
      high[axis] = greatest(high[axis], p[axis]);
    }
}

NearestPoint FacetedWall::nearest(std::uint32_t triangle, const Vec3& p) const {
  const Facet& facet = facet_[triangle];
  const Vec3* corner[3];
  for (int k = 0; k < 3; ++k) corner[k] = &mesh_.corner(triangle, k);
  const double elevation = dot(p - *corner[0], facet.normal);
  NearestPoint best{p - elevation * facet.normal, true, elevation};
  double least_square = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = *corner[k], &b = *corner[(k + 1) % 3];
    const Vec3 edge = b - a, from_a = p - a;
    if (dot(from_a, cross(edge, facet.normal)) <= 0.0) continue;  // on the inner side of this edge
    const double share = dot(from_a, edge) / dot(edge, edge);
    // The end itself, not a point computed near it: both triangles of an edge then see the same point.
    const Vec3 point = share <= 0.0 ? a : share >= 1.0 ? b : a + share * edge;
    const Vec3 away = p - point;
    if (dot(away, away) >= least_square) continue;
    least_square = dot(away, away);
    const int end = share >= 1.0 ? (k + 1) % 3 : k;
    const bool at_corner = share <= 0.0 || share >= 1.0;
    best.point = point;
    best.in_face = ((at_corner ? facet.smooth_corner >> end : facet.smooth_edge >> k) & 1) != 0;
  }
  return best;
}

bool FacetedWall::passed(std::uint32_t triangle, const Vec3& from, const Vec3& to) const {
  const Facet& facet = facet_[triangle];
  const Vec3& first = mesh_.corner(triangle, 0);
  if ((dot(from - first, facet.normal) > 0.0) == (dot(to - first, facet.normal) > 0.0)) return false;
  // Seen along the way the corners lie in a plane, with the way in its origin. A corner has the same place
  // for all triangles that share it, and an edge's sign flips exactly when it is run the other way: so no way
  // slips through between triangles (S. Woop, C. Benthin, I. Wald, J. Comput. Graph. Tech. 2 (2013) 65).
  const Vec3 way = to - from;
  const int z = magnitude(way.x) > magnitude(way.y) ? (magnitude(way.x) > magnitude(way.z) ? 0 : 2)
                                                    : (magnitude(way.y) > magnitude(way.z) ? 1 : 2);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const double shear_x = way[x] / way[z], shear_y = way[y] / way[z];
  double px[3], py[3];
  for (int k = 0; k < 3; ++k) {
    const Vec3 corner = mesh_.corner(triangle, k) - from;
    px[k] = corner[x] - shear_x * corner[z];
    py[k] = corner[y] - shear_y * corner[z];
  }
  bool left = true, right = true;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double side = px[k] * py[next] - py[k] * px[next];
    left = left && side >= 0.0;
    right = right && side <= 0.0;
  }
  return left || right;
}

}  // namespace pulvis
