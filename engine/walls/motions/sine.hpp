// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// A sine less its value at t = 0: A (sin(2 pi (f t + phi)) - sin(2 pi phi)), in the unit of A. With
/// phi = -1/4 it also starts from rest. Peak rate of change 2 pi f A, peak second derivative A (2 pi f)^2.
struct Wave {
  double amplitude = 0.0;  ///< A
  double frequency = 0.0;  ///< f, Hz
  double phase = 0.0;      ///< phi, cycles

  double operator()(double t) const;
  double peak_rate() const;
  double peak_acceleration() const;
  Fault fault() const;
};

/// To and fro along a line: displacement A (sin(2 pi (f t + phi)) - sin(2 pi phi)) d [m].
struct Sine {
  Wave wave;                ///< amplitude in m
  Vec3 direction{0, 0, 1};  ///< d, unit vector

  Rigid displacement(double t) const { return Rigid::translation(wave(t) * direction); }
  Peaks peaks() const { return {.speed = wave.peak_rate(), .acceleration = wave.peak_acceleration()}; }
  std::optional<double> cycle() const { return 1.0 / wave.frequency; }
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const { return first_of({wave.fault(), unless_unit_vector("direction", direction)}); }
};

/// To and fro about an axis: angle A (sin(2 pi (f t + phi)) - sin(2 pi phi)) [cycles], right-handed. Peak
/// rate 2 pi (2 pi f A) rad/s, peak angular acceleration 2 pi A (2 pi f)^2 rad/s^2.
struct Swing {
  Wave wave;           ///< amplitude in cycles
  Vec3 point;          ///< a point of the axis, m
  Vec3 axis{0, 0, 1};  ///< unit vector

  Rigid displacement(double t) const { return Rigid::rotation(wave(t), point, axis); }
  Peaks peaks() const;
  std::optional<double> cycle() const { return 1.0 / wave.frequency; }
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const;
};

}  // namespace pulvis::motions
