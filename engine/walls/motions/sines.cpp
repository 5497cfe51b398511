// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/sines.hpp"

#include <fmt/format.h>

#include "engine/math/largest.hpp"

namespace pulvis::motions {
namespace {

/// Above this many periods of the fastest sine in a cycle a search costs more than it tells.
constexpr double most_periods_searched = 20000.0;

double slowest(const std::vector<Wave>& waves) {
  double frequency = waves.front().frequency;
  for (const Wave& wave : waves) frequency = least(frequency, wave.frequency);
  return frequency;
}

double fastest(const std::vector<Wave>& waves) {
  double frequency = 0.0;
  for (const Wave& wave : waves) frequency = greatest(frequency, wave.frequency);
  return frequency;
}

bool all_whole(const std::vector<Wave>& waves, double time) {
  for (const Wave& wave : waves) {
    const double periods = wave.frequency * time;
    if (magnitude(periods - nearest_whole(periods)) > 1e-9) return false;
  }
  return true;
}

Peaks searched_peaks(const std::vector<Wave>& waves, double cycle, int pieces) {
  const auto speed = [&](double t) {
    double sum = 0.0;
    for (const Wave& w : waves)
      sum += 2.0 * pi * w.frequency * w.amplitude * cosine_of_cycles(w.frequency * t + w.phase);
    return magnitude(sum);
  };
  const auto acceleration = [&](double t) {
    double sum = 0.0;
    for (const Wave& w : waves)
      sum += square(2.0 * pi * w.frequency) * w.amplitude * sine_of_cycles(w.frequency * t + w.phase);
    return magnitude(sum);
  };
  return {.speed = largest_between(0.0, cycle, pieces, speed),
          .acceleration = largest_between(0.0, cycle, pieces, acceleration)};
}

}  // namespace

Rigid Sines::displacement(double t) const {
  double sum = 0.0;
  for (const Wave& wave : waves) sum += wave(t);
  return Rigid::translation(sum * direction);
}

std::optional<double> Sines::cycle() const {
  const double period = 1.0 / slowest(waves);
  for (int k = 1; k <= 1000; ++k)
    if (all_whole(waves, k * period)) return k * period;
  return std::nullopt;
}

Peaks Sines::peaks() const {
  const std::optional<double> repeats = cycle();
  const double periods = repeats ? *repeats * fastest(waves) : 0.0;
  // A sum of sines has no peaks narrower than those of its fastest one.
  if (repeats && periods < most_periods_searched)
    return searched_peaks(waves, *repeats, 32 * static_cast<int>(nearest_whole(periods)));
  Peaks sum;
  for (const Wave& wave : waves) {
    sum.speed += wave.peak_rate();
    sum.acceleration += wave.peak_acceleration();
  }
  return sum;
}

Fault Sines::fault() const {
  if (waves.empty()) return "it has no sines";
  for (std::size_t i = 0; i < waves.size(); ++i)
    if (const Fault fault = waves[i].fault()) return fmt::format("sine {}: {}", i + 1, *fault);
  return unless_unit_vector("direction", direction);
}

}  // namespace pulvis::motions
