// SPDX-License-Identifier: Apache-2.0
#include "meshes/welding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

#include "meshes/chain_table.hpp"

namespace pulvis {
namespace {

constexpr std::uint32_t none = ChainTable::none;

// Equal points get equal numbers, in the order of their first appearance.
struct DistinctPoints {
  std::vector<Vec3> points;
  std::vector<Corners> triangles;
};

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) hash = stirred(hash, std::bit_cast<std::uint64_t>(p[axis]));
  return hash;
}

DistinctPoints distinct_points(std::span<const std::array<Vec3, 3>> triangles) {
  DistinctPoints result;
  ChainTable table(triangles.size());
  result.triangles.reserve(triangles.size());
  const auto number_of = [&](const Vec3& corner) {
    const Vec3 p = corner + Vec3{0.0, 0.0, 0.0};  // negative zeros become zeros
    const std::uint64_t hash = hash_of(p);
    for (std::uint32_t k = table.first(hash); k != none; k = table.after(k))
      if (result.points[k] == p) return k;
    const auto number = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(p);
    table.add(hash, number);
    return number;
  };
  for (const auto& corners : triangles)
    result.triangles.push_back({number_of(corners[0]), number_of(corners[1]), number_of(corners[2])});
  return result;
}

// In the order of the coordinates.
bool before(const Vec3& p, const Vec3& q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); }

// Points that stay, in a grid of cells a few times as wide as the distance. They are further apart than it,
// so that a cell holds few of them however many points fall into it.
class StayingPoints {
 public:
  StayingPoints(const std::vector<Vec3>& points, double distance)
      : points_(points), distance_(distance), cell_(4.0 * distance), table_(points.size()) {}

  /// The nearest one within the distance of `p`, or `none`; of equally near ones that which came first.
  std::uint32_t nearest(const Vec3& p) const {
    const Cell low = cell_of(p - Vec3{distance_, distance_, distance_});
    const Cell high = cell_of(p + Vec3{distance_, distance_, distance_});
    std::uint32_t best = none;
    double best_squared = distance_ * distance_;
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          for (std::uint32_t k = table_.first(hash_of({x, y, z})); k != none; k = table_.after(k)) {
            const Vec3 apart = points_[k] - p;
            const double squared = dot(apart, apart);
            if (squared > best_squared ||
                (squared == best_squared && best != none && !before(points_[k], points_[best])))
              continue;
            best = k;
            best_squared = squared;
          }
    return best;
  }
  void add(std::uint32_t number) { table_.add(hash_of(cell_of(points_[number])), number); }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Vec3& p) const {
    return {std::llround(p.x / cell_), std::llround(p.y / cell_), std::llround(p.z / cell_)};
  }
  static std::uint64_t hash_of(const Cell& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t index : cell) hash = stirred(hash, static_cast<std::uint64_t>(index));
    return hash;
  }

  const std::vector<Vec3>& points_;
  double distance_, cell_;
  ChainTable table_;
};

// For each point the one it becomes.
std::vector<std::uint32_t> targets_of(const std::vector<Vec3>& points, double distance) {
  std::vector<std::uint32_t> targets(points.size());
  std::iota(targets.begin(), targets.end(), 0u);
  if (!(distance > 0.0)) return targets;
  StayingPoints staying(points, distance);
  struct Placed {
    Vec3 p;
    std::uint32_t number;
  };
  std::vector<Placed> order;  // with the coordinates, which a sort of numbers would look up all over memory
  order.reserve(points.size());
  for (const std::uint32_t k : targets) order.push_back({points[k], k});
  std::sort(order.begin(), order.end(), [](const Placed& a, const Placed& b) { return before(a.p, b.p); });
  for (const auto& [p, k] : order) {
    const std::uint32_t near = staying.nearest(p);
    if (near == none)
      staying.add(k);
    else
      targets[k] = near;
  }
  return targets;
}

bool has_a_point_twice(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace

WeldedTriangles weld(std::span<const std::array<Vec3, 3>> triangles, double distance) {
  const DistinctPoints distinct = distinct_points(triangles);
  const std::vector<std::uint32_t> targets = targets_of(distinct.points, distance);
  WeldedTriangles result;
  std::vector<std::uint32_t> numbers(distinct.points.size(), none);
  const auto number_of = [&](std::uint32_t point) {
    std::uint32_t& number = numbers[targets[point]];
    if (number == none) {
      number = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(distinct.points[targets[point]]);
    }
    return number;
  };
  for (std::uint32_t k = 0; k < targets.size(); ++k) result.points_moved += targets[k] != k;
  for (std::uint32_t facet = 0; facet < distinct.triangles.size(); ++facet) {
    const Corners& old = distinct.triangles[facet];
    const Corners corners = {number_of(old[0]), number_of(old[1]), number_of(old[2])};
    if (has_a_point_twice(old)) {
      ++result.degenerate;
    } else if (has_a_point_twice(corners)) {
      ++result.needles;
    } else {
      result.triangles.push_back(corners);
      result.facets.push_back(facet);
    }
  }
  return result;
}

}  // namespace pulvis
