// SPDX-License-Identifier: Apache-2.0
#include "meshes/slivers.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "meshes/chain_table.hpp"

namespace pulvis {
namespace {

constexpr std::size_t most_neighbours = 8;  // beyond it, each split would multiply the triangles

std::size_t longest_edge(std::span<const Vec3> points, const Corners& t, double& length) {
  std::size_t longest = 0;
  length = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double edge = norm(points[t[(k + 1) % 3]] - points[t[k]]);
    if (edge > length) longest = k, length = edge;
  }
  return longest;
}

class SliverRemover {
 public:
  SliverRemover(std::span<const Vec3> points, double height, std::vector<Corners>& triangles,
                std::vector<std::uint32_t>& facets)
      : points_(points), height_(height), triangles_(triangles), facets_(facets) {}

  std::uint64_t run() {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) note_if_sliver(t);
    if (waiting_.empty()) return 0;
    edges_ = ChainTable(3 * triangles_.size());
    splits_left_ = 4 * waiting_.size() + 1000;
    gone_.assign(triangles_.size(), false);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) add_edges(t);
    std::uint64_t staying = 0;
    // The longest first: what they leave behind is shorter.
    while (!waiting_.empty()) {
      const std::uint32_t t = waiting_.top().triangle;
      waiting_.pop();
      if (gone_[t] || remove(t)) continue;
      if (area_of(points_, triangles_[t]) > 0.0)
        ++staying;
      else
        gone_[t] = true;
    }
    drop_gone();
    return staying;
  }

 private:
  struct Sliver {
    double length;
    std::uint32_t triangle;
    bool operator<(const Sliver& other) const {
      return length != other.length ? length < other.length : triangle > other.triangle;
    }
  };

  void note_if_sliver(std::uint32_t t) {
    if (height_of(points_, triangles_[t]) > height_) return;
    Sliver sliver{0.0, t};
    longest_edge(points_, triangles_[t], sliver.length);
    waiting_.push(sliver);
  }

  static std::uint64_t edge_hash(std::uint32_t a, std::uint32_t b) {
    return stirred(0, std::uint64_t{std::min(a, b)} << 32 | std::max(a, b));
  }
  // Edge k of triangle t has the number 3 t + k. There are fewer than 2^32: see remove().
  void add_edges(std::uint32_t t) {
    for (std::uint32_t k = 0; k < 3; ++k)
      edges_.add(edge_hash(triangles_[t][k], triangles_[t][(k + 1) % 3]), 3 * t + k);
  }

  // False if there are too many.
  bool find_neighbours(std::uint32_t t, std::uint32_t a, std::uint32_t b) {
    using Then = ChainTable::Then;
    neighbours_.clear();
    edges_.walk(edge_hash(a, b), [&](std::uint32_t edge) {
      const std::uint32_t other = edge / 3;
      if (gone_[other]) return Then::drop;
      const std::uint32_t from = triangles_[other][edge % 3], to = triangles_[other][(edge % 3 + 1) % 3];
      if (other == t || !((from == a && to == b) || (from == b && to == a))) return Then::keep;
      neighbours_.push_back(other);
      return neighbours_.size() > most_neighbours ? Then::stop : Then::keep;
    });
    return neighbours_.size() <= most_neighbours;
  }

  // False if the sliver has to stay.
  bool remove(std::uint32_t t) {
    double length;
    const std::size_t k = longest_edge(points_, triangles_[t], length);
    const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3],
                        apex = triangles_[t][(k + 2) % 3];
    if (!find_neighbours(t, a, b) || splits_left_ < neighbours_.size()) return false;
    const double height = height_of(points_, triangles_[t]);
    for (const std::uint32_t neighbour : neighbours_)
      if (!may_split(neighbour, a, b, apex, height)) return false;
    if (triangles_.size() + 2 * neighbours_.size() > ChainTable::none / 3) return false;
    splits_left_ -= neighbours_.size();
    gone_[t] = true;
    for (const std::uint32_t neighbour : neighbours_) {
      gone_[neighbour] = true;
      add_half(neighbour, a, apex);
      add_half(neighbour, b, apex);
    }
    return true;
  }

  // A sound triangle is not spoilt for the sake of a sliver unless its halves are better than that. Slivers
  // may be split in any way, for in a row of them the last is the first that can go.
  bool may_split(std::uint32_t t, std::uint32_t a, std::uint32_t b, std::uint32_t apex, double height) const {
    const Corners& whole = triangles_[t];
    if (std::find(whole.begin(), whole.end(), apex) != whole.end()) return true;
    if (height_of(points_, whole) <= height_) return true;
    return least(height_of(points_, half_of(whole, a, apex)), height_of(points_, half_of(whole, b, apex))) >
           height;
  }

  // The triangle with its point `replaced` moved to `apex`, which lies on one of its edges.
  static Corners half_of(Corners triangle, std::uint32_t replaced, std::uint32_t apex) {
    std::replace(triangle.begin(), triangle.end(), replaced, apex);
    return triangle;
  }

  void add_half(std::uint32_t t, std::uint32_t replaced, std::uint32_t apex) {
    const Corners whole = triangles_[t], half = half_of(whole, replaced, apex);
    if (std::find(whole.begin(), whole.end(), apex) != whole.end()) return;
    const auto number = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(half);
    facets_.push_back(facets_[t]);
    gone_.push_back(false);
    add_edges(number);
    note_if_sliver(number);
  }

  void drop_gone() {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (gone_[t]) continue;
      triangles_[kept] = triangles_[t];
      facets_[kept++] = facets_[t];
    }
    triangles_.resize(kept);
    facets_.resize(kept);
  }

  std::span<const Vec3> points_;
  double height_;
  std::vector<Corners>& triangles_;
  std::vector<std::uint32_t>& facets_;
  ChainTable edges_{0};
  std::vector<bool> gone_;
  std::priority_queue<Sliver> waiting_;
  std::vector<std::uint32_t> neighbours_;
  std::uint64_t splits_left_ = 0;
};

}  // namespace

double area_of(std::span<const Vec3> points, const Corners& t) {
  return 0.5 * norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
}

double height_of(std::span<const Vec3> points, const Corners& t) {
  double length;
  longest_edge(points, t, length);
  return length > 0.0 ? 2.0 * area_of(points, t) / length : 0.0;
}

std::uint64_t remove_slivers(std::span<const Vec3> points, double height, std::vector<Corners>& triangles,
                             std::vector<std::uint32_t>& facets) {
  return SliverRemover(points, height, triangles, facets).run();
}

}  // namespace pulvis
