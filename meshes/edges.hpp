// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "meshes/welding.hpp"

namespace pulvis {

/// One triangle's side of an edge.
struct EdgeUse {
  std::uint32_t low, high;  ///< the edge's points, lower number first
  std::uint32_t triangle;
};

/// Three per triangle, sorted by edge and then by triangle. Turning triangles round does not change them.
std::vector<EdgeUse> edge_uses(std::span<const Corners> triangles);

/// Whether `triangle` walks the edge from `low` to `high`.
bool runs_upward(const Corners& triangle, const EdgeUse& use);

/// Calls `visit(uses)` with all uses of one edge, edge by edge.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit&& visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
    visit(uses.subspan(begin, end - begin));
    begin = end;
  }
}

/// Disjoint sets of numbers that grow together; each member knows whether it agrees with its set's first.
class AgreementSets {
 public:
  explicit AgreementSets(std::size_t count);

  struct Place {
    std::uint32_t first;  ///< stands for the set
    bool opposite;        ///< to it
  };
  Place find(std::uint32_t member);
  /// Joins the sets of `a` and `b`, which are `opposite` or not. False if they were joined otherwise before.
  bool join(std::uint32_t a, std::uint32_t b, bool opposite = false);

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<char> opposite_;  // to the parent
};

}  // namespace pulvis
