// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "measures/grid.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Finds the items near a point, by cells at least as wide as the reach over the box around all points that
/// may be asked about; items out of reach of that box are dropped.
class NearPoints {
 public:
  /// All in metres. No points: nothing will be near.
  NearPoints(std::span<const Vec3> items, std::span<const Vec3> points, double reach);

  /// Calls visitor(place of the item) for all items within the reach of one of the points, and for some
  /// beyond it; always in the same order.
  template <class Visitor>
  void near(const Vec3& point, const Visitor& visitor) const {
    if (begin_.empty()) return;
    std::array<std::size_t, 3> low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t at = along_[a].at(point[static_cast<int>(a)] - origin_[static_cast<int>(a)]);
      low[a] = at == 0 ? 0 : at - 1;
      high[a] = std::min(at + 1, along_[a].count() - 1);
    }
    for (std::size_t k = low[2]; k <= high[2]; ++k)
      for (std::size_t j = low[1]; j <= high[1]; ++j) {
        const std::size_t row = along_[0].count() * (j + along_[1].count() * k);
        for (std::size_t e = begin_[row + low[0]]; e < begin_[row + high[0] + 1]; ++e) visitor(entries_[e]);
      }
  }

 private:
  std::size_t cell_of(const Vec3& place) const;

  Vec3 origin_;
  std::array<Division, 3> along_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> entries_;
};

}  // namespace pulvis::measures
