// SPDX-License-Identifier: Apache-2.0
#include "measures/lucy_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace pulvis::measures {
namespace {

/// Integral of W/W(0) from t = 0 but for its logarithm; lengths in c.
double polynomial_part(double t, double a2) {
  const double t2 = t * t, r = std::sqrt(a2 + t2), r3 = r * (a2 + t2);
  return t * (1.0 - 6.0 * (a2 + t2 / 3.0) + 2.0 * r3 + 3.0 * a2 * r -
              3.0 * (a2 * a2 + 2.0 / 3.0 * a2 * t2 + 0.2 * t2 * t2));
}

/// t + r, without cancellation for t < 0.
double log_argument(double t, double a2) {
  const double r = std::sqrt(a2 + t * t);
  return t > 0.0 ? r + t : a2 / (r - t);
}

}  // namespace

LucyKernel::LucyKernel(double support)
    : support_(support), peak_(105.0 / (16.0 * std::numbers::pi * support * support * support)) {
  if (!(support > 0.0 && std::isfinite(peak_)))
    throw std::invalid_argument("LucyKernel: the support must be above zero");
}

double LucyKernel::at(double squared_distance) const {
  const double r = std::sqrt(squared_distance) / support_;
  if (!(r < 1.0)) return 0.0;
  const double rest = 1.0 - r;
  return peak_ * (1.0 + 3.0 * r) * rest * rest * rest;
}

double LucyKernel::along(const Vec3& point, const Vec3& from, const Vec3& to) const {
  const Vec3 line = to - from, start = point - from;
  const double length = norm(line);
  if (!(length > 0.0)) return at(dot(start, start));

  const double foot = dot(start, line) / length;
  const Vec3 across = start - (foot / length) * line;
  const double a2 = dot(across, across) / (support_ * support_);
  if (!(a2 < 1.0)) return 0.0;
  const double half_chord = std::sqrt(1.0 - a2);
  const double low = std::max(-foot / support_, -half_chord);
  const double high = std::min((length - foot) / support_, half_chord);
  if (!(low < high)) return 0.0;

  double integral = polynomial_part(high, a2) - polynomial_part(low, a2);
  if (a2 > 1e-14)  // else below rounding
    integral += 3.0 * a2 * a2 * std::log(log_argument(high, a2) / log_argument(low, a2));
  return peak_ * integral * support_ / length;
}

}  // namespace pulvis::measures
