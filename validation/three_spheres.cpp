// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "validation/chapters.hpp"
#include "validation/collisions.hpp"
#include "validation/saddle.hpp"
#include "validation/sums.hpp"

// The saddle of three spheres through the engine: what holds there by statics, and what leaves.
namespace pulvis::validation {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double never = std::numeric_limits<double>::quiet_NaN();
constexpr const char* statics = "statics (validation/saddle.hpp)";
constexpr const char* energy = "energy of a rolling sphere (validation/saddle.hpp)";
constexpr double published_step = 1e-6;  // s
constexpr double longest = 1.0;          // s, until a sphere counts as held

/// Two small spheres that meet, s: the shortest contact time of all ratios.
double contact_time() { return 180.0 * degree * std::sqrt(0.5 * Saddle{}.mass() / Saddle::stiffness); }

/// The scene in the engine. It has no spheres that cannot move, so the two large ones are put to rest after
/// each step: with no load and no velocity they stay where they are, to the last bit.
class SaddleScene {
 public:
  SaddleScene(const Saddle& saddle, double rolling_friction, double dt)
      : simulation_(start(model(saddle, rolling_friction, dt), saddle)) {
    hold_large();
  }

  void step() {
    simulation_.step();
    hold_large();
  }
  const Parcel& small() const { return scenes::parcel_with_id(simulation_, 0); }
  bool touches_or_starts() const {
    return simulation_.state().step == 0 || scenes::touching(simulation_.pairs()) > 0;
  }
  bool fell_out() const { return !simulation_.state().escapes.empty(); }
  double time() const { return simulation_.time(); }

