// SPDX-License-Identifier: Apache-2.0
#include "measures/porosity_parts.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "measures/below_surface.hpp"
#include "measures/parallel.hpp"
#include "measures/sphere_box.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

/// Solid in a cell, m^3; 0 where it does not count.
double solid_of(const PorosityField& field, std::size_t cell) {
  const double volume = field.counted_volume[cell];
  return volume > 0.0 ? (1.0 - field.values[cell]) * volume : 0.0;
}

/// Place of a cell along each axis.
std::array<std::size_t, 3> place_of(const PorosityField& field, std::size_t cell) {
  const std::size_t rest = cell / field.cells[0];
  return {cell % field.cells[0], rest % field.cells[1], rest / field.cells[1]};
}

double middle(const PorosityField& field, std::size_t axis, std::size_t layer) {
  return (static_cast<double>(layer) + 0.5) * field.spacing[static_cast<int>(axis)];
}

/// Whether a cell's middle lies in the part, up to rounding.
bool has_middle_in(const PorosityField& field, std::size_t cell, const Box& part) {
  const auto place = place_of(field, cell);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int a = static_cast<int>(axis);
    const double at = middle(field, axis, place[axis]), margin = 1e-9 * field.spacing[a];
    if (at < part.min[a] - margin || at > part.max[a] + margin) return false;
  }
  return true;
}

std::optional<double> spread_in(const PorosityField& field, const Box& part) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < field.values.size(); ++cell)
    if (field.counted_volume[cell] > 0.0 && has_middle_in(field, cell, part)) cells.push_back(cell);
  if (cells.empty()) return {};
  const auto sum = [&](const auto& term) {
    return pairwise_sum(cells.size(), [&](std::size_t i) { return term(cells[i]); });
  };
  const double volume = sum([&](std::size_t c) { return field.counted_volume[c]; });
  const double mean = sum([&](std::size_t c) { return field.counted_volume[c] * field.values[c]; }) / volume;
  const double square_sum =
      sum([&](std::size_t c) { return field.counted_volume[c] * square(field.values[c] - mean); });
  return std::sqrt(square_sum / volume);
}

Box common(const Box& a, const Box& b) {
  Box both;
  for (int axis = 0; axis < 3; ++axis) {
    both.min[axis] = greatest(a.min[axis], b.min[axis]);
    both.max[axis] = least(a.max[axis], b.max[axis]);
  }
  return both;
}

bool is_empty(const Box& box) {
  return !(box.min.x < box.max.x && box.min.y < box.max.y && box.min.z < box.max.z);
}

/// Volume that a sphere shares with the part below the surface: only the columns it reaches are asked.
double shared_volume(const Sphere& sphere, const Box& part, const FreeSurface& surface) {
  const double reach = sphere.radius * (1.0 + 1e-6);  // wholly inside in spite of rounding
  const Vec3 arm{reach, reach, reach};
  const Box around = common({sphere.centre - arm, sphere.centre + arm}, part);
  if (is_empty(around)) return 0.0;
  std::vector<Box> pieces;
  find_pieces(around, surface, pieces);
  double volume = 0.0;
  for (const Box& piece : pieces) volume += sphere_box_volume(sphere, piece);
  return volume;
}

}  // namespace

