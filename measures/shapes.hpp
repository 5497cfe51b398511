// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "engine/math/vec3.hpp"

// The plain data that measures are taken of. All lengths in metres.
namespace pulvis::measures {

/// A parcel as geometry sees it.
struct Sphere {
  Vec3 centre{};        ///< m
  double radius = 0.0;  ///< m
};

/// An axis-aligned box, the product of three closed intervals. A bound may be infinite.
struct Box {
  Vec3 min{}, max{};  ///< m
};

/// A contact between two parcels: their places in the list of spheres, each contact listed once.
/// Which contacts to list (those that carry force, stretched ones included) is the caller's choice.
struct Contact {
  std::uint32_t first = 0, second = 0;
};

}  // namespace pulvis::measures
