// SPDX-License-Identifier: Apache-2.0
#include "measures/porosity.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "measures/below_surface.hpp"
#include "measures/cell_list.hpp"
#include "measures/parallel.hpp"
#include "measures/sphere_box.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

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
