// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "single_contact/contact.hpp"

namespace pulvis::single_contact {

/// How strongly a contact that was pressed slowly, and is then pulled slowly, holds together. For laws that
/// remember, it depends on how far they were pressed.
struct Adhesion {
  /// Whether it comes to rest at all: false where the attraction exceeds the stiffness down to overlaps of a
  /// radius. The rest is zero then.
  bool holds = true;
  double pressed_overlap = 0.0;     ///< m: to where it was pressed
  double pull_off = 0.0;            ///< N: the largest attraction on the way apart
  double zero_force_overlap = 0.0;  ///< m: where it rests without external force
  double separation_work = 0.0;     ///< J: from there to separation
  double lost_work = 0.0;           ///< J: lost by one touch, pressing and separation
};

/// After a pressing force (N), or, with 0, from rest under its own attraction. Forces and overlaps are exact to
/// 1e-9, works to 1e-6 of themselves.
Adhesion adhesion(const Contact& contact, double pressing_force = 0.0);

}  // namespace pulvis::single_contact
