// SPDX-License-Identifier: Apache-2.0
#include "measures/segregation.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "measures/cell_list.hpp"
#include "measures/sum.hpp"

namespace pulvis::measures {
namespace {

struct Member {
  Vec3 place{};  // m; in coordinates of the die
  double diameter = 0.0, mass = 0.0;
};

/// Mean diameters of the two halves of the mass, the lower first.
void compare_halves(Segregation& result, std::span<const Member> members) {
  const double mass = pairwise_sum(members.size(), [&](std::size_t i) { return members[i].mass; });
  if (!(mass > 0.0)) return;
  std::vector<Member> by_height(members.begin(), members.end());
  std::stable_sort(by_height.begin(), by_height.end(),
                   [](const Member& a, const Member& b) { return a.place.z < b.place.z; });
  // Diameters count from one of them, so that equal sizes give exactly zero.
  const double origin = by_height.front().diameter;
  double below = 0.0, low = 0.0, high = 0.0;  // mass below; sums of mass times diameter
  for (const Member& member : by_height) {
    const double lower = std::clamp(0.5 * mass - below, 0.0, member.mass);
    below += member.mass;
    low += lower * (member.diameter - origin);
    high += (member.mass - lower) * (member.diameter - origin);
  }
  result.mean_diameter = origin + (low + high) / mass;
  result.lower = origin + low / (0.5 * mass);
  result.upper = origin + high / (0.5 * mass);
  result.index = (high - low) / (0.5 * mass) / *result.mean_diameter;
}

void compare_cells(Segregation& result, std::span<const Member> members, const CellList& cells) {
  const std::size_t count = members.size();
  if (count == 0) return;
  const auto number = static_cast<double>(count);
  const double mean = pairwise_sum(count, [&](std::size_t i) { return members[i].diameter; }) / number;

  struct Cell {
    std::size_t spheres = 0;
    double off = 0.0;  // m; sum of diameter - mean
  };
  std::vector<Cell> found(cells.count());
  for (const Member& member : members) {
    Cell& cell = found[cells.at(member.place)];
    ++cell.spheres;
    cell.off += member.diameter - mean;
  }
  result.cells = static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [](const Cell& cell) { return cell.spheres > 0; }));
  result.of_spheres =
      pairwise_sum(count, [&](std::size_t i) { return square(members[i].diameter - mean); }) / number;
  result.of_cells = pairwise_sum(found.size(),
                                 [&](std::size_t c) {
                                   return found[c].spheres > 0
                                              ? square(found[c].off) / static_cast<double>(found[c].spheres)
                                              : 0.0;
                                 }) /
                    number;
  if (result.cells == count) return;
  result.at_random = result.of_spheres * static_cast<double>(result.cells - 1) / (number - 1.0);
  const bool equal = result.of_spheres <= square(1e-12 * mean);  // but for rounding
  result.intensity =
      equal ? 0.0
            : std::clamp((result.of_cells - result.at_random) / (result.of_spheres - result.at_random), 0.0,
                         1.0);
}

}  // namespace

Segregation segregation(std::span<const Sphere> spheres, std::span<const double> masses,
                        const Container& container, double cell_edge) {
  if (spheres.size() != masses.size())
    throw std::invalid_argument("segregation: there must be one mass for each sphere");
  check_spheres(spheres);
  const DieFrame frame(container);
  std::vector<Member> members;
  for (std::size_t i = 0; i < spheres.size(); ++i)
    if (is_inside(container, spheres[i].centre))
      members.push_back({frame.to_local(spheres[i].centre), 2.0 * spheres[i].radius, masses[i]});

  Segregation result;
  result.spheres = members.size();
  compare_halves(result, members);
  compare_cells(result, members, CellList(frame, cell_edge));
  return result;
}

}  // namespace pulvis::measures
