// SPDX-License-Identifier: Apache-2.0
#include "measures/coordination.hpp"

#include <stdexcept>

#include "measures/clusters.hpp"

namespace pulvis::measures {
namespace {

std::optional<double> ratio(std::size_t sum, std::size_t count) {
  if (count == 0) return {};
  return static_cast<double>(sum) / static_cast<double>(count);
}

}  // namespace

Coordination coordination(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts, const Container& container) {
  std::vector<std::uint8_t> in_die(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i)
    in_die[i] = is_inside(container, spheres[i].centre) ? 1 : 0;
  return coordination(in_die, contacts, wall_contacts);
}

Coordination coordination(std::span<const std::uint8_t> counted, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts) {
  check_contacts(contacts, counted.size());
  std::vector<std::uint32_t> touched(counted.size(), 0), walls(counted.size(), 0);
  for (const Contact& contact : contacts) {
    ++touched[contact.first];
    ++touched[contact.second];
  }
  for (const std::uint32_t i : wall_contacts) {
    if (i >= counted.size()) throw std::out_of_range("a wall contact names a sphere that does not exist");
    ++walls[i];
  }

  // Counts are whole numbers: no order of summing can change them.
  Coordination result;
  std::size_t total = 0, total_walls = 0, total_of_rattlers = 0;
  for (std::size_t i = 0; i < counted.size(); ++i) {
    if (counted[i] == 0) continue;
    ++result.spheres;
    total += touched[i];
    total_walls += walls[i];
    if (touched[i] >= result.histogram.size()) result.histogram.resize(touched[i] + std::size_t{1}, 0);
    ++result.histogram[touched[i]];
    if (touched[i] + walls[i] >= rattler_contacts) continue;
    ++result.rattlers;
    total_of_rattlers += touched[i] + walls[i];
  }
  result.mean = ratio(total, result.spheres);
  result.mean_walls = ratio(total_walls, result.spheres);
  result.rattler_share = ratio(result.rattlers, result.spheres);
  result.mean_without_rattlers =
      ratio(total + total_walls - total_of_rattlers, result.spheres - result.rattlers);
  return result;
}

}  // namespace pulvis::measures
