// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/path.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/math/largest.hpp"

namespace pulvis::motions {
namespace {

/// The way from the start of a piece, u seconds after it: u (first + u (second + u third)).
struct Piece {
  Vec3 first, second, third;

  Vec3 way(double u) const { return u * (first + u * (second + u * third)); }
  Vec3 velocity(double u) const { return first + u * (2.0 * second + (3.0 * u) * third); }
  Vec3 acceleration(double u) const { return 2.0 * second + (6.0 * u) * third; }
};

double step(const Path& p, std::size_t i) { return p.times[i + 1] - p.times[i]; }
Vec3 slope(const Path& p, std::size_t i) { return (p.positions[i + 1] - p.positions[i]) / step(p, i); }

/// Velocity at a point between two pieces of slope s0 and s1 and length h0 and h1.
double limited(double s0, double s1, double h0, double h1) {
  if (!(s0 * s1 > 0.0)) return 0.0;
  const double parabola = magnitude(s0 * h1 + s1 * h0) / (h0 + h1);
  const double size = least(2.0 * least(magnitude(s0), magnitude(s1)), parabola);
  return s0 > 0.0 ? size : -size;
}

/// Velocity at the free end of a piece of slope s and length h; the next piece inwards has s1 and h1.
double limited_at_end(double s, double s1, double h, double h1) {
  const double parabola = s + (s - s1) * (h / (h + h1));
  if (!(parabola * s > 0.0)) return 0.0;
  const double size = least(magnitude(parabola), 2.0 * magnitude(s));
  return s > 0.0 ? size : -size;
}

Vec3 velocity_at(const Path& p, std::size_t i) {
  const std::size_t last = p.times.size() - 1;
  if (last == 1) return slope(p, 0);
  const bool end = i == 0 || i == last;
  const std::size_t before = i == 0 ? 0 : i - 1;           // at an end: the piece itself,
  const std::size_t after = i == 0 ? 1 : end ? i - 2 : i;  // and the next one inwards
  const Vec3 s0 = slope(p, before), s1 = slope(p, after);
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis)
    v[axis] = (end ? limited_at_end : limited)(s0[axis], s1[axis], step(p, before), step(p, after));
  return v;
}

Piece piece(const Path& p, std::size_t i) {
  const Vec3 s = slope(p, i);
  if (p.between == Path::Between::linear) return {s, {}, {}};
  const double h = step(p, i);
  const Vec3 v0 = velocity_at(p, i), v1 = velocity_at(p, i + 1);
  return {v0, (3.0 * s - 2.0 * v0 - v1) / h, (v0 + v1 - 2.0 * s) / (h * h)};
}

}  // namespace

Rigid Path::displacement(double t) const {
  if (t <= times.front()) return {};
  if (t >= times.back()) return Rigid::translation(positions.back() - positions.front());
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  const auto i = static_cast<std::size_t>(next - times.begin()) - 1;
  return Rigid::translation((positions[i] - positions.front()) + piece(*this, i).way(t - times[i]));
}

Peaks Path::peaks() const {
  Peaks peaks;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Piece cubic = piece(*this, i);
    const double h = step(*this, i);
    const double speed = largest_between(0.0, h, 16, [&](double u) { return norm(cubic.velocity(u)); });
    peaks.speed = greatest(peaks.speed, speed);
    // The acceleration is linear in time, so largest at an end.
    const double ends = greatest(norm(cubic.acceleration(0.0)), norm(cubic.acceleration(h)));
    peaks.acceleration = greatest(peaks.acceleration, ends);
  }
  return peaks;
}

Fault Path::fault() const {
  if (times.size() != positions.size())
    return fmt::format("it has {} times, but {} positions", times.size(), positions.size());
  if (times.size() < 2) return "it needs at least two times and positions";
  for (std::size_t i = 0; i < times.size(); ++i)
    if (const Fault fault =
            first_of({unless_finite("time", times[i]), unless_finite("position", positions[i])}))
      return fmt::format("point {}: {}", i + 1, *fault);
  if (times.front() < 0.0) return fmt::format("the first time is negative: {:g} s", times.front());
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      return fmt::format("point {}: the times must ascend, but {:g} s follows {:g} s", i + 1, times[i],
                         times[i - 1]);
  return std::nullopt;
}

}  // namespace pulvis::motions
