// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "measures/shapes.hpp"

namespace pulvis::measures {

/// A length divided into equal parts, the first beginning at 0.
class Division {
 public:
  Division() = default;

  /// The whole number of parts, at least one, whose size comes closest to `edge`: round(length / edge).
  /// Throws Failure if that is no number or more than anyone could want.
  Division(double length, double edge);

  std::size_t count() const { return count_; }
  double part() const { return part_; }

  /// Where part i begins and part i-1 ends. The last part ends at the length itself, free of rounding.
  double edge(std::size_t i) const { return i == count_ ? length_ : static_cast<double>(i) * part_; }

  /// The part a place lies in; places outside belong to the first or the last.
  std::size_t at(double place) const {
    const double index = std::floor(place / part_);
    return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(count_ - 1)));
  }

 private:
  double length_ = 0.0, part_ = 0.0;
  std::size_t count_ = 0;
};

/// Most cells or columns that a field may have: 1 GiB of numbers, far more than any packing resolves.
constexpr std::size_t most_cells = std::size_t{1} << 27;

/// Throws Failure if a sphere has a centre or radius that is not a finite number: nothing can be measured.
void check_spheres(std::span<const Sphere> spheres);

/// Arithmetic mean of the diameters, m; what `edge` of cells and columns is usually a multiple of.
/// 0 if there are no spheres.
double mean_diameter(std::span<const Sphere> spheres);

}  // namespace pulvis::measures
