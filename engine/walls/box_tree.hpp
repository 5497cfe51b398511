// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/math/bounds.hpp"
#include "engine/walls/triangle_mesh.hpp"

namespace pulvis {

/// The triangles of a mesh in boxes within boxes: each node has its triangles' bounding box and either two
/// children with about half of them each, or a few triangles of its own.
class BoxTree {
 public:
  explicit BoxTree(const TriangleMesh& mesh);

  struct Node {
    Bounds bounds;
    std::uint32_t first_child = 0;  ///< the second follows it; 0: a leaf
    std::uint32_t begin = 0, end = 0;
  };
  const Node& node(std::uint32_t number) const { return nodes_[number]; }
  std::span<const std::uint32_t> triangles(const Node& leaf) const {
    return std::span(order_).subspan(leaf.begin, leaf.end - leaf.begin);
  }
  bool empty() const { return order_.empty(); }

  /// Calls visit(triangle) for every triangle in a leaf whose box is closer to `p` than `far`, in a fixed order.
  template <class Visit>
  void for_near(const Vec3& p, double far, Visit&& visit) const {
    if (empty()) return;
    std::uint32_t waiting[64];  // halves of halves: the tree is no higher than 32
    int count = 0;
    waiting[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (node.bounds.square_distance(p) > far * far) continue;
      if (node.first_child == 0) {
        for (const std::uint32_t t : triangles(node)) visit(t);
      } else {
        waiting[count++] = node.first_child + 1;
        waiting[count++] = node.first_child;
      }
    }
  }

 private:
  void split(std::uint32_t number, std::span<const Bounds> boxes);

  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Calls `visit(triangle_a, triangle_b)` for all pairs in leaves whose boxes overlap, until it returns true.
template <class Visit>
bool any_near_pair(const BoxTree& a, const BoxTree& b, Visit&& visit) {
  if (a.empty() || b.empty()) return false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting{{0u, 0u}};
  while (!waiting.empty()) {
    const auto [number_a, number_b] = waiting.back();
    waiting.pop_back();
    const BoxTree::Node &node_a = a.node(number_a), &node_b = b.node(number_b);
    if (!node_a.bounds.overlaps(node_b.bounds)) continue;
    const bool leaf_a = node_a.first_child == 0, leaf_b = node_b.first_child == 0;
    if (leaf_a && leaf_b) {
      for (const std::uint32_t ta : a.triangles(node_a))
        for (const std::uint32_t tb : b.triangles(node_b))
          if (visit(ta, tb)) return true;
    } else if (leaf_b || (!leaf_a && node_a.end - node_a.begin >= node_b.end - node_b.begin)) {
      // The fuller node opens, so that both trees are gone down together.
      waiting.push_back({node_a.first_child + 1, number_b});
      waiting.push_back({node_a.first_child, number_b});
    } else {
      waiting.push_back({number_a, node_b.first_child + 1});
      waiting.push_back({number_a, node_b.first_child});
    }
  }
  return false;
}

}  // namespace pulvis
