// SPDX-License-Identifier: Apache-2.0
#include "measures/disc_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measures/half_spaces.hpp"

namespace pulvis::measures {
namespace {

/// q(x,y) of the header for 0 <= x,y < 1.
double corner(double x, double y) {
  if (x * x + y * y >= 1.0) return 0.0;
  const double s_x = std::sqrt((1.0 - x) * (1.0 + x)), s_y = std::sqrt((1.0 - y) * (1.0 + y));
  const double phi = std::atan2(s_x * s_y - x * y, x * s_y + y * s_x);
  return 0.5 * (phi - x * (s_x - y) - y * (s_y - x));
}

}  // namespace

double disc_rectangle_area(const Disc& disc, const Rectangle& rectangle) {
  const double r = disc.radius;
  const double width_x = rectangle.max_x - rectangle.min_x, width_y = rectangle.max_y - rectangle.min_y;
  if (!(r > 0.0 && width_x > 0.0 && width_y > 0.0)) return 0.0;

  const double low_x = (rectangle.min_x - disc.x) / r, high_x = (rectangle.max_x - disc.x) / r;
  const double low_y = (rectangle.min_y - disc.y) / r, high_y = (rectangle.max_y - disc.y) / r;
  const double farthest_x = std::max(low_x * low_x, high_x * high_x);
  const double farthest_y = std::max(low_y * low_y, high_y * high_y);
  if (farthest_x + farthest_y <= 1.0) return width_x * width_y;

  const HalfSpaces along_x(low_x, high_x), along_y(low_y, high_y);
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(along_x.count); ++i)
    for (std::size_t j = 0; j < static_cast<std::size_t>(along_y.count); ++j)
      sum += along_x.weight[i] * along_y.weight[j] * corner(along_x.distance[i], along_y.distance[j]);
  return std::clamp(sum * r * r, 0.0, std::min(std::numbers::pi * r * r, width_x * width_y));
}

}  // namespace pulvis::measures
