// SPDX-License-Identifier: Apache-2.0
#include "measures/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/base/failure.hpp"
#include "measures/clusters.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

void make_columns(FreeSurface& surface, const DieFrame& frame, double column_edge) {
  surface.along_first = Division(frame.size().x, column_edge);
  surface.along_second = Division(frame.size().y, column_edge);
  const std::size_t count = surface.along_first.count() * surface.along_second.count();
  if (count > most_cells) throw Failure(Exit::bad_case, "the free surface would have too many columns");

  surface.heights.assign(count, 0.0);
  surface.areas.reserve(count);
  for (std::size_t j = 0; j < surface.along_second.count(); ++j)
    for (std::size_t i = 0; i < surface.along_first.count(); ++i) {
      const Box column{{surface.along_first.edge(i), surface.along_second.edge(j), 0.0},
                       {surface.along_first.edge(i + 1), surface.along_second.edge(j + 1), 0.0}};
      surface.areas.push_back(frame.area_inside(column));
    }
}

/// Mean and roughness. At the side wall of a cylinder a column may be too thin to hold the centre of any
/// sphere; its height, the floor, says nothing: columns with less than half inside are left out, like cells.
void find_statistics(FreeSurface& surface) {
  const double half_a_column = 0.5 * (1.0 - 1e-9) * surface.along_first.part() * surface.along_second.part();
  const std::vector<double>& heights = surface.heights;
  const auto weight = [&](std::size_t i) {
    return surface.areas[i] < half_a_column ? 0.0 : surface.areas[i];
  };
  const std::size_t count = heights.size();
  const double area = pairwise_sum(count, weight);
  surface.mean = pairwise_sum(count, [&](std::size_t i) { return weight(i) * heights[i]; }) / area;
  const double square_sum =
      pairwise_sum(count, [&](std::size_t i) { return weight(i) * square(heights[i] - surface.mean); });
  surface.roughness = std::sqrt(square_sum / area);
}

}  // namespace

FreeSurface free_surface(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                         const Container& container, double column_edge) {
  check_spheres(spheres);
  const DieFrame frame(container);
  FreeSurface surface;
  make_columns(surface, frame, column_edge);

  std::vector<std::uint8_t> in_die(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i)
    in_die[i] = frame.inside_or_above(frame.to_local(spheres[i].centre)) ? 1 : 0;
  const std::vector<std::uint32_t> bed = largest_cluster(contacts, in_die);
  surface.cluster_size = bed.size();

  for (const std::uint32_t i : bed) {
    const Vec3 centre = frame.to_local(spheres[i].centre);
    const std::size_t column =
        surface.along_first.at(centre.x) + surface.along_second.at(centre.y) * surface.along_first.count();
    surface.heights[column] = std::max(surface.heights[column], centre.z + spheres[i].radius);
  }
  find_statistics(surface);
  return surface;
}

}  // namespace pulvis::measures
