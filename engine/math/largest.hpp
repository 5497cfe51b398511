// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/scalar.hpp"

namespace pulvis {

/// Largest value of a function with one maximum between `left` and `right`, by golden-section search. After
/// 45 steps the place is known to 4e-10 of the interval; the value is off by the square of that.
template <class Function>
double golden_section(double left, double right, const Function& f) {
  constexpr double golden = 0.6180339887498949;
  double inner_left = right - golden * (right - left), inner_right = left + golden * (right - left);
  double value_left = f(inner_left), value_right = f(inner_right);
  for (int step = 0; step < 45; ++step) {
    if (value_left > value_right) {
      right = inner_right;
      inner_right = inner_left;
      value_right = value_left;
      inner_left = right - golden * (right - left);
      value_left = f(inner_left);
    } else {
      left = inner_left;
      inner_left = inner_right;
      value_left = value_right;
      inner_right = left + golden * (right - left);
      value_right = f(inner_right);
    }
  }
  return greatest(value_left, value_right);
}

/// Largest value of a smooth function between `low` and `high`: of `pieces` + 1 points in equal distances,
/// each that is not below its neighbours is where a search begins. Peaks narrower than two pieces may be
/// missed. The result is a value the function takes: never above its maximum, and below it by rounding only.
template <class Function>
double largest_between(double low, double high, int pieces, const Function& f) {
  const auto place = [&](int k) { return low + (high - low) * (static_cast<double>(k) / pieces); };
  double best = f(low), before = best, here = best;
  for (int k = 0; k <= pieces; ++k) {
    const double after = k < pieces ? f(place(k + 1)) : here;
    if (here >= before && here >= after) {
      best = greatest(best, here);
      best = greatest(best, golden_section(place(k > 0 ? k - 1 : 0), place(k < pieces ? k + 1 : k), f));
    }
    before = here;
    here = after;
  }
  return best;
}

}  // namespace pulvis
