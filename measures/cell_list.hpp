// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "measures/container.hpp"
#include "measures/grid.hpp"
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Cells of the die and, for each, the spheres whose bounding box reaches into it, in ascending order. All in
/// coordinates of the die. Throws Failure for an edge that gives no grid or one with too many cells.
class CellList {
 public:
  CellList(const DieFrame& frame, double cell_edge);

  /// Sorts the spheres into the cells by counting: once for the sizes, once for the entries.
  void fill(std::span<const Sphere> local);

  std::size_t count() const { return begin_.size() - 1; }
  const Division& along(std::size_t axis) const { return along_[axis]; }
  std::span<const std::uint32_t> spheres(std::size_t cell) const {
    return std::span(entries_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
  }
  Box box(std::size_t cell) const;

  /// The cell a place lies in; places outside belong to the nearest.
  std::size_t at(const Vec3& local) const {
    return along_[0].at(local.x) +
           along_[0].count() * (along_[1].at(local.y) + along_[1].count() * along_[2].at(local.z));
  }

 private:
  template <class Visitor>
  void visit(const Sphere& sphere, const Visitor& visitor) const;

  std::array<Division, 3> along_;
  std::vector<std::size_t> begin_;      // of each cell's entries, and the end of the last
  std::vector<std::uint32_t> entries_;  // places of spheres
};

}  // namespace pulvis::measures
