// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>

// Roots, lowest values and integrals of functions that are cheap to ask and smooth but for a few kinks.
namespace pulvis::single_contact {

/// Where `is_low` changes from true (at `low`) to false (at `high`), to the last bit.
template <class Test>
double boundary(Test is_low, double low, double high) {
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    if (middle <= std::min(low, high) || middle >= std::max(low, high)) break;
    (is_low(middle) ? low : high) = middle;
  }
  return high;
}

/// From 0 to 1, and slow at both ends, where forces jump or change like a square root.
inline double slow_at_ends(double u) { return u * u * (3.0 - 2.0 * u); }

/// Lowest value of f between a and b: the lowest of a thousand places, and what a golden section finds around it.
template <class Function>
double lowest_value(Function f, double a, double b) {
  constexpr int places = 1000;
  const auto at = [&](int k) { return a + (b - a) * slow_at_ends(static_cast<double>(k) / places); };
  int best = 0;
  double lowest = f(at(0));
  for (int k = 1; k <= places; ++k)
    if (const double value = f(at(k)); value < lowest) best = k, lowest = value;
  double low = at(std::max(best - 1, 0)), high = at(std::min(best + 1, places));
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  for (int k = 0; k < 60; ++k) {
    const double x = high - golden * (high - low), y = low + golden * (high - low);
    const double fx = f(x), fy = f(y);
    lowest = std::min({lowest, fx, fy});
    (fx < fy ? high : low) = fx < fy ? y : x;
  }
  return lowest;
}

/// Simpson's rule on [a, b], halved where two halves differ from their whole by more than `tolerance`.
template <class Function>
double simpson(const Function& f, double a, double b, double fa, double fm, double fb, double whole,
               double tolerance, int depth) {
  const double m = 0.5 * (a + b), fl = f(0.5 * (a + m)), fr = f(0.5 * (m + b));
  const double left = (m - a) / 6.0 * (fa + 4.0 * fl + fm), right = (b - m) / 6.0 * (fm + 4.0 * fr + fb);
  const double difference = left + right - whole;
  if (depth == 0 || std::abs(difference) <= tolerance) return left + right + difference / 15.0;
  return simpson(f, a, m, fa, fl, fm, left, 0.5 * tolerance, depth - 1) +
         simpson(f, m, b, fm, fr, fb, right, 0.5 * tolerance, depth - 1);
}

/// Integral of f from a to b, to about 1e-9 of the integral of its magnitude.
template <class Function>
double integral(Function f, double a, double b) {
  if (!(b > a)) return 0.0;
  constexpr int panels = 16;
  const auto g = [&](double u) { return f(a + (b - a) * slow_at_ends(u)) * (b - a) * 6.0 * u * (1.0 - u); };
  double magnitude = 0.0, sum = 0.0;
  for (int k = 0; k < 4 * panels; ++k) magnitude += std::abs(g((k + 0.5) / (4 * panels))) / (4 * panels);
  for (int k = 0; k < panels; ++k) {
    const double u = static_cast<double>(k) / panels, v = (k + 1.0) / panels;
    const double gu = g(u), gm = g(0.5 * (u + v)), gv = g(v);
    sum += simpson(g, u, v, gu, gm, gv, (v - u) / 6.0 * (gu + 4.0 * gm + gv), 1e-10 * magnitude / panels, 30);
  }
  return sum;
}

}  // namespace pulvis::single_contact
