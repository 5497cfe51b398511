// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// A box along the axes; the empty one at first.
struct Bounds {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 min{infinity, infinity, infinity}, max{-infinity, -infinity, -infinity};

  void include(const Vec3& p) {
    min = {least(min.x, p.x), least(min.y, p.y), least(min.z, p.z)};
    max = {greatest(max.x, p.x), greatest(max.y, p.y), greatest(max.z, p.z)};
  }
  void include(const Bounds& other) {
    include(other.min);
    include(other.max);
  }
  Vec3 size() const { return max - min; }
  /// Of a point from the box; 0 inside.
  double square_distance(const Vec3& p) const {
    const auto beyond = [](double x, double low, double high) {
      return greatest(greatest(low - x, x - high), 0.0);
    };
    return square(beyond(p.x, min.x, max.x)) + square(beyond(p.y, min.y, max.y)) +
           square(beyond(p.z, min.z, max.z));
  }
  Vec3 centre() const { return 0.5 * (min + max); }
  bool overlaps(const Bounds& b) const {
    return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y && min.z <= b.max.z &&
           b.min.z <= max.z;
  }
  bool holds(const Bounds& b) const {
    return min.x < b.min.x && b.max.x < max.x && min.y < b.min.y && b.max.y < max.y && min.z < b.min.z &&
           b.max.z < max.z;
  }
};

}  // namespace pulvis
