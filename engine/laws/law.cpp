// SPDX-License-Identifier: Apache-2.0
#include "engine/laws/catalogue.hpp"

namespace pulvis::laws {
namespace {

Whole whole_of(const CohesionEntry& cohesion, const Choices& choices) {
  const CohesionLimit limit =
      choices.cohesion_limit == CohesionLimit::standard ? cohesion.standard_limit : choices.cohesion_limit;
  return {choices.limit_includes_dashpot ? 1.0 : 0.0, limit == CohesionLimit::without ? 0.0 : 1.0,
          limit == CohesionLimit::shifted ? 2.0 : 0.0};
}

}  // namespace

PairConstants Law::mix(const MaterialPair& material, const Choices& choices) const {
  PairConstants constants{};
  pack(whole_of(*cohesion, choices), Place::whole, constants);
  normal->mix(material, choices, constants);
  cohesion->mix(material, choices, constants);
  const Stiffness stiffness = normal->stiffness(material, choices);
  for (const FollowingEntry* part :
       {static_cast<const FollowingEntry*>(damping), static_cast<const FollowingEntry*>(sliding),
        static_cast<const FollowingEntry*>(rolling), static_cast<const FollowingEntry*>(twisting)})
    part->mix(material, choices, stiffness, constants);
  return constants;
}

double Law::separation_gap(double radius, const PairConstants& constants) const {
  return greatest(normal->separation_gap(radius, constants), cohesion->longest_gap(radius, constants));
}

double Law::formation_gap(double radius, const PairConstants& constants) const {
  return cohesion->acts_on_approach(constants) ? cohesion->longest_gap(radius, constants) : 0.0;
}

Normal Law::normal_force(double overlap, double radius, const PairConstants& constants) const {
  Touch touch{};
  touch.overlap = overlap;
  touch.radius = radius;
  double plastic = 0.0, adhesion = 0.0;
  return normal->normal(touch, constants, plastic, adhesion);
}

Response Law::evaluate(const Touch& touch, const Past& old, const PairConstants& constants) const {
  const Whole whole = unpack<Whole>(constants.data(), Place::whole);
  double touching =
      touches(touch.overlap, touch.was_touching, 0.0, normal->separation_gap(touch.radius, constants));
  Past now = old;
  const Normal n = normal->normal(touch, constants, now.plastic, now.adhesion);

  const Dashpots c = damping->coefficients(n, touch.mass, constants);
  const double closing = closing_speed(touch);
  const Vec3 slip = slip_velocity(touch, closing);
  const double dashpot = dashpot_force(c.normal, closing, touch);
  double force = n.elastic + dashpot;
  double limit = limiting_force(n, dashpot, whole);

  Attraction a{};
  if (cohesion->acts) {
    if (cohesion->reaches)
      touching = greatest(
          touching, touches(touch.overlap, touch.was_touching, cohesion->formation_gap(touch, constants),
                            cohesion->separation_gap(touch, constants)));
    a = cohesion->attraction(touch, constants);
    force = force - a.pull + a.viscous_normal * closing;
    limit = limiting_force(limit, n.contact_size, a, whole);
  }
  limit = magnitude(limit);

  const double held = select(n.contact_size > 0.0, touching, 0.0);
  Vec3 tangential =
      sliding->slide(touch, slip, n.contact_size, limit, c.tangential, constants, now.slide, now.grip);
  Vec3 whole_force = touching * (tangential - force * touch.normal);
  tangential = touching * tangential;

  double twist = 0.0, twisted = 0.0;  // torque, and the part of it that is remembered
  const Vec3 before = normal_before(touch.normal, touch.half_normal);
  if (twisting->acts) {
    twisted = dot(now.roll, before);
    now.roll = now.roll - twisted * before;
    twist = twisting->twist(touch, n.contact_size, limit, c.tangential, constants, twisted);
  }
  Vec3 torque = rolling->roll(touch, n.contact_size, limit, constants, now.roll);
  if (twisting->acts) {
    torque = torque + twist * touch.normal;
    now.roll = now.roll + twisted * touch.normal;
  }

  Vec3 drag{};
  if (cohesion->is_viscous) {
    drag = touching * drag_force(slip, touch.normal, a.viscous_tangential);
    whole_force = whole_force + drag;
  }
  now.slide = held * now.slide;
  now.roll = held * now.roll;
  if (normal->remembers) now.plastic = touching * now.plastic, now.adhesion = touching * now.adhesion;
  if (sliding->remembers_grip) now.grip = held * now.grip;
  return {touching, whole_force, tangential, drag, held * torque, now};
}

}  // namespace pulvis::laws
