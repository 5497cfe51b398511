// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/walls/motions/motion.hpp"
#include "validation/draw.hpp"

// Motions of all kinds with random numbers in them, and sines to hold them against.
namespace pulvis::validation {

inline constexpr double two_pi = 2.0 * std::numbers::pi;

/// sin(2 pi x) in long double.
inline long double true_sine(long double cycles) {
  return std::sin(2.0L * std::numbers::pi_v<long double> * std::remainder(cycles, 1.0L));
}

inline motions::Wave some_wave(Draw& draw) {
  return {draw.decades(1e-5, 1e-2), draw.decades(1.0, 200.0), draw.between(-1.0, 1.0)};
}

inline motions::SquareWave some_square_wave(Draw& draw) {
  motions::SquareWave m{draw.decades(1e-5, 1e-2), draw.decades(1.0, 200.0), draw.direction(), {}, {}};
  if (draw.chance(0.7)) m.rise_time = draw.decades(0.01, 0.5) / m.frequency;
  if (draw.chance(0.7)) m.modulation_period = draw.decades(1.0, 50.0) / m.frequency;
  return m;
}

inline motions::Path some_path(Draw& draw, motions::Path::Between between, std::size_t points) {
  motions::Path m;
  m.between = between;
  for (std::size_t i = 0; i < points; ++i) {
    m.times.push_back(i == 0 ? draw.between(0.0, 0.1) : m.times.back() + draw.decades(0.01, 1.0));
    m.positions.push_back(draw.vector(0.1));
  }
  return m;
}

inline motions::Stroke some_stroke(Draw& draw) {
  return {draw.decades(0.01, 1.0),
          draw.direction(),
          draw.decades(0.01, 1.0),
          draw.decades(0.1, 10.0),
          1 + static_cast<int>(draw.between(0.0, 5.0)),
          draw.chance(0.5) ? 0.0 : draw.between(0.0, 1.0)};
}

/// One of each kind.
inline std::vector<motions::Kind> one_of_each(Draw& draw) {
  using namespace motions;
  const double ramp = draw.chance(0.5) ? 0.0 : draw.between(0.0, 1.0);
  return {Translation{draw.vector(1.0)},
          Rotation{draw.vector(0.1), draw.direction(), draw.between(-2.0, 2.0), ramp},
          Sine{some_wave(draw), draw.direction()},
          Swing{some_wave(draw), draw.vector(0.1), draw.direction()},
          Sines{{some_wave(draw), some_wave(draw), some_wave(draw)}, draw.direction()},
          some_square_wave(draw),
          some_path(draw, Path::Between::cubic, 2 + static_cast<std::size_t>(draw.between(0.0, 8.0))),
          some_path(draw, Path::Between::linear, 5),
          some_stroke(draw)};
}

}  // namespace pulvis::validation
