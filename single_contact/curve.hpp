// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "single_contact/contact.hpp"

namespace pulvis::single_contact {

struct CurvePoint {
  double overlap;  ///< m; negative: gap
  double force;    ///< N; positive pushes apart
};

/// Slow pressing from where the contact begins to `largest_overlap` (m), and back to where it breaks.
struct Curve {
  std::vector<CurvePoint> loading, unloading;
};

/// So many points a branch, closer together around first touch. Each branch ends with the force just before the
/// contact begins or breaks; the zero beyond is not part of it.
Curve load_unload_curve(const Contact& contact, double largest_overlap, int points = 400);

}  // namespace pulvis::single_contact
