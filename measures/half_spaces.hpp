// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

namespace pulvis::measures {

/// An interval [low, high] of one coordinate, written as a sum of half-lines H(d) = {t >= d}, d >= 0, that
/// measures the same part of any body lying in [-1, 1] and symmetric under t -> -t:
///   0 < low:         H(low) - H(high)
///   high < 0:        H(-high) - H(-low)               (mirrored)
///   low <= 0 <= high: 2 H(0) - H(-low) - H(high)      (the whole line is twice its half)
/// Half-lines with d >= 1 miss the body and are dropped. With d never negative, one formula for a corner
/// serves balls and discs cut by any box.
struct HalfSpaces {
  std::array<double, 3> weight{};    ///< -
  std::array<double, 3> distance{};  ///< d, in radii of the body
  int count = 0;

  HalfSpaces(double low, double high) {
    if (low > 0.0) {
      add(1.0, low);
      add(-1.0, high);
    } else if (high < 0.0) {
      add(1.0, -high);
      add(-1.0, -low);
    } else {
      add(2.0, 0.0);
      add(-1.0, -low);
      add(-1.0, high);
    }
  }

 private:
  void add(double w, double d) {
    if (d >= 1.0) return;
    weight[static_cast<std::size_t>(count)] = w;
    distance[static_cast<std::size_t>(count)] = d;
    ++count;
  }
};

}  // namespace pulvis::measures
