// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// A square wave that swells and fades: displacement A m(t) s(t) d [m].
///
///   m(t) = (1 - cos(2 pi t/T_m))/2 = sin^2(pi t/T_m)                                          (1)
///   s(t)   between -1 and +1 with the frequency f; it rises about t = 0, 1/f, 2/f, ... and falls about the
///          middles between them, and on each flank, with w = 2 tau/t_r from -1 to 1 and tau the time from
///          the flank's centre,
///   s    = +-(15 w - 10 w^3 + 3 w^5)/8                                                        (2)
///
/// the lowest polynomial whose first two derivatives vanish at both ends, so the acceleration is continuous.
/// For m = 1 the speed is largest at the centre of a flank, the acceleration at w = +-1/sqrt(3):
///
///   A max |s'| = 15 A/(4 t_r)   [m/s],      A max |s''| = 20 A/(sqrt(3) t_r^2)   [m/s^2]      (3)
///
/// Speed and modulation: the peak stays that of (3), for (m s)' at a given w is a constant plus a sine in the
/// phase of m, at most |s'|/2 + sqrt(s'^2/4 + (pi s/T_m)^2), and that is largest at w = 0 if T_m > pi t_r/2.
/// Likewise the acceleration is, at a given w and whatever the phase of m, at most
///
///   A (|s''|/2 + sqrt((2 pi^2 s/T_m^2 - s''/2)^2 + (2 pi s'/T_m)^2))                          (4)
///
/// which `peaks` searches over w from 0 to 1 to rounding. If f T_m is whole, a flank meets the crest of m:
/// the wave reaches the peak speed, and the peak acceleration to within (t_r/T_m)^2 of it; else it comes
/// within about (pi/(4 f T_m))^2 of both.
/// Our own equations. Valid for t_r up to 1/(2 f), where the flanks meet, and T_m from 1/f on.
struct SquareWave {
  double amplitude = 0.0;                   ///< A, m; half the way from one plateau to the other
  double frequency = 0.0;                   ///< f, Hz
  Vec3 direction{0, 0, 1};                  ///< d, unit vector
  std::optional<double> rise_time;          ///< t_r, s; else a tenth of a period
  std::optional<double> modulation_period;  ///< T_m, s; else ten periods: a burst of ten cycles, and the next

  Rigid displacement(double t) const;
  Peaks peaks() const;
  /// That of s, which is what one counts when shaking; m repeats after f T_m of them.
  std::optional<double> cycle() const { return 1.0 / frequency; }
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const;

  double rise() const { return rise_time ? *rise_time : 0.1 / frequency; }
  double modulation() const { return modulation_period ? *modulation_period : 10.0 / frequency; }
};

}  // namespace pulvis::motions
