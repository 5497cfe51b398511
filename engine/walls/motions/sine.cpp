// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/motions/sine.hpp"

namespace pulvis::motions {

double Wave::operator()(double t) const {
  return amplitude * (sine_of_cycles(frequency * t + phase) - sine_of_cycles(phase));
}

double Wave::peak_rate() const { return 2.0 * pi * frequency * magnitude(amplitude); }

double Wave::peak_acceleration() const { return square(2.0 * pi * frequency) * magnitude(amplitude); }

Fault Wave::fault() const {
  return first_of({unless_finite("amplitude", amplitude), unless_above_zero("frequency", frequency, "Hz"),
                   unless_finite("phase", phase)});
}

Peaks Swing::peaks() const {
  return {.rate = 2.0 * pi * wave.peak_rate(),
          .angular_acceleration = 2.0 * pi * wave.peak_acceleration(),
          .point = point,
          .axis = axis};
}

Fault Swing::fault() const {
  return first_of({wave.fault(), unless_finite("point", point), unless_unit_vector("axis", axis)});
}

}  // namespace pulvis::motions
