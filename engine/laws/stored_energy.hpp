// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/parts.hpp"

// What a contact stores, and what becomes of it in a step: for the ledger of energy (NOTATION.md, "Energy ledger").
// The parts of a law state their stored energy beside their force; what springs with a limit gain and lose is the
// same for all of them and stands here.
namespace pulvis::laws {

/// What becomes of the energy of a spring in a step, J.
struct SpringStep {
  double stored;     ///< at the end of the step
  double slipped;    ///< taken by the limit
  double stiffened;  ///< brought in because the stiffness changed; negative: taken
};

/// What a spring of this stiffness stores over the square of its force: 1/(2 k); 0 for none.
PULVIS_INLINE double half_compliance(double stiffness) {
  return select(stiffness > 0.0, 0.5 / greatest(stiffness, 1e-300), 0.0);
}

/// Spring forces: `before`, at the end of the step before; `kept`, the same in the present stiffness before the bodies
/// moved; `trial`, after that; `now`, after the limit; all carried into the present plane. With
///   dW = (before + now) . (trial - kept)/(2 k)          work put in, by the trapezoidal rule        [J]  (1)
///   D  = (before + now) . (trial - now)/(2 k)           the same of the displacement that slipped   [J]  (2)
///   S  = now^2/(2 k) - before^2/(2 k_before) - (before + now) . (now - kept)/(2 k)                  [J]  (3)
/// the stored energy changes by exactly dW - D + S.
PULVIS_INLINE SpringStep spring_step(const Vec3& before, const Vec3& kept, const Vec3& trial, const Vec3& now,
                                     double stiffness_before, double stiffness) {
  const double half = half_compliance(stiffness), half_before = half_compliance(stiffness_before);
  const Vec3 both = before + now;
  const double stored = half * dot(now, now);
  return {stored, half * dot(both, trial - now),
          stored - half_before * dot(before, before) - half * dot(both, now - kept)};
}

}  // namespace pulvis::laws
