// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "validation/chapters.hpp"
#include "validation/incline.hpp"
#include "validation/rolling_pile.hpp"

namespace pulvis::validation {
namespace {

using scenes::Incline;
using scenes::run_to;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr const char* ai = "closed form of the tests of Ai et al. (2011), doi:10.1016/j.powtec.2010.09.030";

struct RollingModel {
  const char* name;
  const char* short_name;
};
constexpr RollingModel models[] = {
    {"constant_torque", "CDT"}, {"elastic_plastic_viscous", "EPSD"}, {"elastic_plastic", "EPSD2"}};

const Parcel& sphere(const Simulation& s) { return s.state().parcels.body[0]; }

// --- TC0: which rolling friction holds a sphere on a slope -------------------------------------------------

bool rolls(const Incline& incline) {
  constexpr double interval = 0.2;  // s
  Simulation s = incline.start();
  run_to(s, interval);
  const double first = sphere(s).position.x;
  run_to(s, 2.0 * interval);
  // Released at once onto its spring it begins with a small speed. Then it speeds up, or slows down and settles, or
  // creeps (as CDT does, whose torque flips from step to step) as far in one interval as in the other.
  return sphere(s).position.x - first > 1.1 * std::fabs(first);
}

/// The least rolling friction at which it does not roll, looked for within 3 % of tan(angle), to 0.05 %.
double least_rolling_friction(Incline incline) {
  const auto rolls_at = [&](double share) {
    incline.rolling_friction = share * std::tan(incline.angle);
    return rolls(incline);
  };
  double low = 0.97, high = 1.03;
  if (!rolls_at(low) || rolls_at(high)) return never;
  for (int halving = 0; halving < 6; ++halving)
    (rolls_at(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high) * std::tan(incline.angle);
}

void thresholds(Findings& f, double dt) {
  for (const RollingModel& model : models)
    for (const double angle : {4.0, 8.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0}) {
      Incline incline{.angle = angle * degree, .friction = 0.8, .dt = dt, .rolling = model.name};
      Row& row =
          f.compare(fmt::format("TC0 {}: rolling friction that holds a sphere at {:g} degrees",
                                model.short_name, angle),
                    ai, std::tan(angle * degree), least_rolling_friction(incline), Compare::relative, 1e-2);
      incline.dt = Incline::automatic_step();
      row.automatic = least_rolling_friction(incline);
    }
}

// --- TC1, TC2: a sphere pushed without spin, on the level and up a slope ------------------------------------

/// Up the slope (angle >= 0), from v0 without spin, friction mu, rolling friction mu_r (c, s: cosine and sine):
///   while it slides  dv/dt = -g (mu c + s),  R domega/dt = (5/2) (mu - mu_r) g c  [m/s^2]
///   while it rolls   dv/dt = -(5/7) g (mu_r c + s)                                [m/s^2]
struct Push {
  double grip_time, stop_time;      // s: slip ends, the sphere stops
  double distance;                  // m
  double slip_torque, roll_torque;  // N m about the centre, positive: it spins up
};

constexpr double friction = 0.8, rolling_friction = 0.2;

Push expected(double angle) {
  const double g = Incline::gravity, c = std::cos(angle), s = std::sin(angle);
  const double inertia = 0.4 * Incline::mass() * Incline::radius * Incline::radius;
  const double slowing = g * (friction * c + s), spinning = 2.5 * (friction - rolling_friction) * g * c,
               rolling = g * (rolling_friction * c + s) / 1.4;
  Push p;
  p.grip_time = 1.0 / (slowing + spinning);
  const double speed = 1.0 - slowing * p.grip_time;
  p.stop_time = p.grip_time + speed / rolling;
  p.distance = 0.5 * (1.0 + speed) * p.grip_time + 0.5 * speed * speed / rolling;
  p.slip_torque = inertia * spinning / Incline::radius;
  p.roll_torque = -inertia * rolling / Incline::radius;
  return p;
}

struct Shown : Push {
  double later;  // m: where it is 0.3 s after the expected stop
  Curve path;    // m over s
};

Shown push(const RollingModel& model, double angle, double dt) {
  // It is pushed against x, down which the slope falls.
  const Incline incline{angle, friction, rolling_friction, 0.3, -1.0, dt, model.name};
  const Push known = expected(angle);
  Simulation s = incline.start();
  Shown p{{never, never, never, never, never}, never, {model.short_name, {}, {}, false}};
  // Mean torques over the middle of each part of the motion, from the spin gained.
  const double moments[] = {0.25 * known.grip_time, 0.75 * known.grip_time,
                            0.6 * known.grip_time + 0.4 * known.stop_time,
                            0.2 * known.grip_time + 0.8 * known.stop_time};
  double marks[4] = {}, spins[4] = {};
  std::size_t next = 0;
  while (s.time() < known.stop_time + 0.3) {
    s.step();
    const Parcel& q = sphere(s);
    const double speed = -q.velocity.x, spin = -q.spin.y;
    if (std::isnan(p.grip_time) && speed <= Incline::radius * spin) p.grip_time = s.time();
    if (std::isnan(p.stop_time) && speed <= 0.0) p.stop_time = s.time(), p.distance = -q.position.x;
    if (next < 4 && s.time() >= moments[next]) marks[next] = s.time(), spins[next] = spin, ++next;
    if (s.state().step % std::lround(4e-3 / dt) != 0) continue;
    p.path.x.push_back(s.time());
    p.path.y.push_back(-q.position.x);
  }
  const double moment = inertia(sphere(s));
  p.slip_torque = moment * (spins[1] - spins[0]) / (marks[1] - marks[0]);
  p.roll_torque = moment * (spins[3] - spins[2]) / (marks[3] - marks[2]);
  p.later = -sphere(s).position.x;
  return p;
}

void pushed(Findings& f, const char* test, double angle, double dt) {
  const Push known = expected(angle);
  Figure figure{fmt::format("rolling-{}", test),
                fmt::format("{}: a sphere pushed without spin", test),
                "time (s)",
                "way (m)",
                {}};
  for (const RollingModel& model : models) {
    const Shown fine = push(model, angle, dt), coarse = push(model, angle, Incline::automatic_step());
    const auto row = [&](const char* what, double Push::*value) {
      Row& r = f.compare(fmt::format("{} {}: {}", test, model.short_name, what), ai, known.*value,
                         fine.*value, Compare::relative, 5e-3);
      r.automatic = coarse.*value;
    };
    row("way until it stops, m", &Push::distance);
    row("time until it stops, s", &Push::stop_time);
    row("time at which slip ends, s", &Push::grip_time);
    row("torque while it slides, N m", &Push::slip_torque);
    row("torque while it rolls, N m", &Push::roll_torque);
    // On a slope CDT creeps down: its torque flips from step to step.
    const bool stays = angle == 0.0 || std::string_view(model.short_name) != "CDT";
    Row& later = f.compare(
        fmt::format("{} {}: way 0.3 s after it should have stopped, m", test, model.short_name), ai,
        known.distance, fine.later, Compare::relative, stays ? std::optional<double>(5e-3) : std::nullopt);
    later.automatic = coarse.later;
    figure.curves.push_back(fine.path);
  }
  f.figure(figure);
}

}  // namespace

void rolling(Findings& f, Effort effort) {
  const double dt = effort == Effort::quick ? Incline::published_step : Incline::contact_time() / 1000.0;
  thresholds(f, Incline::published_step);  // statics: a shorter step changes nothing
  pushed(f, "TC1", 0.0, dt);
  pushed(f, "TC2", 10.0 * degree, dt);
  rolling_pile(f, effort);
}

}  // namespace pulvis::validation
