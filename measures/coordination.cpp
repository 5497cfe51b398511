// SPDX-License-Identifier: Apache-2.0
#include "measures/coordination.hpp"

#include <stdexcept>

#include "measures/clusters.hpp"

namespace pulvis::measures {

Coordination coordination(std::span<const Sphere> spheres, std::span<const Contact> contacts,
                          std::span<const std::uint32_t> wall_contacts, const Container& container) {
  check_contacts(contacts, spheres.size());
  std::vector<std::uint32_t> touched(spheres.size(), 0);
  for (const Contact& contact : contacts) {
    ++touched[contact.first];
    ++touched[contact.second];
  }

  // Counts are whole numbers: no order of summing can change them.
  Coordination result;
  std::vector<bool> in_die(spheres.size());
  std::size_t total = 0, total_walls = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    in_die[i] = is_inside(container, spheres[i].centre);
    if (!in_die[i]) continue;
    ++result.spheres;
    total += touched[i];
    if (touched[i] >= result.histogram.size()) result.histogram.resize(touched[i] + std::size_t{1}, 0);
    ++result.histogram[touched[i]];
  }
  for (const std::uint32_t i : wall_contacts) {
    if (i >= spheres.size()) throw std::out_of_range("a wall contact names a sphere that does not exist");
    if (in_die[i]) ++total_walls;
  }

  if (result.spheres > 0) {
    result.mean = static_cast<double>(total) / static_cast<double>(result.spheres);
    result.mean_walls = static_cast<double>(total_walls) / static_cast<double>(result.spheres);
  }
  return result;
}

}  // namespace pulvis::measures
