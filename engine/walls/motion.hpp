// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"

namespace pulvis {

/// A harmonic motion: displacement
///   x(t) = A (sin(2 pi (f t + phi)) - sin(2 pi phi)) d   [m]
/// so that it starts from where the body is. With phi = -1/4 it also starts from rest. Its peak acceleration
/// is A (2 pi f)^2. The sine is the engine's own: the same bits on every machine.
struct SineMotion {
  double amplitude = 0.0;   ///< A, m
  double frequency = 0.0;   ///< f, Hz
  double phase = 0.0;       ///< phi, cycles
  Vec3 direction{0, 0, 1};  ///< d, unit vector

  /// Displacement a time `t` (s) after the start, m.
  Vec3 displacement(double t) const;
  /// Largest speed it reaches, 2 pi f A, m/s.
  double peak_speed() const { return 2.0 * pi * frequency * amplitude; }
};

using Motion = SineMotion;
inline Rigid displacement(const Motion& m, double t) { return Rigid::translation(m.displacement(t)); }
inline double peak_speed(const Motion& m, double) { return m.peak_speed(); }
inline Vec3 axis_point(const Motion&) { return {}; }

}  // namespace pulvis
