// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

// Impacts of two spheres, or of one on a rigid plane, without the engine: what Hertz gives in closed form, and the law of
// Hertz and Mindlin integrated step by step.
namespace pulvis::validation {

/// A sphere and what it is made of. SI.
struct Ball {
  double modulus, poisson, density, radius;

  double mass() const { return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }
  double compliance() const { return (1.0 - poisson * poisson) / modulus; }
  double shear_compliance() const { return 2.0 * (2.0 - poisson) * (1.0 + poisson) / modulus; }
};

/// How a ball meets a ball at rest, or a rigid plane. Tangential speed along x, spin about y, normal along z.
struct Meeting {
  Ball first;
  std::optional<Ball> second;  ///< none: a rigid plane
  double restitution = 1.0, friction = 0.0;
  double normal_speed = 0.0, tangential_speed = 0.0;  ///< m/s, closing
  double spin = 0.0;                                  ///< rad/s, of the first

  double reduced_mass() const { return 1.0 / (1.0 / first.mass() + (second ? 1.0 / second->mass() : 0.0)); }
  double reduced_radius() const { return 1.0 / (1.0 / first.radius + (second ? 1.0 / second->radius : 0.0)); }
  double modulus() const { return 1.0 / (first.compliance() + (second ? second->compliance() : 0.0)); }
  double shear_modulus() const {
    return 1.0 / (first.shear_compliance() + (second ? second->shear_compliance() : 0.0));
  }
  /// Slip where they touch first, m/s.
  double slip() const { return tangential_speed - first.radius * spin; }

  // Elastic impact: K. L. Johnson, Contact Mechanics (1985), doi:10.1017/CBO9781139171731, section 11.4.
  double largest_overlap() const {
    return std::pow(15.0 * reduced_mass() * normal_speed * normal_speed /
                        (16.0 * modulus() * std::sqrt(reduced_radius())),
                    0.4);
  }
  double largest_force() const {
    return 4.0 / 3.0 * modulus() * std::sqrt(reduced_radius()) * std::pow(largest_overlap(), 1.5);
  }
  double duration() const { return 2.943275 * largest_overlap() / normal_speed; }
};

/// What comes of it.
struct Parted {
  double velocity;  ///< m/s along x, of the first against the second
  double spin;      ///< rad/s, of the first
  double slip;      ///< m/s
};

/// Where friction acts: at the contact, R - delta/2 from a centre (R - delta at a plane), or, as published tables have
/// it, on the undeformed surface.
enum class Lever { to_contact, radius };

/// Hertz with the dashpot of Antypov and Elliott (2011), doi:10.1209/0295-5075/94/50004; tangential spring
/// of the whole displacement with k_t = 8 G* a, dashpot while it sticks, Coulomb's limit on the elastic normal
/// force (`total_limit`: with the dashpot). Steps of an n-th of the elastic contact time: off by 1/n.
inline Parted integrate(const Meeting& m, int n = 200000, Lever kind = Lever::to_contact,
                        bool total_limit = false) {
  const double modulus = m.modulus(), shear = m.shear_modulus(), radius = m.reduced_radius(),
               mass = m.reduced_mass();
  const double log_e = std::log(m.restitution);
  const double factor =
      -2.0 * std::sqrt(5.0 / 6.0) * log_e / std::sqrt(log_e * log_e + std::numbers::pi * std::numbers::pi);
  const auto inertia = [](const Ball& b) { return 0.4 * b.mass() * b.radius * b.radius; };
  const double of_first = 1.0 / inertia(m.first), of_second = m.second ? 1.0 / inertia(*m.second) : 0.0;
  const double second_radius = m.second ? m.second->radius : 0.0;
  const double share = kind == Lever::radius ? 0.0 : m.second ? 0.5 : 1.0;
  const double dt = m.duration() / n;
  double delta = 0.0, closing = m.normal_speed, velocity = m.tangential_speed, omega = m.spin, other = 0.0,
         spring = 0.0;
  do {
    delta += closing * dt;
    const double arm = m.first.radius - share * delta, other_arm = second_radius - share * delta;
    const double slip = velocity - arm * omega - other_arm * other;
    const double a = std::sqrt(radius * std::max(delta, 0.0)), elastic = 4.0 / 3.0 * modulus * a * delta;
    const double dashpot = factor * std::sqrt(2.0 * modulus * a * mass) * closing,
                 stiffness = 8.0 * shear * a;
    const double limit = m.friction * std::fabs(elastic + (total_limit ? dashpot : 0.0));
    spring += slip * dt;
    double force;
    if (stiffness * std::fabs(spring) > limit) {
      force = std::copysign(limit, -spring);
      spring = -force / stiffness;
    } else {
      force = -stiffness * spring - factor * std::sqrt(stiffness * mass) * slip;
    }
    closing -= (elastic + dashpot) / mass * dt;
    velocity += force / mass * dt;
    omega -= arm * force * of_first * dt;
    other -= other_arm * force * of_second * dt;
  } while (delta > 0.0);
  return {velocity, omega, velocity - m.first.radius * omega - second_radius * other};
}

}  // namespace pulvis::validation