 private:
  static Simulation start(const Model& m, const Saddle& saddle) {
    const double large = saddle.large(), reach = large + Saddle::radius - saddle.overlap();
    const double height = std::sqrt(reach * reach - large * large);
    const Vec3 place = height * Vec3{0, std::sin(saddle.start), std::cos(saddle.start)};
    return Simulation(m,
                      scenes::state_of(m, {scenes::parcel(0, place, Saddle::radius, Saddle::density),
                                           scenes::parcel(1, {-large, 0, 0}, large, Saddle::density),
                                           scenes::parcel(2, {large, 0, 0}, large, Saddle::density)}),
                      1);
  }
  static Model model(const Saddle& saddle, double rolling_friction, double dt) {
    laws::MaterialPair pair;
    pair.normal_stiffness = Saddle::stiffness;
    pair.tangential_ratio = Saddle::tangential;
    pair.restitution = Saddle::restitution;
    pair.friction = saddle.friction;
    pair.rolling_friction = rolling_friction;
    const double far = 4.0 * saddle.large() + 8.0 * Saddle::radius;
    scenes::LawParts parts{"hooke", "restitution", "total_spring", "none", {}};
    if (rolling_friction > 0.0)
      parts.rolling = "elastic_plastic";
    else
      parts.choices.tangential_damping = false;  // as published; what must come to rest has it
    Model m = scenes::one_pair(pair, parts, {-far, -far, -far}, {far, far, far}, dt, Saddle::radius,
                               saddle.large());
    m.body_force.gravity = {0, 0, -Saddle::gravity};
    return m;
  }
  void hold_large() {
    Parcels& parcels = simulation_.state().parcels;
    for (std::size_t k = 0; k < parcels.size(); ++k) {
      if (parcels.body[k].id == 0) continue;
      parcels.body[k].velocity = parcels.body[k].spin = {};
      parcels.load[k] = {};
    }
  }
  Simulation simulation_;
};

/// How a sphere goes that nothing keeps from rolling.
struct Departure {
  double speed = never;           // m/s, along the circle, where it passes 30 degrees
  double angle = never;           // rad, where it has left both others
  Curve path{"", {}, {}, false};  // degrees over s
};

Departure departure(const Saddle& saddle, double dt) {
  SaddleScene scene(saddle, 0.0, dt);
  Departure d;
  const double between_points = 2e-3;  // s
  double before = saddle.start, speed_before = 0.0;
  while (scene.time() < longest && scene.touches_or_starts()) {
    scene.step();
    const Parcel& p = scene.small();
    const double angle = std::atan2(p.position.y, p.position.z), speed = norm(p.velocity);
    if (before < 30.0 * degree && angle >= 30.0 * degree)
      d.speed = speed_before + (speed - speed_before) * (30.0 * degree - before) / (angle - before);
    before = angle;
    speed_before = speed;
    if (scene.time() < between_points * static_cast<double>(d.path.x.size())) continue;
    d.path.x.push_back(scene.time());
    d.path.y.push_back(angle / degree);
  }
  if (!scene.touches_or_starts()) d.angle = before;
  return d;
}

/// Whether it still moves once its release has died away.
bool moves(const Saddle& saddle, double rolling_friction, double dt) {
  constexpr double settling = 0.05, watching = 0.05;  // s
  SaddleScene scene(saddle, rolling_friction, dt);
  while (scene.time() < settling && !scene.fell_out()) scene.step();
  if (scene.fell_out()) return true;
  const Vec3 there = scene.small().position;
  while (scene.time() < settling + watching && !scene.fell_out()) scene.step();
  if (scene.fell_out()) return true;
  // 0.1 % above the threshold it would go 0.2 um or more; at rest it rings by less than an overlap, 1e-9 m.
  return norm(scene.small().position - there) > 1e-8;
}

/// The smallest value of what holds it, looked for within 3 % of what statics says, to 0.05 %.
template <class Moves>
double threshold(double expected, const Moves& moves_at) {
  double low = 0.97 * expected, high = 1.03 * expected;
  if (!moves_at(low) || moves_at(high)) return never;
  for (int halving = 0; halving < 7; ++halving)
    (moves_at(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

double friction_shown(Saddle saddle, double dt) {
  return threshold(saddle.least_friction(), [&](double friction) {
    saddle.friction = friction;
    return moves(saddle, 10.0, dt);  // a rolling friction that nothing here overcomes
  });
}

double rolling_friction_shown(const Saddle& saddle, double dt) {
  return threshold(saddle.least_rolling_friction(),
                   [&](double rolling_friction) { return moves(saddle, rolling_friction, dt); });
}

void departs(Findings& f, const Saddle& saddle, double dt, double automatic, Figure& figure) {
  const Departure fine = departure(saddle, dt), coarse = departure(saddle, automatic);
  Row& speed = f.compare(
      fmt::format("size ratio {:g}: speed at 30 degrees of a sphere that may roll, m/s", saddle.ratio),
      energy, saddle.rolling_speed(30.0 * degree), fine.speed, Compare::relative, 1e-2);
  speed.automatic = coarse.speed;
  const double expected = leaving_angle(saddle, Plane::middle, published_step, longest);
  Row& leaves =
      f.compare(fmt::format("size ratio {:g}: angle at which it leaves, as it must, degrees", saddle.ratio),
                "own integration with a synchronised update", expected / degree, fine.angle / degree,
                Compare::relative, 1e-2);
  leaves.automatic = coarse.angle / degree;
  figure.curves.push_back(fine.path);
  figure.curves.back().label = fmt::format("size ratio {:g}", saddle.ratio);
}

void holds(Findings& f, const Saddle& saddle, double dt, double automatic) {
  Row& slides = f.compare(
      fmt::format("size ratio {:g}: friction that holds it at 20 degrees if it cannot roll", saddle.ratio),
      statics, saddle.least_friction(), friction_shown(saddle, dt), Compare::relative, 1e-2);
  slides.automatic = friction_shown(saddle, automatic);
  Row& rolls = f.compare(
      fmt::format("size ratio {:g}: rolling friction that holds it at 20 degrees", saddle.ratio), statics,
      saddle.least_rolling_friction(), rolling_friction_shown(saddle, dt), Compare::relative, 1e-2);
  rolls.automatic = rolling_friction_shown(saddle, automatic);
}

/// That the test can fail: the few lines of the own integration with another update of the springs.
void unsynchronised(Findings& f) {
  const double angle = leaving_angle({10.0, 0.5, 1.0 * degree}, Plane::end, published_step, longest);
  f.compare("size ratio 10: an unsynchronised update must fail here (1: it never leaves)",
            "Vyas et al. (2025), doi:10.1016/j.cpc.2025.109524: wrong above about 3", 1.0,
            std::isnan(angle) ? 1.0 : 0.0, Compare::absolute, 0.0);
}

}  // namespace

void three_spheres(Findings& f, Effort effort) {
  const double dt = effort == Effort::quick ? published_step : contact_time() / 1000.0;
  const double automatic = scenes::standard_step_fraction * contact_time();
  Figure figure{"three-spheres-departure",
                "A sphere rolls off the saddle between two large ones",
                "time (s)",
                "angle from the top (degrees)",
                {}};
  for (const double ratio : {1.0, 3.0, 10.0, 100.0}) {
    departs(f, {ratio, 0.5, 1.0 * degree}, dt, automatic, figure);
    // Statics: a shorter step changes nothing.
    holds(f, {ratio, 0.5, 20.0 * degree}, published_step, automatic);
  }
  f.figure(figure);
  unsynchronised(f);
}

}  // namespace pulvis::validation
