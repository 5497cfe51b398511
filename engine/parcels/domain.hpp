// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/vec3.hpp"

namespace pulvis {

/// The box outside which no parcel may be, m; an axis can be periodic.
struct Box {
  Vec3 min, max;
  bool periodic[3] = {false, false, false};

  Vec3 extent() const { return max - min; }
};

/// Nearest image of a difference of positions along the periodic axes. The length is 0 along the others.
struct NearestImage {
  Vec3 length;

  static NearestImage of(const Box& box) {
    const Vec3 e = box.extent();
    return {{box.periodic[0] ? e.x : 0.0, box.periodic[1] ? e.y : 0.0, box.periodic[2] ? e.z : 0.0}};
  }
  PULVIS_INLINE static double wrap(double d, double length) {
    const double half = 0.5 * length;
    const bool up = d > half, down = d < -half;
    return length > 0.0 ? (up ? d - length : down ? d + length : d) : d;
  }
  PULVIS_INLINE Vec3 operator()(const Vec3& d) const {
    return {wrap(d.x, length.x), wrap(d.y, length.y), wrap(d.z, length.z)};
  }
};

}  // namespace pulvis
