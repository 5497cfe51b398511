// SPDX-License-Identifier: Apache-2.0
#include "measures/cell_joining.hpp"

#include <functional>
#include <queue>
#include <utility>

namespace pulvis::measures {
namespace {

/// The groups as they grow. A group is named by one of its cells; its cells form a ring.
class Groups {
 public:
  explicit Groups(const std::vector<SurfaceCell>& cells) : cells_(cells) {
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      group_.push_back(c);
      next_.push_back(c);
      area_.push_back(cells[c].area);
    }
  }

  std::uint32_t of(std::uint32_t cell) const { return group_[cell]; }
  double area(std::uint32_t group) const { return area_[group]; }

  /// The group with the largest area that has a face in common with this one, or none.
  std::uint32_t best_neighbour(std::uint32_t group) const {
    std::uint32_t best = SurfaceCell::none;
    for_cells(group, [&](std::uint32_t cell) {
      for (const std::uint32_t neighbour : cells_[cell].neighbours) {
        if (neighbour == SurfaceCell::none || group_[neighbour] == group) continue;
        const std::uint32_t other = group_[neighbour];
        if (best == SurfaceCell::none || area_[other] > area_[best]) best = other;
      }
    });
    return best;
  }

  std::uint32_t nearest(std::uint32_t group) const {
    std::uint32_t best = SurfaceCell::none;
    double least_distance = 0.0;
    for_cells(group, [&](std::uint32_t cell) {
      for (std::uint32_t other = 0; other < cells_.size(); ++other) {
        const double distance = norm(cells_[other].centre - cells_[cell].centre);
        if (group_[other] == group || (best != SurfaceCell::none && distance >= least_distance)) continue;
        best = group_[other];
        least_distance = distance;
      }
    });
    return best;
  }

  /// Returns the group that both are then.
  std::uint32_t join(std::uint32_t a, std::uint32_t b) {
    if (area_[a] < area_[b]) std::swap(a, b);  // so that seldom many cells change their group
    for_cells(b, [&](std::uint32_t cell) { group_[cell] = a; });
    std::swap(next_[a], next_[b]);  // makes two rings one
    area_[a] += area_[b];
    return a;
  }

 private:
  template <class Visit>
  void for_cells(std::uint32_t group, const Visit& visit) const {
    std::uint32_t cell = group;
    do {
      visit(cell);
      cell = next_[cell];
    } while (cell != group);
  }

  const std::vector<SurfaceCell>& cells_;
  std::vector<std::uint32_t> group_, next_;  // by cell
  std::vector<double> area_;                 // by group
};

std::vector<std::uint32_t> numbered(const Groups& groups, std::size_t cells) {
  std::vector<std::uint32_t> number(cells, SurfaceCell::none), of_cell(cells);
  std::uint32_t next = 0;
  for (std::uint32_t c = 0; c < cells; ++c) {
    std::uint32_t& mine = number[groups.of(c)];
    if (mine == SurfaceCell::none) mine = next++;
    of_cell[c] = mine;
  }
  return of_cell;
}

}  // namespace

std::vector<std::uint32_t> join_cells(const std::vector<SurfaceCell>& cells, double least) {
  Groups groups(cells);
  using Entry = std::pair<double, std::uint32_t>;  // area, group
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> small;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    if (cells[c].area < least) small.push({cells[c].area, c});
  while (!small.empty()) {
    const auto [area, group] = small.top();
    small.pop();
    if (groups.of(group) != group || groups.area(group) != area) continue;  // joined since
    std::uint32_t other = groups.best_neighbour(group);
    if (other == SurfaceCell::none) other = groups.nearest(group);
    if (other == SurfaceCell::none) break;  // all cells are one group
    const std::uint32_t joined = groups.join(group, other);
    if (groups.area(joined) < least) small.push({groups.area(joined), joined});
  }
  return numbered(groups, cells.size());
}

}  // namespace pulvis::measures
