// SPDX-License-Identifier: Apache-2.0
#include "single_contact/adhesion.hpp"

#include <algorithm>

#include "single_contact/numeric.hpp"

namespace pulvis::single_contact {

Adhesion adhesion(const Contact& contact, double pressing_force) {
  Adhesion result;
  const auto pressed = contact.overlap_under(pressing_force);
  if (!pressed) {
    result.holds = false;
    return result;
  }
  result.pressed_overlap = *pressed;
  const laws::Past past = contact.pressed_to(*pressed);
  const auto force = [&](double overlap) { return contact.unloading(overlap, past); };
  // Contacts exist beyond their ends only: step in by less than any digit that is shown.
  const double touch = 1e-15 * contact.radius();
  const double gap = (1.0 - 1e-12) * contact.separation_gap(), begins = contact.formation_gap();

  if (*pressed > touch && force(touch) < 0.0)
    result.zero_force_overlap = boundary([&](double x) { return force(x) < 0.0; }, touch, *pressed);
  const double rest = result.zero_force_overlap;
  double lowest = std::min(force(touch), 0.0);
  if (rest > touch) lowest = std::min(lowest, lowest_value(force, touch, rest));
  if (gap > 0.0) lowest = std::min(lowest, lowest_value(force, -gap, 0.0));
  result.pull_off = -lowest;

  const auto taken = [&](double from, double to) { return -integral(force, from, to); };
  result.separation_work = taken(-gap, 0.0) + (rest > touch ? taken(touch, rest) : 0.0);
  // Beyond the gap where it began the way apart is the contact's alone; below, it is there and back.
  result.lost_work = begins < gap ? taken(-gap, -begins) : 0.0;
  if (contact.remembers() && *pressed > touch)
    result.lost_work += integral([&](double x) { return contact.pressing(x) - force(x); }, touch, *pressed);
  return result;
}

}  // namespace pulvis::single_contact
