// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Throws std::out_of_range if a contact names a sphere that is not among `spheres` many.
void check_contacts(std::span<const Contact> contacts, std::size_t spheres);

/// Joins what touches (union-find). A cluster's name is the smallest place in the list of its members, so
/// that it does not depend on the order of the contacts.
class Clusters {
 public:
  explicit Clusters(std::size_t count);

  void join(std::uint32_t first, std::uint32_t second);
  std::uint32_t name(std::uint32_t member);

 private:
  std::vector<std::uint32_t> parent_;
};

/// Members, in ascending order, of the largest cluster among the spheres with a non-zero `takes_part`; only
/// contacts between two of them join. Of clusters of the same size the one with the smallest member wins.
/// A sphere without contact is a cluster of one; nothing takes part: empty.
std::vector<std::uint32_t> largest_cluster(std::span<const Contact> contacts,
                                           std::span<const std::uint8_t> takes_part);

}  // namespace pulvis::measures
