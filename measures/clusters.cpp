// SPDX-License-Identifier: Apache-2.0
#include "measures/clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace pulvis::measures {

void check_contacts(std::span<const Contact> contacts, std::size_t spheres) {
  for (const Contact& contact : contacts)
    if (contact.first >= spheres || contact.second >= spheres)
      throw std::out_of_range(fmt::format("contact between spheres {} and {}, but there are only {} spheres",
                                          contact.first, contact.second, spheres));
}

Clusters::Clusters(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

std::uint32_t Clusters::name(std::uint32_t member) {
  while (parent_[member] != member) {
    parent_[member] = parent_[parent_[member]];  // halves the path for the next who asks
    member = parent_[member];
  }
  return member;
}

void Clusters::join(std::uint32_t first, std::uint32_t second) {
  // The smaller name survives: names are then definite, and halving the paths keeps it fast.
  const auto [smaller, larger] = std::minmax({name(first), name(second)});
  parent_[larger] = smaller;
}

std::vector<std::uint32_t> largest_cluster(std::span<const Contact> contacts,
                                           std::span<const std::uint8_t> takes_part) {
  const auto count = static_cast<std::uint32_t>(takes_part.size());
  check_contacts(contacts, count);
  Clusters clusters(count);
  for (const Contact& contact : contacts)
    if (takes_part[contact.first] && takes_part[contact.second]) clusters.join(contact.first, contact.second);

  std::vector<std::uint32_t> sizes(count, 0);
  for (std::uint32_t i = 0; i < count; ++i)
    if (takes_part[i]) ++sizes[clusters.name(i)];
  const auto largest = std::max_element(sizes.begin(), sizes.end());  // the first of equals
  std::vector<std::uint32_t> members;
  if (largest == sizes.end() || *largest == 0) return members;

  const auto name = static_cast<std::uint32_t>(largest - sizes.begin());
  members.reserve(*largest);
  for (std::uint32_t i = 0; i < count; ++i)
    if (takes_part[i] && clusters.name(i) == name) members.push_back(i);
  return members;
}

}  // namespace pulvis::measures
