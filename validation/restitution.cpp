// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/chapters.hpp"
#include "validation/impacts.hpp"

// The dashpots pull shortly before the spheres part, and nothing clips that: a contact ends at zero overlap. So
// half a period of a damped oscillator returns e exactly, for the linear law as for Hertz with its dashpot.
namespace pulvis::validation {
namespace {

constexpr const char* antypov = "Antypov, Elliott (2011), doi:10.1209/0295-5075/94/50004";
constexpr const char* oscillator =
    "half a period of the damped linear oscillator, Tsuji et al. (1992), doi:10.1016/0032-5910(92)88030-L";
constexpr const char* johnson = "Johnson (1985), doi:10.1017/CBO9781139171731, section 11.4";

constexpr double characteristic_speed = 1.0;  // m/s
constexpr double given_stiffness = 5e4;       // N/m
constexpr double speeds[] = {0.01, 0.5, 5.0};

enum class Law { hooke_of_speed, hooke_given, hertz };
struct Kind {
  Law law;
  const char *name, *label;
  double limit;
};
constexpr Kind kinds[] = {{Law::hooke_of_speed, "Hooke, stiffness from speed", "Hooke k(V)", 5e-3},
                          {Law::hooke_given, "Hooke, stiffness given", "Hooke k", 5e-3},
                          {Law::hertz, "Hertz", "Hertz", 1e-2}};

const Ball grain{1e8, 0.3, 2500, 1e-3}, other_grain{2e9, 0.2, 7800, 2.5e-3};
struct Bodies {
  const char* name;
  std::optional<Ball> second;
};
const Bodies bodies[] = {{"like spheres", grain}, {"unlike spheres", other_grain}, {"wall", {}}};

/// k_n of (2) in normal/hooke.hpp, or as given, N/m.
double stiffness_of(const Meeting& m, Law law) {
  if (law == Law::hooke_given) return given_stiffness;
  const double size = std::sqrt(m.reduced_radius()) * m.modulus();
  return 16.0 / 15.0 * size *
         std::pow(15.0 * m.reduced_mass() * characteristic_speed * characteristic_speed / (16.0 * size), 0.2);
}

/// Of an impact without damping, s.
double elastic_duration(const Meeting& m, Law law) {
  if (law == Law::hertz) return m.duration();
  return std::numbers::pi * std::sqrt(m.reduced_mass() / stiffness_of(m, law));
}

Shown shown_by(const Meeting& m, Law law) {
  scenes::Collision c = collision_of(m);
  if (law != Law::hertz) {
    c.parts.normal = "hooke";
    if (law == Law::hooke_given)
      c.material.normal_stiffness = given_stiffness;
    else
      c.material.characteristic_speed = characteristic_speed;
  }
  return shown(c, elastic_duration(m, law), rayleigh_time_of(m));
}

/// The restitution furthest from what was asked for, of all speeds and instants of touch.
struct Worst {
  double fine, automatic;
};
Worst worst_of(const Bodies& who, Law law, double e) {
  Worst worst{e, e};
  const auto take = [&](double& kept, const std::vector<scenes::Outcome>& outcomes, double speed) {
    const double one = furthest(outcomes, e, [&](const scenes::Outcome& o) { return o.speed / speed; });
    if (!(std::fabs(one - e) <= std::fabs(kept - e))) kept = one;
  };
  for (const double speed : speeds) {
    Meeting m{grain, who.second, e};
    m.normal_speed = speed;
    const Shown s = shown_by(m, law);
    take(worst.fine, s.fine, speed);
    take(worst.automatic, s.automatic, speed);
  }
  return worst;
}

void asked_and_shown(Findings& f) {
  Figure figure{"restitution-error",
                "Restitution: largest deviation",
                "restitution asked for",
                "|shown / asked - 1|",
                {}};
  figure.log_y = true;
  for (const Kind& kind : kinds) {
    Curve fine{fmt::format("{}, t_c/1000", kind.label), {}, {}, true},
        automatic{fmt::format("{}, automatic", kind.label), {}, {}, false};
    for (const double e : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95}) {
      double off = 0.0, automatic_off = 0.0;
      for (const Bodies& who : bodies) {
        const Worst worst = worst_of(who, kind.law, e);
        f.compare(fmt::format("restitution {:g}, {}, {}", e, kind.name, who.name),
                  kind.law == Law::hertz ? antypov : oscillator, e, worst.fine, Compare::relative, kind.limit)
            .automatic = worst.automatic;
        off = std::max(off, std::fabs(worst.fine / e - 1.0));
        automatic_off = std::max(automatic_off, std::fabs(worst.automatic / e - 1.0));
      }
      fine.x.push_back(e), fine.y.push_back(off);
      automatic.x.push_back(e), automatic.y.push_back(automatic_off);
    }
    figure.curves.push_back(fine);
    figure.curves.push_back(automatic);
  }
  f.figure(figure);
}

/// Force, overlap and duration of impacts without damping, between unlike spheres.
void peaks(Findings& f) {
  for (const Kind& kind : kinds) {
    Meeting m{grain, other_grain};
    m.normal_speed = 0.5;
    const Shown s = shown_by(m, kind.law);
    const bool hertz = kind.law == Law::hertz;
    const char* source = hertz ? johnson : oscillator;
    const double k = stiffness_of(m, kind.law),
                 overlap = hertz ? m.largest_overlap() : m.normal_speed * std::sqrt(m.reduced_mass() / k);
    compare_shown(f, fmt::format("largest force, N, e = 1, {}, unlike spheres", kind.name), source,
                  hertz ? m.largest_force() : k * overlap, s, Compare::relative, 1e-3,
                  [](const scenes::Outcome& o) { return o.largest_force; });
    compare_shown(f, fmt::format("largest overlap, m, e = 1, {}, unlike spheres", kind.name), source, overlap,
                  s, Compare::relative, 1e-3, [](const scenes::Outcome& o) { return o.largest_overlap; });
    compare_shown(f, fmt::format("duration, s, e = 1, {}, unlike spheres", kind.name), source,
                  elastic_duration(m, kind.law), s, Compare::relative, 1e-3,
                  [](const scenes::Outcome& o) { return o.duration; });
  }
}

/// A wall and a pair with the same R* and m* are the same to the law.
void pair_and_wall(Findings& f) {
  Meeting wall{grain, {}, 0.6};
  wall.normal_speed = 0.5;
  Meeting pair = wall;
  pair.first.radius = 2.0 * grain.radius;
  pair.first.density = 2.0 / 8.0 * grain.density;
  pair.second = pair.first;
  scenes::Collision at_wall = collision_of(wall), of_pair = collision_of(pair);
  of_pair.material = at_wall.material;
  at_wall.dt = of_pair.dt = wall.duration() / 1000.0;
  const scenes::Outcome a = collide(at_wall), b = collide(of_pair);
  double worst = 0.0;
  for (const double ratio : {b.largest_force / a.largest_force, b.speed / a.speed, b.duration / a.duration})
    worst = std::max(worst, std::fabs(ratio - 1.0));
  f.compare("pair against wall of the same R*, m*: force, speed, duration, worst of 3", "itself", 0.0, worst,
            Compare::bound, 1e-9);
}

}  // namespace

void restitution(Findings& f, Effort /*takes a second*/) {
  asked_and_shown(f);
  peaks(f);
  pair_and_wall(f);
}

}  // namespace pulvis::validation
