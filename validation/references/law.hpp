// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "validation/draw.hpp"
#include "validation/references/cohesion.hpp"
#include "validation/references/normal.hpp"

// A whole contact law a second time, in 113 bits, from the equations in the files of engine/laws.
namespace pulvis::validation {

/// c = -2 f beta sqrt(S m*) with beta = ln e/sqrt(ln^2 e + pi^2); f is sqrt(5/6) for Hertz.
inline Quad reference_dashpot(Quad stiffness, Quad mass, double restitution,
                              Quad shape = quad_root(Quad{5} / 6)) {
  const Quad log_e = std::log(static_cast<long double>(restitution));
  const Quad beta = log_e / quad_root(log_e * log_e + quad_pi() * quad_pi());
  return -2 * shape * beta * quad_root(stiffness * mass);
}

inline QuadVec reference_in_plane(const QuadVec& a, const QuadVec& n) { return a - dot(a, n) * n; }
inline QuadVec reference_cross(const QuadVec& a, const QuadVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Into the mid-step plane, and turned there by the shared spin: cosine 1 - 2 t^2 + 2 t^4, sine 2 t - 2 t^3 with
/// t = w dt/2.
inline QuadVec reference_carried(const Vec3& a, const laws::Touch& t) {
  const QuadVec half = quad(t.half_normal), v = reference_in_plane(quad(a), half);
  const Quad tangent = static_cast<Quad>(t.shared_spin) * static_cast<Quad>(t.dt) / 2;
  const Quad square = tangent * tangent;
  return (1 - 2 * square + 2 * square * square) * v +
         (2 * tangent - 2 * tangent * square) * reference_cross(half, v);
}

struct ReferenceResponse {
  bool touching = false;
  QuadVec force, tangential, roll_torque, slide, roll;
  Quad force_terms = 0, tangential_terms = 0, torque_terms = 0, slide_terms = 0;
  Quad plastic = 0, plastic_terms = 0, adhesion = 0, grip = 0;
  bool on_the_edge = false;  ///< so near a limit that rounding decides which side it is on
};

/// What the tangential and rolling laws are given.
struct ReferenceGrip {
  Quad contact_size = 0, limiting = 0, limiting_terms = 0, damping = 0;
  Quad tangential = 0, secant = 0;  ///< stiffnesses over the contact size
  QuadVec slip;
};

inline void reference_slide(ReferenceResponse& r, std::string_view law, const ReferenceGrip& g,
                            const laws::Touch& t, const laws::Past& old, const laws::MaterialPair& m) {
  const QuadVec normal = quad(t.normal), slip = reference_in_plane(g.slip, normal);
  const Quad mu = m.friction, limit = mu * g.limiting, dt = t.dt, speed = norm(quad(t.velocity));
  if (law == "none") return;
  if (law == "viscous") {
    const Quad trial = g.damping * norm(slip);
    r.on_the_edge |= quad_magnitude(trial - limit) < 1e-9 * (trial + limit);
    r.tangential = -(trial > limit ? limit / norm(slip) : g.damping) * slip;
    r.tangential_terms =
        trial > limit ? mu * g.limiting_terms + limit * speed / norm(slip) : g.damping * speed;
    return;
  }
  // Springs: `force` is what they would carry without Coulomb's limit, `unit` the force of their history's unit.
  const Quad stiffness = g.tangential * g.contact_size;
  const bool total = law == "total_spring";
  Quad shrink = 1;
  if (law == "rescaled_spring" && g.contact_size < static_cast<Quad>(old.grip))
    shrink = g.contact_size / static_cast<Quad>(old.grip);
  const Quad unit = total ? -stiffness : shrink;
  const QuadVec force =
      reference_in_plane(unit * reference_carried(old.slide, t) - (stiffness * dt) * g.slip, normal);
  const Quad terms = quad_magnitude(unit) * norm(quad(old.slide)) + stiffness * dt * speed;
  const Quad length = norm(force);
  if (law == "rescaled_spring") r.grip = g.contact_size;
  r.on_the_edge |= quad_magnitude(length - limit) < 1e-9 * (terms + mu * g.limiting_terms);
  const bool slips = length > limit;
  const QuadVec spring = slips ? (limit / length) * force : force;
  // The direction of the spring is as uncertain as the spring against what it was summed from.
  const Quad spring_terms = slips ? mu * g.limiting_terms + limit * terms / length : terms;
  r.tangential = slips ? spring : spring - g.damping * slip;
  r.tangential_terms = slips ? spring_terms : spring_terms + g.damping * speed;
  r.slide = total ? (-1 / stiffness) * spring : spring;
  r.slide_terms = total ? spring_terms / stiffness : spring_terms;
}

inline void reference_roll(ReferenceResponse& r, std::string_view law, const ReferenceGrip& g,
                           const laws::Touch& t, const Vec3& old, const laws::MaterialPair& m) {
  const QuadVec normal = quad(t.normal), half = quad(t.half_normal);
  const QuadVec spin = reference_in_plane(quad(t.spin), half);
  const Quad radius = t.radius, mu = m.rolling_friction, limit = mu * radius * g.limiting, dt = t.dt;
  const Quad limit_terms = mu * radius * g.limiting_terms;
  if (law == "none") return;
  if (law == "constant_torque") {
    const QuadVec along = reference_in_plane(spin, normal);
    r.roll_torque = (-limit / norm(along)) * along;
    r.torque_terms = limit_terms + limit * norm(quad(t.spin)) / norm(along);
    return;
  }
  const bool viscous = law == "elastic_plastic_viscous";
  const Quad k = viscous ? Quad{9} / 4 * g.secant * g.contact_size * mu * mu * radius * radius
                         : g.tangential * g.contact_size * radius * radius;
  const QuadVec torque = reference_in_plane(reference_carried(old, t) - (k * dt) * spin, normal);
  const Quad terms = norm(quad(old)) + k * dt * norm(quad(t.spin)), size = norm(torque);
  r.on_the_edge |= viscous && quad_magnitude(size - limit) < 1e-9 * (terms + limit_terms);
  const bool yields = size > limit;
  r.roll = yields ? (limit / size) * torque : torque;
  r.torque_terms = yields ? limit_terms + limit * terms / size : terms;
  r.roll_torque = r.roll;
  if (!viscous || yields) return;
  const Quad first = static_cast<Quad>(m.rolling_viscosity) * 2, r1 = t.radius_first, r2 = t.radius_second;
  const Quad i1 = Quad{7} / 5 * static_cast<Quad>(t.mass_first) * r1 * r1,
             i2 = Quad{7} / 5 * static_cast<Quad>(t.mass_second) * r2 * r2;
  const Quad damping = first * quad_root((t.radius_second > 0.0 ? i1 * i2 / (i1 + i2) : i1) * k);
  r.roll_torque = r.roll - damping * reference_in_plane(spin, normal);
  r.torque_terms = r.torque_terms + damping * norm(quad(t.spin));
}

inline ReferenceResponse reference_response(const laws::Law& law, const laws::Touch& t, const laws::Past& old,
                                            const laws::MaterialPair& m, const laws::Choices& choices) {
  const Quad overlap = t.overlap, radius = t.radius, mass = t.mass;
  const QuadVec normal = quad(t.normal), half = quad(t.half_normal);
  ReferenceResponse r;
  const ReferenceCohesion c = reference_cohesion(law.cohesion->name, t, m, choices);
  const Quad stretch = law.normal->name == "jkr"
                           ? jkr_stretch_at_rupture(radius, m.effective_modulus, m.work_of_adhesion)
                           : c.separation_gap;
  const Quad lowest = t.was_touching > 0.5 ? -stretch : -c.formation_gap;
  r.touching = overlap > lowest;
  r.on_the_edge = lowest != 0 && quad_magnitude(overlap - lowest) < -1e-9 * lowest;
  if (!r.touching) return r;

  const ReferenceNormal n = reference_normal(law.normal->name, t, old, m, choices);
  r.on_the_edge |= n.on_the_edge;
  r.plastic = n.plastic;
  r.plastic_terms = n.plastic_terms;
  r.adhesion = n.adhesion;
  const Quad damping_size = choices.damping_on_jkr_radius ? n.contact_size : n.damping_size;
  const bool damped = law.damping->name == "restitution";
  const Quad c_normal =
      damped ? reference_dashpot(n.normal * damping_size, mass, m.restitution, n.damping_shape) : 0;

  const QuadVec velocity = quad(t.velocity);
  const Quad closing = dot(velocity, half), dashpot = c_normal * closing;
  ReferenceGrip g;
  g.slip = velocity - closing * half;
  g.contact_size = n.contact_size;
  g.tangential = n.tangential;
  g.secant = n.secant;
  if (damped && choices.tangential_damping)
    g.damping = reference_dashpot(n.tangential * damping_size, mass, m.restitution, n.damping_shape);
  const auto limit = choices.cohesion_limit == laws::CohesionLimit::standard ? laws::CohesionLimit::without
                                                                             : choices.cohesion_limit;
  const Quad in_limit = choices.limit_includes_dashpot ? dashpot : Quad{0};
  const Quad cohesive = limit == laws::CohesionLimit::without ? Quad{0}
                        : limit == laws::CohesionLimit::with  ? -c.pull
                                                              : 2 * c.pull_off - c.pull;
  if (n.contact_size > 0) {
    g.limiting = quad_magnitude(n.force + n.limit_shift + in_limit + cohesive);
    g.limiting_terms =
        n.terms + n.shift_terms + c_normal * norm(velocity) + quad_magnitude(cohesive) + c.terms;
    reference_slide(r, law.sliding->name, g, t, old, m);
  }
  const QuadVec before = 2 * dot(normal, half) * half - normal;  // the normal a step ago
  const Quad old_twist = law.twisting->acts ? dot(quad(old.roll), before) : Quad{0};
  const QuadVec rolled = quad(old.roll) - old_twist * before;
  const Vec3 rolled_before{static_cast<double>(rolled.x), static_cast<double>(rolled.y),
                           static_cast<double>(rolled.z)};
  if (n.contact_size > 0) {
    reference_roll(r, law.rolling->name, g, t, rolled_before, m);
    r.torque_terms = r.torque_terms + (law.rolling->name == "none" ? Quad{0} : norm(quad(old.roll)));
  }
  if (law.twisting->acts && n.contact_size > 0) {
    const Quad k = g.tangential * g.contact_size * radius * radius,
               bound = static_cast<Quad>(m.twisting_friction) * radius;
    Quad twist = old_twist - k * static_cast<Quad>(t.dt) * dot(quad(t.spin), half);
    const Quad most = bound * g.limiting;
    twist = twist > most ? most : twist < -most ? -most : twist;
    r.roll = r.roll + twist * normal;
    r.roll_torque = r.roll_torque + twist * normal;
    r.torque_terms = r.torque_terms + norm(quad(old.roll)) +
                     k * static_cast<Quad>(t.dt) * norm(quad(t.spin)) + bound * g.limiting_terms;
  }
  const QuadVec drag = (-c.viscous_tangential) * reference_in_plane(g.slip, normal);
  const Quad normal_force = n.force + dashpot - c.pull + c.viscous_normal * closing;
  r.force = r.tangential + drag - normal_force * normal;
  r.force_terms = r.tangential_terms + n.terms + c.terms +
                  (c_normal + c.viscous_normal + c.viscous_tangential) * norm(velocity);
  return r;
}

/// A random pair of materials: anything from gel to steel, dust to gravel.
struct RandomState {
  laws::MaterialPair material;
  laws::Touch touch;
  laws::Past history;
};

inline void random_bodies(RandomState& s, Draw& draw) {
  laws::Touch& t = s.touch;
  const bool wall = draw.chance(0.2);
  const double first = draw.between(1.1, 11.0), mass = draw.between(1.1, 11.0);
  t.radius_first = wall ? t.radius : t.radius * first;
  t.radius_second = wall ? 0.0 : t.radius * first / (first - 1.0);
  t.mass_first = wall ? t.mass : t.mass * mass;
  t.mass_second = wall ? 0.0 : t.mass * mass / (mass - 1.0);
}

inline void random_cohesion(RandomState& s, Draw& draw, std::string_view cohesion) {
  laws::MaterialPair& m = s.material;
  laws::Touch& t = s.touch;
  m.cohesion_energy_density = m.effective_modulus * draw.decades(1e-5, 1e-1);
  m.surface_tension = draw.between(0.01, 0.1);
  m.contact_angle = draw.between(0.0, 0.8);
  m.liquid_content = draw.decades(1e-4, 2e-2);
  m.liquid_viscosity = draw.chance(0.2) ? 0.0 : draw.decades(1e-4, 1.0);
  m.shortest_bridge_gap = draw.decades(1e-3, 1e-1);
  m.shortest_gap = t.radius * draw.decades(1e-7, 1e-4);
  m.longest_gap = 100.0 * m.shortest_gap;
  m.hamaker_constant = draw.decades(1e-21, 1e-18);
  if (!draw.chance(0.7)) return;
  if (cohesion.starts_with("capillary"))
    t.overlap = -t.radius * draw.between(0.0, 2.4) * std::cbrt(m.liquid_content);
  if (cohesion == "hamaker") t.overlap = -m.longest_gap * draw.decades(1e-4, 1.2);
}

inline void random_history(RandomState& s, Draw& draw, std::string_view normal_law, double depth) {
  const laws::MaterialPair& m = s.material;
  const laws::Touch& t = s.touch;
  s.history.slide = draw.chance(0.1) ? Vec3{} : draw.vector(depth * draw.decades(1e-3, 3.0));
  s.history.roll =
      draw.chance(0.1)
          ? Vec3{}
          : draw.vector(m.effective_modulus * t.radius * t.radius * depth * draw.decades(1e-4, 1.0));
  const double delta = std::fmax(t.overlap, 0.0);
  s.history.grip = std::sqrt(t.radius * depth) * draw.between(0.5, 2.0);
  if (normal_law == "luding") s.history.plastic = delta * draw.between(0.0, 4.0);
  if (normal_law != "edinburgh") return;
  s.history.plastic = std::pow(delta, 1.5) * draw.between(0.0, 2.0);
  s.history.adhesion = m.effective_modulus * std::sqrt(t.radius) * draw.between(0.0, 2.0);
}

inline RandomState random_state(std::string_view normal_law, std::uint64_t number,
                                std::string_view cohesion = "none") {
  Draw draw(number, normal_law == "jkr" ? 1 : 2);
  RandomState s;
  laws::MaterialPair& m = s.material;
  m.effective_modulus = draw.decades(1e5, 1e12);
  m.effective_shear_modulus = m.effective_modulus * draw.between(0.1, 0.5);
  m.restitution = draw.chance(0.05) ? 1.0 : draw.between(0.05, 0.999);
  m.friction = draw.between(0.0, 1.2);
  m.rolling_friction = draw.between(0.0, 0.5);
  laws::Touch& t = s.touch;
  t.radius = draw.decades(1e-7, 1e-1);
  t.mass = draw.decades(500.0, 2e4) * 4.19 * t.radius * t.radius * t.radius;
  // W so that the stretch at rupture is between a millionth and a tenth of the radius.
  const double stretch = t.radius * draw.decades(1e-6, 0.1);
  m.work_of_adhesion =
      m.effective_modulus / 3.14159265358979 * std::sqrt(std::pow(stretch / 0.75, 3) / t.radius);
  t.was_touching = draw.chance(0.9) ? 1.0 : 0.0;
  t.overlap = t.radius * draw.decades(1e-8, 0.2);
  if (normal_law == "jkr")
    t.overlap = draw.chance(0.5) ? stretch * draw.between(-0.9999, 5.0) : stretch * draw.decades(1e-3, 1e3);
  if (draw.chance(0.1)) t.overlap = t.radius * draw.between(-0.5, 0.0);
  t.normal = draw.direction();
  t.half_normal = t.normal + draw.vector(0.02);
  t.half_normal = t.half_normal / norm(t.half_normal);
  const double wave = std::sqrt(m.effective_modulus * t.radius * t.radius * t.radius / t.mass);  // m/s
  t.velocity = draw.vector(wave * draw.decades(1e-5, 1e-2));
  t.spin = draw.vector(wave / t.radius * draw.decades(1e-5, 1e-2));
  t.shared_spin = wave / t.radius * draw.between(-1e-2, 1e-2);
  t.dt = t.radius / wave * draw.decades(1e-3, 1e-1);
  m.rolling_viscosity = draw.between(0.0, 1.0);
  m.twisting_friction = draw.between(0.0, 0.5);
  m.normal_stiffness = draw.chance(0.5) ? 0.0 : m.effective_modulus * t.radius * draw.decades(1e-3, 1.0);
  m.characteristic_speed = wave * draw.decades(1e-4, 1e-1);
  m.tangential_ratio = draw.between(0.1, 1.0);
  m.plastic_ratio = draw.between(1.1, 20.0);
  m.adhesion_ratio = draw.between(0.0, 2.0);
  m.plasticity_depth = draw.decades(1e-3, 0.5);
  m.unloading_ratio = draw.between(1.1, 20.0);
  m.constant_pull = draw.chance(0.5) ? 0.0 : -m.effective_modulus * t.radius * t.radius * 1e-6;
  random_bodies(s, draw);
  random_cohesion(s, draw, cohesion);
  random_history(s, draw, normal_law, std::fabs(t.overlap) + stretch);
  return s;
}

/// The same for a whole law; springs that are forces start as forces, and what a law does not remember is zero.
inline RandomState random_state(const laws::Law& law, std::uint64_t number) {
  RandomState s = random_state(law.normal->name, number, law.cohesion->name);
  const double depth = std::fabs(s.touch.overlap) + 1e-9 * s.touch.radius;
  if (law.sliding->name == "incremental_spring" || law.sliding->name == "rescaled_spring")
    s.history.slide = (s.material.effective_modulus * std::sqrt(s.touch.radius * depth)) * s.history.slide;
  if (!law.sliding->remembers_grip) s.history.grip = 0.0;
  return s;
}

/// Error of a law against the reference relative to the sum of its terms.
inline double relative(double error, Quad terms) {
  return error == 0.0 ? 0.0 : error / static_cast<double>(terms);
}

}  // namespace pulvis::validation
