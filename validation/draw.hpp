// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <cstdint>

#include "engine/base/random.hpp"
#include "engine/math/vec3.hpp"

namespace pulvis::validation {

/// Repeatable random numbers for one random case of a test: the same whatever was drawn for the others.
class Draw {
 public:
  explicit Draw(std::uint64_t number, std::uint32_t stream = 0) : number_(number), stream_(stream) {}

  double between(double low, double high) {
    return low + (high - low) * uniform(20250117, stream_, number_, next_++);
  }
  /// Uniform in the logarithm, for quantities of unknown size.
  double decades(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  Vec3 direction() {
    for (;;) {
      const Vec3 v{between(-1, 1), between(-1, 1), between(-1, 1)};
      const double size = norm(v);
      if (size > 0.1 && size < 1.0) return v / size;
    }
  }
  /// A vector of up to `size` in any direction.
  Vec3 vector(double size) { return between(0.0, size) * direction(); }

 private:
  std::uint64_t number_;
  std::uint32_t stream_;
  std::uint32_t next_ = 0;
};

}  // namespace pulvis::validation
