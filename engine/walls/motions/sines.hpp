// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/walls/motions/sine.hpp"

namespace pulvis::motions {

/// Several sines at once along one line: displacement
///   sum of A_i (sin(2 pi (f_i t + phi_i)) - sin(2 pi phi_i)) d   [m]
///
/// Cycle  the shortest time after which it repeats: the least k up to 1000 for which k periods of the slowest
///        sine are whole numbers of periods of all others, to 1e-9 of a period. Otherwise it has none.
/// Peaks  over one cycle searched to rounding; without a cycle the sums of the single peaks, to which sines
///        whose frequencies have no common multiple come as close as one likes, if one waits.
struct Sines {
  std::vector<Wave> waves;  ///< amplitudes in m
  Vec3 direction{0, 0, 1};  ///< d, unit vector

  Rigid displacement(double t) const;
  Peaks peaks() const;
  std::optional<double> cycle() const;
  std::optional<double> duration() const { return std::nullopt; }
  Fault fault() const;
};

}  // namespace pulvis::motions
