// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/facet_tree.hpp"

#include <algorithm>
#include <numeric>

namespace pulvis {
namespace {

constexpr std::uint32_t leaf_size = 4;

int longest_axis(const Vec3& v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; }

}  // namespace

FacetTree::FacetTree(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  if (count == 0) return;
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> middle(count);
  for (std::size_t t = 0; t < count; ++t)
    middle[t] = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;

  node_.push_back({{}, {}, 0, static_cast<std::uint32_t>(count)});
  for (std::size_t at = 0; at < node_.size(); ++at) {  // children are appended behind
    Node node = node_[at];
    const auto first = order_.begin() + node.first, last = first + node.count;
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300}, middle_low = low, middle_high = high;
    for (auto t = first; t != last; ++t)
      for (int axis = 0; axis < 3; ++axis) {
        for (int k = 0; k < 3; ++k) {
          low[axis] = least(low[axis], mesh.corner(*t, k)[axis]);
          high[axis] = greatest(high[axis], mesh.corner(*t, k)[axis]);
        }
        middle_low[axis] = least(middle_low[axis], middle[*t][axis]);
        middle_high[axis] = greatest(middle_high[axis], middle[*t][axis]);
      }
    node.low = low;
    node.high = high;
    if (node.count > leaf_size) {  // halved along the longest axis: the tree's height is log2 of the count
      const int axis = longest_axis(middle_high - middle_low);
      const std::uint32_t half = node.count / 2;
      std::nth_element(first, first + half, last, [&](std::uint32_t a, std::uint32_t b) {
        return middle[a][axis] != middle[b][axis] ? middle[a][axis] < middle[b][axis] : a < b;
      });
      const auto children = static_cast<std::uint32_t>(node_.size());
      node_.push_back({{}, {}, node.first, half});
      node_.push_back({{}, {}, node.first + half, node.count - half});
      node.first = children;
      node.count = 0;
    }
    node_[at] = node;
  }
}

}  // namespace pulvis
