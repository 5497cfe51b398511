// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/square_wave.hpp"

#include <fmt/format.h>

#include "engine/math/largest.hpp"

namespace pulvis::motions {
namespace {

// Equation (2) of the header and its derivatives by w.
double flank(double w) { return w * (15.0 + w * w * (-10.0 + 3.0 * w * w)) / 8.0; }
double flank_slope(double w) { return 1.875 * square(1.0 - w * w); }
double flank_curvature(double w) { return -7.5 * w * (1.0 - w * w); }

}  // namespace

Rigid SquareWave::displacement(double t) const {
  const double cycles = frequency * t;
  double from_rise = cycles - nearest_whole(cycles);
  // The falling flank mirrors the rising one.
  if (from_rise > 0.25) from_rise = 0.5 - from_rise;
  if (from_rise < -0.25) from_rise = -0.5 - from_rise;
  const double w = least(greatest(2.0 * from_rise / (frequency * rise()), -1.0), 1.0);
  const double swell = square(sine_of_cycles(0.5 * t / modulation()));
  return Rigid::translation((amplitude * swell * flank(w)) * direction);
}

Peaks SquareWave::peaks() const {
  const double by_time = 2.0 / rise(), omega = pi / modulation();  // dw/dt, and half the angular rate of m
  const auto acceleration = [&](double w) {                        // equation (4)
    const double half = 0.5 * square(by_time) * flank_curvature(w);
    return magnitude(half) + root(square(2.0 * square(omega) * flank(w) - half) +
                                  square(2.0 * omega * by_time * flank_slope(w)));
  };
  return {.speed = magnitude(amplitude) * by_time * flank_slope(0.0),
          .acceleration = magnitude(amplitude) * largest_between(0.0, 1.0, 64, acceleration)};
}

Fault SquareWave::fault() const {
  if (Fault fault =
          first_of({unless_finite("amplitude", amplitude), unless_above_zero("frequency", frequency, "Hz"),
                    unless_unit_vector("direction", direction), unless_above_zero("rise time", rise(), "s"),
                    unless_above_zero("period of the modulation", modulation(), "s")}))
    return fault;
  // A hair of slack for a rise time that was computed as half a period.
  if (rise() * frequency > 0.5 * (1.0 + 1e-12))
    return fmt::format("the rise time {:g} s is longer than half a period, {:g} s", rise(), 0.5 / frequency);
  if (modulation() * frequency < 1.0 - 1e-12)
    return fmt::format("the period of the modulation {:g} s is shorter than that of the wave, {:g} s",
                       modulation(), 1.0 / frequency);
  return std::nullopt;
}

}  // namespace pulvis::motions