std::array<PorosityProfile, 3> porosity_profiles(const PorosityField& field) {
  std::array<PorosityProfile, 3> profiles;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    PorosityProfile& profile = profiles[axis];
    profile.volume.assign(field.cells[axis], 0.0);
    std::vector<double> solid(field.cells[axis], 0.0);
    for (std::size_t cell = 0; cell < field.values.size(); ++cell) {
      const std::size_t layer = place_of(field, cell)[axis];
      profile.volume[layer] += field.counted_volume[cell];
      solid[layer] += solid_of(field, cell);
    }
    for (std::size_t layer = 0; layer < field.cells[axis]; ++layer) {
      const double volume = profile.volume[layer];
      profile.position.push_back(middle(field, axis, layer));
      profile.porosity.push_back(volume > 0.0 ? 1.0 - solid[layer] / volume
                                              : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return profiles;
}

PorosityHistogram porosity_histogram(const PorosityField& field, double width) {
  if (!(width >= 1e-6 && width <= 1e6))
    throw std::invalid_argument("porosity_histogram: the width must be in [1e-6, 1e6]");
  const auto bin = [&](double value) { return std::floor(value / width); };
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (std::size_t cell = 0; cell < field.values.size(); ++cell)
    if (field.counted_volume[cell] > 0.0) {
      lowest = least(lowest, bin(field.values[cell]));
      highest = greatest(highest, bin(field.values[cell]));
    }
  PorosityHistogram histogram;
  if (!(lowest <= highest)) return histogram;

  histogram.share.assign(static_cast<std::size_t>(highest - lowest) + 1, 0.0);
  for (std::size_t i = 0; i <= histogram.share.size(); ++i)
    histogram.edges.push_back((lowest + static_cast<double>(i)) * width);
  for (std::size_t cell = 0; cell < field.values.size(); ++cell)
    if (const double volume = field.counted_volume[cell]; volume > 0.0)
      histogram.share[static_cast<std::size_t>(bin(field.values[cell]) - lowest)] +=
          volume / field.total_volume;
  return histogram;
}

std::array<Part, 6> halves(const Container& container) {
  const Vec3 size = DieFrame(container).size();
  std::array<Part, 6> parts{{{"lower half", {{}, size}},
                             {"upper half", {{}, size}},
                             {"first lower half", {{}, size}},
                             {"first upper half", {{}, size}},
                             {"second lower half", {{}, size}},
                             {"second upper half", {{}, size}}}};
  const std::array<int, 3> axis_of{2, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = axis_of[i];
    parts[2 * i].box.max[axis] = parts[2 * i + 1].box.min[axis] = 0.5 * size[axis];
  }
  return parts;
}

PartPorosity part_porosity(std::span<const Sphere> spheres, std::span<const double> masses,
                           const FreeSurface& surface, const Container& container, const PorosityField& field,
                           const Box& part) {
  if (!masses.empty() && masses.size() != spheres.size())
    throw std::invalid_argument("part_porosity: there must be one mass for each sphere, or none");
  check_spheres(spheres);
  const DieFrame frame(container);
  check_surface(surface, frame);
  if (!(field.origin == frame.origin() && field.axes == frame.axes()))
    throw std::invalid_argument("part_porosity: the field is that of another die");

  PartPorosity result;
  const Box box = common(part, {{}, frame.size()});
  if (is_empty(box)) return result;
  std::vector<Box> pieces;
  find_pieces(box, surface, pieces);
  result.volume = pairwise_sum(pieces.size(), [&](std::size_t i) { return frame.volume_inside(pieces[i]); });

  const std::vector<Sphere> local = spheres_in_die(spheres, frame);
  std::vector<double> shared(local.size());
  parallel_for(local.size(), [&](std::size_t i) { shared[i] = shared_volume(local[i], box, surface); });
  result.solid = pairwise_sum(shared.size(), [&](std::size_t i) { return shared[i]; });
  if (!masses.empty())
    result.mass = pairwise_sum(shared.size(), [&](std::size_t i) {
      return shared[i] > 0.0 ? masses[i] * shared[i] / sphere_volume(local[i].radius) : 0.0;
    });

  result.standard_deviation = spread_in(field, box);
  if (result.volume > 0.0) {
    result.porosity = 1.0 - result.solid / result.volume;
    result.density = result.mass / result.volume;
  }
  return result;
}

std::vector<std::uint8_t> centres_in_part(std::span<const Sphere> spheres, const Container& container,
                                          const Box& part) {
  const DieFrame frame(container);
  std::vector<std::uint8_t> inside(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (!is_inside(container, spheres[i].centre)) continue;
    const Vec3 at = frame.to_local(spheres[i].centre);
    bool in_part = true;
    for (int axis = 0; axis < 3; ++axis) {
      // The die's own end belongs to the part that ends there.
      const bool below = at[axis] < part.max[axis] || part.max[axis] >= frame.size()[axis];
      const bool above = at[axis] >= part.min[axis] || part.min[axis] <= 0.0;
      in_part = in_part && below && above;
    }
    inside[i] = in_part ? 1 : 0;
  }
  return inside;
}

}  // namespace pulvis::measures
