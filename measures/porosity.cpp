// SPDX-License-Identifier: Apache-2.0
#include "measures/porosity.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "engine/base/failure.hpp"
#include "measures/parallel.hpp"
#include "measures/sphere_box.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

/// Cells of the die and, for each, the spheres whose bounding box reaches into it, in ascending order.
class CellList {
 public:
  CellList(const DieFrame& frame, double cell_edge)
      : along_{Division(frame.size().x, cell_edge), Division(frame.size().y, cell_edge),
               Division(frame.size().z, cell_edge)} {
    std::size_t count = 1;
    for (const Division& division : along_) {
      count *= division.count();  // at most 1e6 each and checked in between: no overflow
      if (count > most_cells) throw Failure(Exit::bad_case, "the porosity grid would have too many cells");
    }
    begin_.assign(count + 1, 0);
  }

  /// Sorts the spheres into the cells by counting: once for the sizes, once for the entries.
  void fill(std::span<const Sphere> local) {
    for (const Sphere& sphere : local) visit(sphere, [&](std::size_t cell) { ++begin_[cell + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    entries_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < local.size(); ++i)
      visit(local[i], [&](std::size_t cell) { entries_[next[cell]++] = static_cast<std::uint32_t>(i); });
  }

  std::size_t count() const { return begin_.size() - 1; }
  const Division& along(std::size_t axis) const { return along_[axis]; }
  std::span<const std::uint32_t> spheres(std::size_t cell) const {
    return std::span(entries_).subspan(begin_[cell], begin_[cell + 1] - begin_[cell]);
  }

  Box box(std::size_t cell) const {
    const std::size_t i = cell % along_[0].count(), rest = cell / along_[0].count();
    const std::size_t j = rest % along_[1].count(), k = rest / along_[1].count();
    return {{along_[0].edge(i), along_[1].edge(j), along_[2].edge(k)},
            {along_[0].edge(i + 1), along_[1].edge(j + 1), along_[2].edge(k + 1)}};
  }

 private:
  template <class Visitor>
  void visit(const Sphere& sphere, const Visitor& visitor) const {
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

  std::array<Division, 3> along_;
  std::vector<std::size_t> begin_;      // of each cell's entries, and the end of the last
  std::vector<std::uint32_t> entries_;  // places of spheres
};

/// The part of a cell below the free surface, as boxes: one for each column that is not empty there.
/// Deep in the bed that is the cell itself.
void find_pieces(const Box& cell, const FreeSurface& surface, std::vector<Box>& pieces) {
  pieces.clear();
  const Division &first = surface.along_first, &second = surface.along_second;
  bool all_below = true;
  for (std::size_t j = second.at(cell.min.y); j <= second.at(cell.max.y); ++j)
    for (std::size_t i = first.at(cell.min.x); i <= first.at(cell.max.x); ++i) {
      const double height = surface.height(i, j);
      const Box piece{{greatest(cell.min.x, first.edge(i)), greatest(cell.min.y, second.edge(j)), cell.min.z},
                      {least(cell.max.x, first.edge(i + 1)), least(cell.max.y, second.edge(j + 1)),
                       least(cell.max.z, height)}};
      // Cell and column may share an edge and nothing else: such a column has no say.
      if (!(piece.min.x < piece.max.x && piece.min.y < piece.max.y)) continue;
      all_below = all_below && height >= cell.max.z;
      if (piece.min.z < piece.max.z) pieces.push_back(piece);
    }
  if (all_below) pieces.assign(1, cell);
}

struct CellContent {
  double volume = 0.0, solid = 0.0;  // m^3
};

CellContent measure_cell(const Box& cell, std::span<const std::uint32_t> inside,
                         std::span<const Sphere> local, const FreeSurface& surface, const DieFrame& frame) {
  std::vector<Box> pieces;
  find_pieces(cell, surface, pieces);
  CellContent content;
  for (const Box& piece : pieces) {
    content.volume += frame.volume_inside(piece);
    for (const std::uint32_t i : inside) content.solid += sphere_box_volume(local[i], piece);
  }
  return content;
}

/// Spheres in coordinates of the die, without those that are outside its side wall.
std::vector<Sphere> spheres_in_die(std::span<const Sphere> spheres, const DieFrame& frame) {
  std::vector<Sphere> local;
  local.reserve(spheres.size());
  for (const Sphere& sphere : spheres) {
    const Vec3 centre = frame.to_local(sphere.centre);
    if (frame.within_side_wall(centre)) local.push_back({centre, sphere.radius});
  }
  return local;
}

void check_surface(const FreeSurface& surface, const DieFrame& frame) {
  const Division &first = surface.along_first, &second = surface.along_second;
  const bool fits = surface.heights.size() == first.count() * second.count() && !surface.heights.empty() &&
                    first.edge(first.count()) == frame.size().x &&
                    second.edge(second.count()) == frame.size().y;
  if (!fits) throw std::invalid_argument("porosity: the free surface is that of another die");
}

/// Mean and spread over the cells that count, from the totals on.
void find_statistics(PorosityField& field, std::span<const double> solid) {
  const std::vector<double>& weight = field.counted_volume;
  const std::size_t count = weight.size();
  field.total_volume = pairwise_sum(count, [&](std::size_t c) { return weight[c]; });
  field.total_solid = pairwise_sum(count, [&](std::size_t c) { return solid[c]; });
  if (!(field.total_volume > 0.0)) return;

  const double mean = 1.0 - field.total_solid / field.total_volume;
  const double square_sum = pairwise_sum(count, [&](std::size_t c) {
    return weight[c] > 0.0 ? weight[c] * square(field.values[c] - mean) : 0.0;
  });
  field.mean = mean;
  field.standard_deviation = std::sqrt(square_sum / field.total_volume);
}

}  // namespace

PorosityField porosity(std::span<const Sphere> spheres, const FreeSurface& surface,
                       const Container& container, double cell_edge) {
  check_spheres(spheres);
  const DieFrame frame(container);
  check_surface(surface, frame);
  const std::vector<Sphere> local = spheres_in_die(spheres, frame);
  CellList grid(frame, cell_edge);
  grid.fill(local);

  PorosityField field;
  field.origin = frame.origin();
  field.axes = frame.axes();
  field.spacing = {grid.along(0).part(), grid.along(1).part(), grid.along(2).part()};
  field.cells = {grid.along(0).count(), grid.along(1).count(), grid.along(2).count()};
  field.values.assign(grid.count(), std::numeric_limits<double>::quiet_NaN());
  field.counted_volume.assign(grid.count(), 0.0);
  std::vector<double> solid(grid.count(), 0.0);

  // A cell of which exactly half counts must not depend on the last bit of its volume, hence the margin.
  const double half_a_cell = 0.5 * (1.0 - 1e-9) * field.spacing.x * field.spacing.y * field.spacing.z;
  parallel_for(grid.count(), [&](std::size_t cell) {
    const CellContent content = measure_cell(grid.box(cell), grid.spheres(cell), local, surface, frame);
    if (content.volume < half_a_cell) return;
    field.counted_volume[cell] = content.volume;
    field.values[cell] = 1.0 - content.solid / content.volume;
    solid[cell] = content.solid;
  });
  find_statistics(field, solid);
  return field;
}

double solid_fraction_in_box(std::span<const Sphere> spheres, const Box& box) {
  const Vec3 width = box.max - box.min;
  if (!(width.x > 0.0 && width.y > 0.0 && width.z > 0.0))
    throw std::invalid_argument("solid_fraction_in_box: the box is empty");
  const double solid =
      pairwise_sum(spheres.size(), [&](std::size_t i) { return sphere_box_volume(spheres[i], box); });
  return solid / (width.x * width.y * width.z);
}

}  // namespace pulvis::measures
