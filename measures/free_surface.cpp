// SPDX-License-Identifier: Apache-2.0
#include "measures/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "engine/base/failure.hpp"
#include "measures/clusters.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

Box column_of(const FreeSurface& surface, std::size_t column, double height) {
  const Division &first = surface.along_first, &second = surface.along_second;
  const std::size_t i = column % first.count(), j = column / first.count();
  return {{first.edge(i), second.edge(j), 0.0}, {first.edge(i + 1), second.edge(j + 1), height}};
}

void make_columns(FreeSurface& surface, const DieFrame& frame, double column_edge) {
  surface.along_first = Division(frame.size().x, column_edge);
  surface.along_second = Division(frame.size().y, column_edge);
  const std::size_t count = surface.along_first.count() * surface.along_second.count();
  if (count > most_cells) throw Failure(Exit::bad_case, "the free surface would have too many columns");

  surface.heights.assign(count, 0.0);
  surface.areas.reserve(count);
  for (std::size_t column = 0; column < count; ++column)
    surface.areas.push_back(frame.area_inside(column_of(surface, column, 0.0)));
}

/// Area of a column, 0 if it is left out. At the side wall of a cylinder a column may be too thin to hold the
/// centre of any sphere; its height, the floor, says nothing: columns with less than half inside are left out,
/// like cells.
double weight_of(const FreeSurface& surface, std::size_t column) {
  const double half_a_column = 0.5 * (1.0 - 1e-9) * surface.along_first.part() * surface.along_second.part();
  return surface.areas[column] < half_a_column ? 0.0 : surface.areas[column];
}

/// Slopes of the plane of least squares, from the moments about the mean (Cramer's rule).
void fit_plane(FreeSurface& surface, double area) {
  const auto middle = [&](std::size_t column) {
    const Box box = column_of(surface, column, 0.0);
    return 0.5 * (box.min + box.max);
  };
  const auto mean = [&](const auto& term) {
    return pairwise_sum(surface.heights.size(),
                        [&](std::size_t c) { return weight_of(surface, c) * term(c); }) /
           area;
  };
  const double x0 = mean([&](std::size_t c) { return middle(c).x; });
  const double y0 = mean([&](std::size_t c) { return middle(c).y; });
  const auto x = [&](std::size_t c) { return middle(c).x - x0; };
  const auto y = [&](std::size_t c) { return middle(c).y - y0; };
  const auto h = [&](std::size_t c) { return surface.heights[c] - surface.mean; };
  const double xx = mean([&](std::size_t c) { return x(c) * x(c); });
  const double xy = mean([&](std::size_t c) { return x(c) * y(c); });
  const double yy = mean([&](std::size_t c) { return y(c) * y(c); });
  const double xh = mean([&](std::size_t c) { return x(c) * h(c); });
  const double yh = mean([&](std::size_t c) { return y(c) * h(c); });
  const bool wide = surface.along_first.count() > 1, deep = surface.along_second.count() > 1;
  if (wide && deep) {
    const double determinant = xx * yy - xy * xy;
    surface.slope_first = (xh * yy - yh * xy) / determinant;
    surface.slope_second = (yh * xx - xh * xy) / determinant;
  } else if (wide) {
    surface.slope_first = xh / xx;
  } else if (deep) {
    surface.slope_second = yh / yy;
  }
  surface.tilt = std::atan(std::hypot(surface.slope_first, surface.slope_second));
}

void find_statistics(FreeSurface& surface) {
  const auto weight = [&](std::size_t i) { return weight_of(surface, i); };
  const std::vector<double>& heights = surface.heights;
  const std::size_t count = heights.size();
  const double area = pairwise_sum(count, weight);
  surface.mean = pairwise_sum(count, [&](std::size_t i) { return weight(i) * heights[i]; }) / area;
  const double square_sum =
      pairwise_sum(count, [&](std::size_t i) { return weight(i) * square(heights[i] - surface.mean); });
  surface.roughness = std::sqrt(square_sum / area);
  fit_plane(surface, area);
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

double filled_volume(const FreeSurface& surface, const Container& container) {
  const DieFrame frame(container);
  check_surface(surface, frame);
  const std::size_t count = surface.heights.size();
  const auto capped = [&](std::size_t c) { return least(surface.heights[c], frame.size().z); };
  const auto weight = [&](std::size_t c) { return weight_of(surface, c); };
  const double mean =
      pairwise_sum(count, [&](std::size_t c) { return weight(c) * capped(c); }) / pairwise_sum(count, weight);
  return pairwise_sum(count, [&](std::size_t c) {
    return frame.volume_inside(column_of(surface, c, weight(c) > 0.0 ? capped(c) : mean));
  });
}

void check_surface(const FreeSurface& surface, const DieFrame& frame) {
  const Division &first = surface.along_first, &second = surface.along_second;
  const bool fits = surface.heights.size() == first.count() * second.count() && !surface.heights.empty() &&
                    first.edge(first.count()) == frame.size().x &&
                    second.edge(second.count()) == frame.size().y;
  if (!fits) throw std::invalid_argument("the free surface is that of another die");
}

}  // namespace pulvis::measures
