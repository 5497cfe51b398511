// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "engine/math/rigid.hpp"
#include "engine/walls/motions/fault.hpp"
#include "engine/walls/motions/peaks.hpp"

namespace pulvis::motions {

/// A table of places passed at given times; what moves the body is the way from the first of them. Before the
/// first time it stays where it is, after the last it stays at the last place.
///
/// Cubic: M. Steffen's monotone interpolation, each coordinate by itself. With h_i = t_(i+1) - t_i and the
/// slope s_i = (x_(i+1) - x_i)/h_i of piece i, the velocity at point i is
///   x'_i = (sgn s_(i-1) + sgn s_i) min(|s_(i-1)|, |s_i|, |p_i|/2),
///   p_i  = (s_(i-1) h_i + s_i h_(i-1))/(h_(i-1) + h_i)     slope of the parabola through three points
/// and at the first and the last point that of the parabola, limited to between 0 and twice the slope of its
/// piece. Each piece is the cubic with these velocities at its ends. A coordinate never overshoots: it turns
/// at points only. The velocity is continuous; the acceleration jumps at points. Parabolas are met exactly
/// where the limits allow. Two points give a straight line. A body starts from rest if the first place is
/// given twice.
/// Source  M. Steffen, Astron. Astrophys. 239 (1990) 443-450 (bibcode 1990A&A...239..443S).
///
/// Linear: constant velocity from point to point; it jumps there, and `peaks` has no acceleration.
struct Path {
  enum class Between { cubic, linear };
  std::vector<double> times;    ///< s, ascending, the first not negative
  std::vector<Vec3> positions;  ///< m, as many
  Between between = Between::cubic;

  Rigid displacement(double t) const;
  Peaks peaks() const;
  std::optional<double> cycle() const { return std::nullopt; }
  std::optional<double> duration() const { return times.back(); }
  Fault fault() const;
};

}  // namespace pulvis::motions
