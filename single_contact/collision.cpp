// SPDX-License-Identifier: Apache-2.0
#include "single_contact/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "single_contact/adhesion.hpp"
#include "single_contact/numeric.hpp"

namespace pulvis::single_contact {
namespace {

constexpr double energy_share = 1e-4;  // of the kinetic energy, that a step's change of force may shift
constexpr int steps_per_contact = 1000;
constexpr double in_gap = 64.0;                       // times as long may a step be there
constexpr long most_steps = 200 * steps_per_contact;  // who is not back by then stays

/// Estimate of the contact's duration, s: three times the overlap at which the kinetic energy is used up over the
/// largest speed on the way (Hertz: 2.94 of the speed of approach, linear: pi).
double estimated_duration(const Contact& contact, double speed) {
  const double mass = contact.mass(), deepest = contact.largest_sphere();
  constexpr double growth = 1.05;
  double energy = 0.5 * mass * speed * speed, largest = energy, overlap = 1e-15 * contact.radius();
  if (contact.formation_gap() > 0.0)
    energy -= integral([&](double x) { return contact.pressing(x); }, -contact.formation_gap(), 0.0);
  while (energy > 0.0 && overlap < deepest) {
    largest = std::max(largest, energy);
    energy -= contact.pressing(overlap * std::sqrt(growth)) * overlap * (growth - 1.0);
    overlap *= growth;
  }
  return (contact.formation_gap() + 3.0 * overlap) / std::sqrt(2.0 * largest / mass);
}

/// Where a collision is, and what acts there.
struct Moment {
  double overlap, closing, force;  ///< m, m/s, N
  laws::Past past;
};

/// Steps of velocity Verlet.
struct Steps {
  double longest;  ///< s
  bool fixed;      ///< all of them so long; else shorter where needed, and longer across gaps
};

Collision integrate(const Contact& contact, double speed, Moment now, const Steps& steps) {
  const double mass = contact.mass(), least_energy = 1e-9 * 0.5 * mass * speed * speed;
  Collision result;
  double dt = steps.longest;
  bool rebounds = false;
  for (long step = 0; step < most_steps; ++step) {
    const double half = now.closing - 0.5 * dt * now.force / mass, overlap = now.overlap + dt * half;
    const laws::Response response = contact.in_motion(overlap, half, true, now.past, dt);
    const double force = push(response), energy = std::max(0.5 * mass * half * half, least_energy);
    const bool too_long = std::abs((force - now.force) * half * dt) > energy_share * energy;
    if (!steps.fixed && too_long && dt > 1e-9 * steps.longest) {
      dt *= 0.5;
      continue;
    }
    result.duration += dt;
    if (response.touching == 0.0) {
      // It broke when the gap was reached, in the middle of a step whose first half the old force has had. A run does
      // not see that.
      const double share =
          std::clamp((-contact.separation_gap() - now.overlap) / (overlap - now.overlap), 0.0, 1.0);
      const double left = half - (steps.fixed ? 0.0 : (share - 0.5) * dt * now.force / mass);
      result.restitution = std::max(-left / speed, 0.0);
      return result;
    }
    now = {overlap, half - 0.5 * dt * force / mass, force, response.history};
    result.largest_overlap = std::max(result.largest_overlap, overlap);
    result.is_crushed = overlap > contact.largest_sphere();
    if (result.is_crushed) return result;
    if (half < 0.0) rebounds = true;
    if (rebounds && half > 0.0) break;
    if (!steps.fixed) dt = std::min(2.0 * dt, overlap > 0.0 ? steps.longest : in_gap * steps.longest);
  }
  result.sticks = true;
  return result;
}

}  // namespace

Collision collide(const Contact& contact, double speed) {
  const double longest = estimated_duration(contact, speed) / steps_per_contact;
  const double start = -contact.formation_gap() * (1.0 - 1e-12) + 1e-15 * contact.radius();
  const laws::Response touch = contact.in_motion(start, speed, true, {}, longest);
  return integrate(contact, speed, {start, speed, push(touch), touch.history}, {longest, false});
}

Collision collide(const Contact& contact, double speed, double step) {
  const double start = 0.5 * speed * step - contact.formation_gap();
  const laws::Response seen = contact.in_motion(start, speed, false, {}, step);
  const double closing = speed - 0.5 * step * push(seen) / contact.mass();
  return integrate(contact, speed, {start, closing, push(seen), seen.history}, {step, true});
}

StickingSpeeds sticking_speeds(const Contact& contact, double reference) {
  constexpr int octaves = 12;
  if (!contact.is_damped() && !contact.remembers())
    return {0.0, std::sqrt(2.0 * adhesion(contact).lost_work / contact.mass())};
  if (!(reference > 0.0)) return {};
  // Between a speed that sticks and one that does not.
  const auto between = [&](double sticking, double other) {
    while (std::abs(other - sticking) > 1e-4 * sticking) {
      const double middle = 0.5 * (sticking + other);
      (collide(contact, middle).sticks ? sticking : other) = middle;
    }
    return 0.5 * (sticking + other);
  };
  StickingSpeeds found;
  double above = std::numeric_limits<double>::infinity();  // the last that did not stick, then that did
  for (int k = octaves; k >= -octaves; --k) {
    const double speed = std::ldexp(reference, k);
    const Collision c = collide(contact, speed);
    if (c.is_crushed) continue;
    if (found.highest == 0.0 && c.sticks) found.highest = std::isinf(above) ? above : between(speed, above);
    if (found.highest > 0.0 && !c.sticks) {
      found.lowest = between(above, speed);
      break;
    }
    above = speed;
  }
  return found;
}

}  // namespace pulvis::single_contact
