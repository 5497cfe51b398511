// SPDX-License-Identifier: Apache-2.0
#include "meshes/piercing.hpp"

#include <array>
#include <vector>

#include "engine/walls/box_tree.hpp"
#include "meshes/edges.hpp"

namespace pulvis {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

// A mesh with the normal of each triangle and its neighbour across each of its edges.
class Surroundings {
 public:
  explicit Surroundings(const TriangleMesh& mesh)
      : mesh_(mesh), neighbours_(mesh.triangles.size(), {none, none, none}) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Vec3 direction =
          cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
      const double size = norm(direction);
      normals_.push_back(size > 0.0 ? direction / size : Vec3{});
    }
    const auto uses = edge_uses(mesh.triangles);
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      if (edge.size() != 2) return;
      note(edge[0], edge[1].triangle);
      note(edge[1], edge[0].triangle);
    });
  }

  const TriangleMesh& mesh() const { return mesh_; }
  /// Of `p` above the plane of the triangle; zero for one without area.
  double elevation(std::uint32_t triangle, const Vec3& p) const {
    return dot(p - mesh_.corner(triangle, 0), normals_[triangle]);
  }
  /// Across the edge from corner k to the next; `none` at a rim and where more than two meet.
  std::uint32_t neighbour(std::uint32_t triangle, std::size_t k) const { return neighbours_[triangle][k]; }
  /// Whether both walk their common edge in opposite directions, as on a surface of two sides.
  bool agree(std::uint32_t triangle, std::size_t k) const {
    const Corners& own = mesh_.triangles[triangle];
    const Corners& other = mesh_.triangles[neighbour(triangle, k)];
    for (std::size_t j = 0; j < 3; ++j)
      if (other[j] == own[(k + 1) % 3]) return other[(j + 1) % 3] == own[k];
    return false;
  }

 private:
  void note(const EdgeUse& use, std::uint32_t other) {
    const Corners& corners = mesh_.triangles[use.triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = corners[k], q = corners[(k + 1) % 3];
      if ((p == use.low && q == use.high) || (p == use.high && q == use.low))
        neighbours_[use.triangle][k] = other;
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Vec3> normals_;
  std::vector<Corners> neighbours_;
};

// An edge of one mesh and the elevations of its ends above a triangle of the other.
struct Segment {
  Vec3 from, to;
  double from_elevation, to_elevation;
};

// 1: goes in through the triangle's plane, -1: comes out, 0: neither by more than the tolerance.
int passage(double from, double to, double tolerance) {
  if (from > tolerance && to < -tolerance) return 1;
  return from < -tolerance && to > tolerance ? -1 : 0;
}

// How far inside edge k of the triangle a point of its plane lies.
double depth(const TriangleMesh& mesh, std::uint32_t t, std::size_t k, const Vec3& point) {
  const int first = static_cast<int>(k);
  const Vec3 &a = mesh.corner(t, first), &b = mesh.corner(t, (first + 1) % 3),
             &c = mesh.corner(t, (first + 2) % 3);
  const Vec3 along = (b - a) / norm(b - a);
  const Vec3 inward = (c - a) - dot(c - a, along) * along;
  return dot(point - a, inward) / norm(inward);
}

std::optional<Vec3> crossing_of(const Surroundings& around, std::uint32_t t, const Segment& s,
                                double tolerance) {
  const TriangleMesh& mesh = around.mesh();
  const int way = passage(s.from_elevation, s.to_elevation, tolerance);
  if (way == 0) return std::nullopt;
  const Vec3 crossing = s.from + s.from_elevation / (s.from_elevation - s.to_elevation) * (s.to - s.from);
  std::size_t near_edge = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    const double inside = depth(mesh, t, k, crossing);
    if (inside > tolerance) continue;
    if (inside < -tolerance || near_edge != 3) return std::nullopt;  // outside, or at a corner
    near_edge = k;
  }
  if (near_edge == 3) return crossing;
  // At an edge: through it only if it is through the neighbour's plane too, and the same way. Across a ridge
  // it would be the other way.
  const std::uint32_t neighbour = around.neighbour(t, near_edge);
  if (neighbour == none) return std::nullopt;
  const int next_way =
      passage(around.elevation(neighbour, s.from), around.elevation(neighbour, s.to), tolerance);
  const bool through = next_way != 0 && (next_way == way) == around.agree(t, near_edge);
  return through ? std::optional(crossing) : std::nullopt;
}

// An edge of triangle `piercer` through triangle `pierced`.
std::optional<Vec3> crossing_of(const TriangleMesh& mesh, std::uint32_t piercer, const Surroundings& other,
                                std::uint32_t pierced, double tolerance) {
  std::array<double, 3> elevations;
  for (int k = 0; k < 3; ++k)
    elevations[static_cast<std::size_t>(k)] = other.elevation(pierced, mesh.corner(piercer, k));
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Segment edge{mesh.corner(piercer, k), mesh.corner(piercer, next),
                       elevations[static_cast<std::size_t>(k)], elevations[static_cast<std::size_t>(next)]};
    if (const auto place = crossing_of(other, pierced, edge, tolerance)) return place;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Piercing> first_piercing(const TriangleMesh& a, const TriangleMesh& b, double tolerance) {
  const BoxTree tree_a(a), tree_b(b);
  if (tree_a.empty() || tree_b.empty() || !tree_a.node(0).bounds.overlaps(tree_b.node(0).bounds))
    return std::nullopt;
  const Surroundings around_a(a), around_b(b);
  std::optional<Piercing> found;
  any_near_pair(tree_a, tree_b, [&](std::uint32_t ta, std::uint32_t tb) {
    auto place = crossing_of(a, ta, around_b, tb, tolerance);
    if (!place) place = crossing_of(b, tb, around_a, ta, tolerance);
    if (place) found = Piercing{*place, ta, tb};
    return found.has_value();
  });
  return found;
}

}  // namespace pulvis
