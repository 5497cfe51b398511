// SPDX-License-Identifier: Apache-2.0
#include "measures/cell_list.hpp"

#include <numeric>

#include "engine/base/failure.hpp"

namespace pulvis::measures {

CellList::CellList(const DieFrame& frame, double cell_edge)
    : along_{Division(frame.size().x, cell_edge), Division(frame.size().y, cell_edge),
             Division(frame.size().z, cell_edge)} {
  std::size_t count = 1;
  for (const Division& division : along_) {
    count *= division.count();  // at most 1e6 each and checked in between: no overflow
    if (count > most_cells) throw Failure(Exit::bad_case, "the grid of cells would have too many cells");
  }
  begin_.assign(count + 1, 0);
}

void CellList::fill(std::span<const Sphere> local) {
  for (const Sphere& sphere : local) visit(sphere, [&](std::size_t cell) { ++begin_[cell + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  entries_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < local.size(); ++i)
    visit(local[i], [&](std::size_t cell) { entries_[next[cell]++] = static_cast<std::uint32_t>(i); });
}

Box CellList::box(std::size_t cell) const {
  const std::size_t i = cell % along_[0].count(), rest = cell / along_[0].count();
  const std::size_t j = rest % along_[1].count(), k = rest / along_[1].count();
  return {{along_[0].edge(i), along_[1].edge(j), along_[2].edge(k)},
          {along_[0].edge(i + 1), along_[1].edge(j + 1), along_[2].edge(k + 1)}};
}

template <class Visitor>
void CellList::visit(const Sphere& sphere, const Visitor& visitor) const {
  const double r = sphere.radius;
  std::array<std::size_t, 3> first{}, last{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double centre = sphere.centre[static_cast<int>(a)];
    if (!(centre + r > 0.0 && centre - r < along_[a].edge(along_[a].count()))) return;
    first[a] = along_[a].at(centre - r);
    last[a] = along_[a].at(centre + r);
  }
  for (std::size_t k = first[2]; k <= last[2]; ++k)
    for (std::size_t j = first[1]; j <= last[1]; ++j)
      for (std::size_t i = first[0]; i <= last[0]; ++i)
        visitor(i + along_[0].count() * (j + along_[1].count() * k));
}

}  // namespace pulvis::measures
