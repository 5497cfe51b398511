// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <limits>
#include <variant>

#include "engine/walls/motions/path.hpp"
#include "engine/walls/motions/rotation.hpp"
#include "engine/walls/motions/sine.hpp"
#include "engine/walls/motions/sines.hpp"
#include "engine/walls/motions/square_wave.hpp"
#include "engine/walls/motions/stroke.hpp"
#include "engine/walls/motions/translation.hpp"

namespace pulvis::motions {

/// The kinds of motion. Each gives its displacement as a function of its own time t > 0 (none as t tends to
/// 0) in arithmetic that has the same bits on every machine; its peaks; its cycle and its duration, if it
/// has them; and what is wrong with it. The others may be asked only if nothing is.
using Kind = std::variant<Translation, Rotation, Sine, Swing, Sines, SquareWave, Path, Stroke>;

/// What moves a body within a phase. Times count from when the phase sets the motion going. Up to `start` the
/// body stays where it is, and the kind's own time begins there; from `end` on it stays where it was then.
struct Motion {
  Kind kind;
  double start = 0.0;                                    ///< s
  double end = std::numeric_limits<double>::infinity();  ///< s
};

/// Displacement of the body `since` seconds after the motion was set going, from where it was then; up to
/// `start` exactly none. After k cycles it is off by up to 1.4e-15 k amplitudes (square wave:
/// 7e-16 k/(f t_r)), for the number of cycles is rounded: no more than a rounding or two of the time does.
Rigid displacement(const Motion& motion, double since);

/// As if `end` were never reached.
Peaks peaks(const Motion& motion);

/// The time of one cycle, s, for motions that go on in cycles: one period of a sine, of sines together, of a
/// square wave without its modulation; one full turn of a rotation.
std::optional<double> cycle(const Motion& motion);

/// How long it takes to make so many cycles, its `start` included, s; none if it has no cycles.
inline std::optional<double> length_of_cycles(const Motion& motion, double cycles) {
  const std::optional<double> period = cycle(motion);
  return period ? std::optional(motion.start + cycles * *period) : std::nullopt;
}

/// When the body has come to rest for good, s after the motion was set going, if ever.
std::optional<double> duration(const Motion& motion);

/// What is wrong with it, in words that follow the name of the motion; nothing if all is well.
Fault fault(const Motion& motion);

}  // namespace pulvis::motions
