// SPDX-License-Identifier: Apache-2.0
#include "meshes/edges.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace pulvis {

std::vector<EdgeUse> edge_uses(std::span<const Corners> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({triangles[t][k], triangles[t][(k + 1) % 3]});
      uses.push_back({low, high, t});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

bool runs_upward(const Corners& triangle, const EdgeUse& use) {
  for (std::size_t k = 0; k < 3; ++k)
    if (triangle[k] == use.low) return triangle[(k + 1) % 3] == use.high;
  return false;
}

AgreementSets::AgreementSets(std::size_t count) : parent_(count), opposite_(count, 0) {
  std::iota(parent_.begin(), parent_.end(), 0u);
}

// Two walks: to the set's first, and again to hang all that was passed directly below it.
AgreementSets::Place AgreementSets::find(std::uint32_t member) {
  bool opposite = false;
  std::uint32_t first = member;
  for (; parent_[first] != first; first = parent_[first]) opposite ^= opposite_[first] != 0;
  bool rest = opposite;
  for (std::uint32_t k = member; parent_[k] != first && k != first;) {
    const std::uint32_t above = std::exchange(parent_[k], first);
    const bool step = std::exchange(opposite_[k], rest ? 1 : 0) != 0;
    rest ^= step;
    k = above;
  }
  return {first, opposite};
}

bool AgreementSets::join(std::uint32_t a, std::uint32_t b, bool opposite) {
  const Place place_a = find(a), place_b = find(b);
  const bool between = place_a.opposite ^ place_b.opposite ^ opposite;
  if (place_a.first == place_b.first) return !between;
  // The lower number stands for the set, whatever the order of the joins.
  const auto [low, high] = std::minmax({place_a.first, place_b.first});
  parent_[high] = low;
  opposite_[high] = between ? 1 : 0;
  return true;
}

}  // namespace pulvis
