// SPDX-License-Identifier: Apache-2.0
#include "engine/contacts/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace pulvis {

void CellGrid::lay_out(const Box& box, double edge, std::size_t count) {
  // A mostly empty box needs no more cells than a few per point.
  const Vec3 extent = box.extent();
  const double most = 4.0 * static_cast<double>(count) + 4096.0;
  const double volume = extent.x * extent.y * extent.z;
  edge = std::max(edge, std::cbrt(volume / most));
  origin_ = box.min;
  for (int axis = 0; axis < 3; ++axis) {
    cells_[axis] = std::max(1, static_cast<int>(std::min(extent[axis] / edge, 1e6)));
    inverse_edge_[axis] = cells_[axis] / extent[axis];
    periodic_[axis] = box.periodic[axis];
  }
}

std::size_t CellGrid::cell(const Vec3& p) const {
  std::size_t index[3];
  for (int axis = 0; axis < 3; ++axis) {
    const int k = static_cast<int>((p[axis] - origin_[axis]) * inverse_edge_[axis]);
    index[axis] = static_cast<std::size_t>(std::clamp(k, 0, cells_[axis] - 1));
  }
  return (index[2] * ny() + index[1]) * nx() + index[0];
}

std::pair<int, int> CellGrid::cells_along(const Slide& slide, const int (&at)[3], int across) const {
  const int all = cells_[slide.flow], step = across - at[slide.gradient];
  // With fewer than three layers one layer is near through the box and through a face at once.
  if (all <= 4 || cells_[slide.gradient] < 3) return {0, all};
  double shift = 0.0;  // of the images in that layer, in cells
  if (step < -1) shift = slide.shift * inverse_edge_[slide.flow];
  if (step > 1) shift = -slide.shift * inverse_edge_[slide.flow];
  const int first = at[slide.flow] - 1 - static_cast<int>(std::ceil(shift));
  return {((first % all) + all) % all, shift == 0.0 ? 3 : 4};
}

CellGrid::Along CellGrid::cells_within(int axis, int c, double reach) const {
  const int far = std::min(farthest, static_cast<int>(std::ceil(reach * inverse_edge_[axis])));
  const int all = cells_[axis];
  Along along;
  const auto put = [&](int k) {
    const int off = std::abs(k - c);
    along.cell[along.count] = k;
    along.near[along.count++] = off <= 1 || (periodic_[axis] && off == all - 1);
  };
  if (2 * far + 1 >= all)
    for (int k = 0; k < all; ++k) put(k);
  else
    for (int k = c - far; k <= c + far; ++k) {
      if (k >= 0 && k < all)
        put(k);
      else if (periodic_[axis])
        put((k + all) % all);
    }
  return along;
}

void CellGrid::sort_into_cells(std::size_t count) {
  const std::size_t cell_count = nx() * ny() * static_cast<std::size_t>(cells_[2]);
  begin_.assign(cell_count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) ++begin_[cell_of_[k] + 1];
  for (std::size_t c = 0; c < cell_count; ++c) begin_[c + 1] += begin_[c];
  order_.resize(count);
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t k = 0; k < count; ++k) order_[next[cell_of_[k]]++] = static_cast<std::uint32_t>(k);
}

}  // namespace pulvis
