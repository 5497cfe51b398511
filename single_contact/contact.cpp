// SPDX-License-Identifier: Apache-2.0
#include "single_contact/contact.hpp"

#include <algorithm>

#include "single_contact/numeric.hpp"

namespace pulvis::single_contact {
namespace {

/// 1/(1/a + 1/b); of a wall (0) the other's.
double reduced(double a, double b) { return b > 0.0 ? a * b / (a + b) : a; }

laws::Touch touch_at(double overlap, double radius, double mass, const Bodies& bodies) {
  const Vec3 z{0, 0, 1};
  laws::Touch t{overlap, radius, mass, 1.0, z, z, {}, {}, 0.0};
  t.radius_first = bodies.radius_first, t.radius_second = bodies.radius_second;
  t.mass_first = bodies.mass_first, t.mass_second = bodies.mass_second;
  return t;
}

}  // namespace

Contact::Contact(const laws::Law& law, const laws::MaterialPair& material, const laws::Choices& choices,
                 const Bodies& bodies)
    : law_(law),
      material_(material),
      choices_(choices),
      bodies_(bodies),
      constants_(law.mix(material, choices)),
      radius_(reduced(bodies.radius_first, bodies.radius_second)),
      mass_(reduced(bodies.mass_first, bodies.mass_second)) {
  const laws::Touch touch = touch_at(0.0, radius_, mass_, bodies_);
  const bool reaches = law.cohesion->acts && law.cohesion->reaches;
  formation_ = reaches ? law.cohesion->formation_gap(touch, constants_) : 0.0;
  separation_ = std::max(law.normal->separation_gap(radius_, constants_),
                         reaches ? law.cohesion->separation_gap(touch, constants_) : 0.0);
}

Contact Contact::undamped() const {
  laws::Law law = law_;
  for (const laws::DampingEntry& entry : laws::catalogue().damping)
    if (entry.name == "none") law.damping = &entry;
  laws::MaterialPair material = material_;
  material.liquid_viscosity = 0.0;
  return {law, material, choices_, bodies_};
}

bool Contact::is_damped() const {
  return law_.damping->name != "none" || (law_.cohesion->is_viscous && material_.liquid_viscosity > 0.0);
}

double Contact::largest_sphere() const { return std::max(bodies_.radius_first, bodies_.radius_second); }

laws::Response Contact::in_motion(double overlap, double closing, bool was_touching, const laws::Past& past,
                                  double dt) const {
  laws::Touch touch = touch_at(overlap, radius_, mass_, bodies_);
  touch.was_touching = was_touching ? 1.0 : 0.0;
  touch.velocity = {0, 0, closing};
  touch.dt = dt;
  return law_.evaluate(touch, past, constants_);
}

double Contact::pressing(double overlap) const { return push(in_motion(overlap, 0.0, false, {}, 0.0)); }

laws::Past Contact::pressed_to(double overlap) const {
  return in_motion(overlap, 0.0, false, {}, 0.0).history;
}

double Contact::unloading(double overlap, const laws::Past& past) const {
  return push(in_motion(overlap, 0.0, true, past, 0.0));
}

std::optional<double> Contact::overlap_under(double force) const {
  // Laws pull below some overlap and push above it, or push from the start: the first of doubling overlaps that
  // pushes enough brackets the only one in question.
  const double deepest = largest_sphere();
  double below = 0.0, overlap = 1e-15 * radius_;
  const auto carries = [&](double at) { return pressing(at) >= force; };
  while (!carries(overlap)) {
    if (overlap >= deepest) return {};
    below = overlap;
    overlap = std::min(2.0 * overlap, deepest);
  }
  if (below == 0.0) return 0.0;
  return boundary([&](double at) { return !carries(at); }, below, overlap);
}

}  // namespace pulvis::single_contact
