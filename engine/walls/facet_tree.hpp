// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/walls/triangle_mesh.hpp"

namespace pulvis {

/// A tree of boxes around the triangles of a mesh, to find those near a point. It stands in the mesh's own
/// frame and so outlives every rigid motion.
class FacetTree {
 public:
  FacetTree() = default;
  explicit FacetTree(const TriangleMesh& mesh);

  /// Calls visit(triangle) for every triangle whose box is closer to `p` than `far`, in a fixed order.
  template <class Visit>
  void for_near(const Vec3& p, double far, Visit&& visit) const {
    if (node_.empty()) return;
    std::uint32_t stack[64];
    int height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const Node& node = node_[stack[--height]];
      if (square_distance(node, p) > far * far) continue;
      if (node.count > 0) {
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) visit(order_[k]);
      } else {
        stack[height++] = node.first + 1;
        stack[height++] = node.first;
      }
    }
  }

 private:
  struct Node {
    Vec3 low, high;
    std::uint32_t first = 0;  ///< leaf: into `order_`; else: of its two children, side by side
    std::uint32_t count = 0;  ///< triangles of a leaf; 0: not a leaf
  };
  static double square_distance(const Node& node, const Vec3& p) {
    const auto beyond = [](double x, double low, double high) {
      return greatest(greatest(low - x, x - high), 0.0);
    };
    return square(beyond(p.x, node.low.x, node.high.x)) + square(beyond(p.y, node.low.y, node.high.y)) +
           square(beyond(p.z, node.low.z, node.high.z));
  }

  std::vector<Node> node_;
  std::vector<std::uint32_t> order_;
};

}  // namespace pulvis
