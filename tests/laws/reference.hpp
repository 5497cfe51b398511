// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <string_view>

#include "engine/laws/catalogue.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/quad.hpp"

// The contact laws a second time, in 113 bits, written from the original equations and sharing nothing with
// the engine. Next to every result stands the sum of the magnitudes of the terms it is made of: cancellation
// between terms is a property of the physics, so errors are measured against that sum.
namespace pulvis::testing {

/// JKR's contact radius for an overlap: the larger root of  delta = a^2/R - sqrt(2 pi W a/E), by bisection
/// (Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; in this form Thornton and Ning, Powder
/// Technol. 99 (1998) 154). Below the stretch at rupture it stays at the radius of rupture.
inline Quad jkr_radius(Quad overlap, Quad radius, Quad modulus, Quad work) {
  const Quad pi = quad_pi();
  const auto overlap_of = [&](Quad a) { return a * a / radius - quad_root(2 * pi * work * a / modulus); };
  Quad low = quad_cube_root(pi * work * radius * radius / (8 * modulus));  // where d(delta)/da = 0
  Quad high = low;
  while (overlap_of(high) < overlap) high *= 2;
  for (int halving = 0; halving < 130; ++halving) {
    const Quad middle = (low + high) / 2;
    (overlap_of(middle) < overlap ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Stretch at rupture, m, from a_c in delta(a).
inline Quad jkr_stretch_at_rupture(Quad radius, Quad modulus, Quad work) {
  const Quad pi = quad_pi();
  const Quad a = quad_cube_root(pi * work * radius * radius / (8 * modulus));
  return quad_root(2 * pi * work * a / modulus) - a * a / radius;
}

struct ReferenceNormal {
  Quad force = 0, terms = 0;  ///< N
  Quad contact_size = 0, damping_size = 0;
  Quad limit_shift = 0;
};

inline ReferenceNormal reference_normal(std::string_view law, Quad overlap, Quad radius,
                                        const laws::MaterialPair& m) {
  const Quad modulus = m.effective_modulus, work = m.work_of_adhesion;
  ReferenceNormal n;
  n.damping_size = quad_root(radius * (overlap > 0 ? overlap : Quad{0}));
  if (law == "hertz") {
    // Hertz (1881): F = 4/3 E sqrt(R) delta^(3/2).
    n.contact_size = n.damping_size;
    n.force = n.terms = Quad{4} / 3 * modulus * quad_root(radius) * overlap * quad_root(overlap);
    return n;
  }
  // JKR: F = 4 E a^3/(3 R) - sqrt(8 pi W E a^3).
  const Quad a = jkr_radius(overlap, radius, modulus, work);
  const Quad pressed = 4 * modulus * a * a * a / (3 * radius);
  const Quad pulled = quad_root(8 * quad_pi() * work * modulus * a * a * a);
  n.contact_size = a;
  n.force = pressed - pulled;
  n.terms = pressed + pulled;
  n.limit_shift = 3 * quad_pi() * work * radius;  // 2 F_po with F_po = 3/2 pi W R
  return n;
}

/// -2 sqrt(5/6) beta sqrt(S m*) with beta = ln e/sqrt(ln^2 e + pi^2).
inline Quad reference_dashpot(Quad stiffness, Quad mass, double restitution) {
  const Quad log_e = std::log(static_cast<long double>(restitution));
  const Quad beta = log_e / quad_root(log_e * log_e + quad_pi() * quad_pi());
  return -2 * quad_root(Quad{5} / 6) * beta * quad_root(stiffness * mass);
}

inline QuadVec reference_in_plane(const QuadVec& a, const QuadVec& n) { return a - dot(a, n) * n; }

struct ReferenceResponse {
  bool touching = false;
  QuadVec force, tangential, roll_torque, slide, roll;
  Quad force_terms = 0, tangential_terms = 0, torque_terms = 0, slide_terms = 0;
  bool on_the_edge = false;  ///< so near a limit that rounding decides which side it is on
};

inline ReferenceResponse reference_response(const laws::Law& law, const laws::Touch& t,
                                            const laws::History& old, const laws::MaterialPair& m,
                                            const laws::Choices& choices) {
  const Quad overlap = t.overlap, radius = t.radius, mass = t.mass, dt = t.dt;
  const QuadVec normal = quad(t.normal), half = quad(t.half_normal);
  ReferenceResponse r;
  const bool adhesive = law.normal->name == "jkr";
  const Quad stretch =
      adhesive ? jkr_stretch_at_rupture(radius, m.effective_modulus, m.work_of_adhesion) : Quad{0};
  r.touching = t.was_touching > 0.5 ? overlap > -stretch : overlap > 0;
  if (!r.touching) return r;

  const ReferenceNormal n = reference_normal(law.normal->name, overlap, radius, m);
  const Quad dashpot_radius = choices.damping_on_jkr_radius ? n.contact_size : n.damping_size;
  const bool damped = law.damping->name == "restitution";
  const Quad shear = 8 * static_cast<Quad>(m.effective_shear_modulus);
  const Quad c_normal = damped
                            ? reference_dashpot(2 * static_cast<Quad>(m.effective_modulus) * dashpot_radius,
                                                mass, m.restitution)
                            : 0;
  const Quad c_tangential = damped ? reference_dashpot(shear * dashpot_radius, mass, m.restitution) : 0;

  const QuadVec velocity = quad(t.velocity);
  const Quad closing = dot(velocity, half);
  const QuadVec slip = velocity - closing * half;
  const Quad dashpot = c_normal * closing;
  const Quad in_limit = choices.limit_includes_dashpot ? dashpot : Quad{0};
  const Quad limiting = quad_magnitude(n.force + n.limit_shift + in_limit);
  const Quad limiting_terms = n.terms + n.limit_shift + quad_magnitude(in_limit);

  if (law.sliding->name == "total_spring") {
    const Quad stiffness = shear * n.contact_size;
    const QuadVec spring = reference_in_plane(reference_in_plane(quad(old.slide), half) + dt * slip, normal);
    const Quad spring_terms = norm(quad(old.slide)) + dt * norm(velocity);
    const Quad length = norm(spring), limit = static_cast<Quad>(m.friction) * limiting;
    r.on_the_edge |= quad_magnitude(stiffness * length - limit) < 1e-9 * (stiffness * spring_terms + limit);
    if (stiffness * length > limit) {
      r.slide = (limit / (stiffness * length)) * spring;
      r.tangential = (-limit / length) * spring;
      // The direction of the spring is as uncertain as the spring against what it was summed from.
      r.tangential_terms = static_cast<Quad>(m.friction) * limiting_terms + limit * spring_terms / length;
      r.slide_terms = r.tangential_terms / stiffness;
    } else {
      r.slide = spring;
      r.tangential = (-stiffness) * spring - c_tangential * reference_in_plane(slip, normal);
      r.tangential_terms = stiffness * spring_terms + c_tangential * norm(velocity);
      r.slide_terms = spring_terms;
    }
  }
  if (law.rolling->name == "elastic_plastic") {
    const Quad stiffness = shear * n.contact_size * radius * radius;
    const QuadVec spin = reference_in_plane(quad(t.spin), half);
    const QuadVec torque =
        reference_in_plane(reference_in_plane(quad(old.roll), half) - (stiffness * dt) * spin, normal);
    const Quad terms = norm(quad(old.roll)) + stiffness * dt * norm(quad(t.spin));
    const Quad size = norm(torque), limit = static_cast<Quad>(m.rolling_friction) * radius * limiting;
    r.roll_torque = size > limit ? (limit / size) * torque : torque;
    r.torque_terms =
        size > limit ? static_cast<Quad>(m.rolling_friction) * radius * limiting_terms + limit * terms / size
                     : terms;
    r.roll = r.roll_torque;
  }
  const Quad normal_force = n.force + dashpot;
  r.force = r.tangential - normal_force * normal;
  r.force_terms = r.tangential_terms + n.terms + c_normal * norm(velocity);
  return r;
}

/// A random pair of materials: anything from gel to steel, dust to gravel.
struct RandomState {
  laws::MaterialPair material;
  laws::Touch touch;
  laws::History history;
};

inline RandomState random_state(std::string_view normal_law, std::uint64_t number) {
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
  t.dt = t.radius / wave * draw.decades(1e-3, 1e-1);
  const double depth = std::fabs(t.overlap) + stretch;
  s.history.slide = draw.chance(0.1) ? Vec3{} : draw.vector(depth * draw.decades(1e-3, 3.0));
  s.history.roll =
      draw.chance(0.1)
          ? Vec3{}
          : draw.vector(m.effective_modulus * t.radius * t.radius * depth * draw.decades(1e-4, 1.0));
  return s;
}

/// Error of a law against the reference relative to the sum of its terms.
inline double relative(double error, Quad terms) {
  return error == 0.0 ? 0.0 : error / static_cast<double>(terms);
}

}  // namespace pulvis::testing
