// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

#include "engine/math/scalar.hpp"

// Sums whose result does not depend on the order of their terms: each term is rounded to a whole number of one small
// quantum, and whole numbers add up exactly. So a sum over contacts is the same for any number of threads and any order
// of the lists.
namespace pulvis {

__extension__ using Quanta = __int128;

/// How terms are rounded. A term up to 2^90 quanta is taken as a multiple of 2^44 quanta and a rest: 64 of either add up
/// exactly in a double.
struct SumGrid {
  static constexpr double high_step = 0x1p44, largest = 0x1p90;

  double quantum = 0.0;

  /// The grid whose largest term is `largest_term` or up to twice that.
  static SumGrid for_terms_up_to(double largest_term) {
    double power = 1.0;
    while (power < largest_term) power *= 2.0;
    while (power > 2.0 * largest_term) power *= 0.5;
    return {power / largest};
  }
  /// `x` rounded to multiples of 2^44 quanta. Adding 1.5 2^52 of the step pushes the rest out of the mantissa.
  PULVIS_INLINE double high(double x) const {
    const double shift = 0x1.8p52 * high_step * quantum;
    return (x + shift) - shift;
  }
  /// What `high` left, rounded to quanta.
  PULVIS_INLINE double low(double x, double high) const {
    const double shift = 0x1.8p52 * quantum;
    return ((x - high) + shift) - shift;
  }
  /// Quanta in sums of up to 64 high and low parts. A sum that is no number, or too large for the grid, counts nothing:
  /// a run whose energies are such stops at its next look at the parcels.
  Quanta count(double high_sum, double low_sum) const {
    const double high = high_sum / (high_step * quantum), low = low_sum / quantum;
    if (!(magnitude(high) < 0x1p62) || !(magnitude(low) < 0x1p62)) return 0;
    return static_cast<Quanta>(static_cast<std::int64_t>(high)) * (std::int64_t{1} << 44) +
           static_cast<std::int64_t>(low);
  }
  Quanta count(double x) const {
    const double h = high(x);
    return count(h, low(x, h));
  }
  double value(Quanta quanta) const { return static_cast<double>(quanta) * quantum; }
};

}  // namespace pulvis
