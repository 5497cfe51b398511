// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/parcels/domain.hpp"

namespace pulvis {

/// Sorts points into cells of at least a given edge, so that all points within that edge of a point lie in
/// the 27 cells around its own. Cells are numbered x fastest: three neighbours along x are one range.
class CellGrid {
 public:
  /// Grid over `box` with edges of at least `edge` m, coarser where that would give far more cells than
  /// points. `position(k)` is the k-th point; it must lie in the box (points on its rim count as inside).
  template <class Position>
  void build(const Box& box, double edge, std::size_t count, Position&& position) {
    lay_out(box, edge, count);
    cell_of_.resize(count);
    for (std::size_t k = 0; k < count; ++k) cell_of_[k] = static_cast<std::uint32_t>(cell(position(k)));
    sort_into_cells(count);
  }

  int cells(int axis) const { return cells_[axis]; }
  std::size_t cell_at(const Vec3& place) const { return cell(place); }
  std::size_t cell_of(std::size_t point) const { return cell_of_[point]; }
  /// Points in order of their cells; those of cell c are [begin(c), begin(c + 1)).
  std::span<const std::uint32_t> order() const { return order_; }
  std::uint32_t begin(std::size_t cell) const { return begin_[cell]; }

  /// Calls visit(first, last) for ranges of order() that together hold every point near cell `c`, once each.
  template <class Visit>
  void for_ranges_around(std::size_t c, Visit&& visit) const {
    const int cx = static_cast<int>(c % nx()), cy = static_cast<int>(c / nx() % ny()),
              cz = static_cast<int>(c / (nx() * ny()));
    int ys[3], zs[3];
    const int y_count = neighbours(1, cy, ys), z_count = neighbours(2, cz, zs);
    for (int iz = 0; iz < z_count; ++iz)
      for (int iy = 0; iy < y_count; ++iy)
        visit_row((static_cast<std::size_t>(zs[iz]) * ny() + static_cast<std::size_t>(ys[iy])) * nx(), cx,
                  visit);
  }

  /// The same for what is not near cell `c` but within `reach` m of it.
  template <class Visit>
  void for_ranges_beyond(std::size_t c, double reach, Visit&& visit) const {
    const int at[3] = {static_cast<int>(c % nx()), static_cast<int>(c / nx() % ny()),
                       static_cast<int>(c / (nx() * ny()))};
    Along along[3];
    for (int axis = 0; axis < 3; ++axis) along[axis] = cells_within(axis, at[axis], reach);
    for (int iz = 0; iz < along[2].count; ++iz)
      for (int iy = 0; iy < along[1].count; ++iy) {
        const std::size_t row = (static_cast<std::size_t>(along[2].cell[iz]) * ny() +
                                 static_cast<std::size_t>(along[1].cell[iy])) *
                                nx();
        const bool near_row = along[2].near[iz] && along[1].near[iy];
        for (int from = 0, to = 0; from < along[0].count;
             from = to) {  // cells that follow each other at once
          const auto left_out = [&](int k) { return near_row && along[0].near[k]; };
          to = from + 1;
          if (left_out(from)) continue;
          while (to < along[0].count && !left_out(to) && along[0].cell[to] == along[0].cell[to - 1] + 1) ++to;
          visit(begin_[row + static_cast<std::size_t>(along[0].cell[from])],
                begin_[row + static_cast<std::size_t>(along[0].cell[to - 1]) + 1]);
        }
      }
  }
  static constexpr int farthest =
      7;  ///< cells that for_ranges_beyond goes at most: `reach` is up to so many edges

  /// The same in a box whose faces slide: what is near across one lies along the flow axis by the shift.
  template <class Visit>
  void for_ranges_around(std::size_t c, const Slide& slide, Visit&& visit) const {
    if (!slide.any()) return for_ranges_around(c, visit);
    const int at[3] = {static_cast<int>(c % nx()), static_cast<int>(c / nx() % ny()),
                       static_cast<int>(c / (nx() * ny()))};
    const int flow = slide.flow, gradient = slide.gradient, neutral = 3 - flow - gradient;
    int across[3], beside[3], cell[3];
    const int across_count = neighbours(gradient, at[gradient], across),
              beside_count = neighbours(neutral, at[neutral], beside);
    for (int ia = 0; ia < across_count; ++ia) {
      const auto [first, count] = cells_along(slide, at, across[ia]);
      cell[gradient] = across[ia];
      for (int along = 0; along < count; ++along) {
        cell[flow] = (first + along) % cells_[flow];
        for (int ib = 0; ib < beside_count; ++ib) {
          cell[neutral] = beside[ib];
          const std::size_t k =
              (static_cast<std::size_t>(cell[2]) * ny() + static_cast<std::size_t>(cell[1])) * nx() +
              static_cast<std::size_t>(cell[0]);
          visit(begin_[k], begin_[k + 1]);
        }
      }
    }
  }

 private:
  std::size_t nx() const { return static_cast<std::size_t>(cells_[0]); }
  std::size_t ny() const { return static_cast<std::size_t>(cells_[1]); }

  /// Cells along an axis, each once, and whether each is one of `neighbours`.
  struct Along {
    int count = 0;
    int cell[2 * farthest + 1];
    bool near[2 * farthest + 1];
  };
  Along cells_within(int axis, int c, double reach) const;
  void lay_out(const Box& box, double edge, std::size_t count);
  void sort_into_cells(std::size_t count);
  std::size_t cell(const Vec3& p) const;

  /// The cells along the flow axis that can be near the cell `at` in the layer `across`: first and number.
  std::pair<int, int> cells_along(const Slide& slide, const int (&at)[3], int across) const;

  /// Cells next to and including `c` along an axis, each once; returns how many.
  int neighbours(int axis, int c, int (&list)[3]) const {
    int count = 0;
    for (int d = -1; d <= 1; ++d) {
      int k = c + d;
      if (k < 0 || k >= cells_[axis]) {
        if (!periodic_[axis]) continue;
        k = (k + cells_[axis]) % cells_[axis];
      }
      bool seen = false;
      for (int i = 0; i < count; ++i) seen = seen || list[i] == k;
      if (!seen) list[count++] = k;
    }
    return count;
  }

  template <class Visit>
  void visit_row(std::size_t row, int cx, Visit& visit) const {
    if (cx > 0 && cx + 1 < cells_[0]) {
      visit(begin_[row + static_cast<std::size_t>(cx) - 1], begin_[row + static_cast<std::size_t>(cx) + 2]);
      return;
    }
    int xs[3];
    const int count = neighbours(0, cx, xs);
    for (int k = 0; k < count; ++k) {
      const std::size_t c = row + static_cast<std::size_t>(xs[k]);
      visit(begin_[c], begin_[c + 1]);
    }
  }

  Vec3 origin_, inverse_edge_;
  int cells_[3] = {1, 1, 1};
  bool periodic_[3] = {false, false, false};
  std::vector<std::uint32_t> cell_of_, begin_, order_;
};

}  // namespace pulvis
