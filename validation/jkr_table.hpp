// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <vector>

namespace pulvis::validation {

/// A contact that adheres.
struct JkrContact {
  const char* name;
  double modulus, radius, work;  ///< E* (Pa), R* (m), W (J/m^2)
};

/// A stiff micron-sized pair, a soft one, and a millimetre-sized one.
inline constexpr std::array jkr_contacts{JkrContact{"molybdenum", 1.758e11, 1.15e-6, 2e-4},
                                         JkrContact{"softened molybdenum", 5.49e6, 1.15e-6, 2e-4},
                                         JkrContact{"sticky sand", 2.7e6, 5e-4, 0.1}};

/// A point of the curve in units of its special points: overlap over delta_c, contact radius over that without
/// force, force over the pull-off force. `force_terms`: the sum of the magnitudes of the two terms of the force.
struct JkrPoint {
  double overlap, radius, force, force_terms;
};

/// Sixteen overlaps, solved with 113 bits from
///   delta/delta_c = 6^(1/3) (2 x^2 - 4/3 sqrt(x)),  F/F_po = 4 x^3 - 4 x^(3/2),  x = a/a0.
std::vector<JkrPoint> jkr_table();

/// What the law says at an overlap given over delta_c (at -1: at the stretch the law itself breaks at, since the
/// curve is vertical there), in the same units and the force also in N, positive where it presses.
struct JkrAnswer {
  double radius, force, force_newton;
};
JkrAnswer jkr_law_at(const JkrContact& c, double overlap);

/// Stretch at which the law breaks, m.
double jkr_rupture_of(const JkrContact& c);

/// Area under the stretched branch, J, by Simpson's rule.
double jkr_separation_work_of(const JkrContact& c);

}  // namespace pulvis::validation
