// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace pulvis {
namespace {

constexpr std::uint32_t leaf_triangles = 4;

int longest_axis(const Vec3& size) {
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(const TriangleMesh& mesh) : order_(mesh.triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Bounds> boxes(order_.size());
  for (const std::uint32_t t : order_)
    for (int k = 0; k < 3; ++k) boxes[t].include(mesh.corner(t, k));
  nodes_.push_back({{}, 0, 0, static_cast<std::uint32_t>(order_.size())});
  // Nodes are appended while they are split: breadth first, without recursion.
  for (std::uint32_t number = 0; number < nodes_.size(); ++number) split(number, boxes);
}

void BoxTree::split(std::uint32_t number, std::span<const Bounds> boxes) {
  Node node = nodes_[number];
  Bounds centres;
  for (std::uint32_t k = node.begin; k < node.end; ++k) {
    node.bounds.include(boxes[order_[k]]);
    centres.include(boxes[order_[k]].centre());
  }
  if (node.end - node.begin > leaf_triangles) {
    const int axis = longest_axis(centres.size());
    const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
    const auto at = [&](std::uint32_t k) { return order_.begin() + k; };
    std::nth_element(at(node.begin), at(middle), at(node.end), [&](std::uint32_t a, std::uint32_t b) {
      const double p = boxes[a].centre()[axis], q = boxes[b].centre()[axis];
      return p != q ? p < q : a < b;
    });
    node.first_child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, 0, node.begin, middle});
    nodes_.push_back({{}, 0, middle, node.end});
  }
  nodes_[number] = node;
}

}  // namespace pulvis
