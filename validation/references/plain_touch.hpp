// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/laws/catalogue.hpp"

namespace pulvis::validation {

/// Two spheres in touch along z, at rest, as a law sees them.
inline laws::Touch touch_of(double first, double second, double overlap, bool was_touching = true) {
  const Vec3 z{0, 0, 1};
  laws::Touch t{overlap, first * second / (first + second), 1e-6, was_touching ? 1.0 : 0.0, z, z, {}, {},
                1e-6};
  t.radius_first = first;
  t.radius_second = second;
  t.mass_first = t.mass_second = 2e-6;
  return t;
}
/// A sphere at a flat wall.
inline laws::Touch touch_of_wall(double radius, double overlap, bool was_touching = true) {
  laws::Touch t = touch_of(radius, radius, overlap, was_touching);
  t.radius = radius;
  t.radius_second = t.mass_second = 0.0;
  t.mass_first = t.mass;
  return t;
}

/// Normal force, N, positive apart; without contact 0.
inline double normal_force(const laws::Law& law, const laws::Touch& touch, const laws::MaterialPair& material,
                           const laws::Choices& choices = {}, const laws::Past& history = {}) {
  return -law.evaluate(touch, history, law.mix(material, choices)).force.z;
}

/// Speed after a collision at `speed` of two bodies that only the law moves, over it; -1 if they stick.
inline double restitution_shown(const laws::Law& law, const laws::MaterialPair& material, laws::Touch touch,
                                double speed, double duration, const laws::Choices& choices = {}) {
  const auto constants = law.mix(material, choices);
  touch.dt = duration / 4000.0;
  touch.was_touching = 0.0;
  touch.overlap = 0.5 * touch.dt * speed;
  double closing = speed;
  laws::Past history;
  for (int step = 0; step < 40000; ++step) {
    touch.velocity = {0, 0, closing};
    const laws::Response r = law.evaluate(touch, history, constants);
    if (r.touching == 0.0) return -closing / speed;
    history = r.history;
    touch.was_touching = 1.0;
    closing += r.force.z / touch.mass * touch.dt;
    touch.overlap += closing * touch.dt;
  }
  return -1.0;
}

}  // namespace pulvis::validation
