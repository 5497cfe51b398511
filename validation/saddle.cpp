// SPDX-License-Identifier: Apache-2.0
#include "validation/saddle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/math/vec3.hpp"

namespace pulvis::validation {
namespace {

Vec3 across(const Vec3& a, const Vec3& n) { return a - dot(a, n) * n; }

/// A vector across the unit vector n, turned about it by an angle (rad).
Vec3 turned(const Vec3& a, const Vec3& n, double angle) {
  return std::cos(angle) * a + std::sin(angle) * cross(n, a);
}

/// The moving sphere, and the spring at each of its contacts.
struct Mover {
  Vec3 position, velocity, spin, force, torque;
  Vec3 spring[2];
};

/// Contacts at the end of a step in whose middle the centre was at `middle`; false if there is none.
bool push(Mover& s, const Vec3& middle, const Saddle& saddle, Plane plane, double dt) {
  const double decay = -std::log(Saddle::restitution);
  const double damping = 2.0 * decay / std::sqrt(decay * decay + std::numbers::pi * std::numbers::pi) *
                         std::sqrt(Saddle::stiffness * saddle.mass());
  bool touches = false;
  s.force = {0, 0, -saddle.mass() * Saddle::gravity};
  s.torque = {};
  for (int side = 0; side < 2; ++side) {
    const Vec3 other{side == 0 ? saddle.large() : -saddle.large(), 0, 0};
    const Vec3 between = other - s.position, between_middle = other - middle;
    const double distance = norm(between), overlap = saddle.large() + Saddle::radius - distance;
    Vec3& spring = s.spring[side];
    if (overlap <= 0.0) {
      spring = {};
      continue;
    }
    touches = true;
    const Vec3 n = (1.0 / distance) * between, n_middle = (1.0 / norm(between_middle)) * between_middle;
    // All that the two kinds of update differ in: the normal that goes with the mid-step velocity.
    const Vec3& m = plane == Plane::middle ? n_middle : n;
    const double arm = Saddle::radius - 0.5 * overlap;
    const Vec3 velocity = s.velocity + cross(s.spin, arm * m);
    const double closing = dot(velocity, m);
    spring =
        across(turned(across(spring, m), m, 0.5 * dot(s.spin, m) * dt) + dt * (velocity - closing * m), n);
    const double push = Saddle::stiffness * overlap, limit = saddle.friction * push;
    const double pull = Saddle::tangential * Saddle::stiffness * norm(spring);
    if (pull > limit) spring = (limit / pull) * spring;
    const Vec3 friction = -(Saddle::tangential * Saddle::stiffness) * spring;
    s.force += friction - (push + damping * closing) * n;
    s.torque += cross(arm * n, friction);
  }
  return touches;
}

}  // namespace

double Saddle::circle() const { return std::sqrt(radius * radius + 2.0 * large() * radius); }
double Saddle::share() const { return circle() / (large() + radius); }
double Saddle::mass() const { return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }
double Saddle::overlap() const { return mass() * gravity * std::cos(start) / (2.0 * share() * stiffness); }
double Saddle::least_friction() const { return share() * std::tan(start); }
double Saddle::least_rolling_friction() const {
  return share() * std::tan(start) * (large() + radius) / large();
}

double Saddle::rolling_speed(double phi) const {
  const double fallen = circle() * (std::cos(start) - std::cos(phi));
  return std::sqrt(2.0 * gravity * fallen / (1.0 + 0.4 / (share() * share())));
}

double leaving_angle(const Saddle& saddle, Plane plane, double dt, double seconds) {
  const double reach = saddle.large() + Saddle::radius - saddle.overlap();
  const double height = std::sqrt(reach * reach - saddle.large() * saddle.large());
  Mover s;
  s.position = {0, height * std::sin(saddle.start), height * std::cos(saddle.start)};
  const double mass = saddle.mass(), inertia = 0.4 * mass * Saddle::radius * Saddle::radius;
  for (double time = 0.0; time < seconds; time += dt) {
    s.velocity += (0.5 * dt / mass) * s.force;
    s.spin += (0.5 * dt / inertia) * s.torque;
    const Vec3 middle = s.position + (0.5 * dt) * s.velocity;
    s.position += dt * s.velocity;
    const bool touches = push(s, middle, saddle, plane, dt);
    s.velocity += (0.5 * dt / mass) * s.force;
    s.spin += (0.5 * dt / inertia) * s.torque;
    if (!touches) return std::atan2(s.position.y, s.position.z);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace pulvis::validation
