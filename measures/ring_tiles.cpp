// SPDX-License-Identifier: Apache-2.0
#include "measures/ring_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "engine/math/region.hpp"

namespace pulvis::measures {
namespace {

/// Angle of the point (x, y), 0 to 2 pi, rad, to 3e-8: a boundary between sectors is then off by a hair, in
/// less than half of the time of atan2. For 0 <= t <= 1: arctan(t) = t (1 + a_1 t^2 + ... + a_8 t^16), error
/// below 2e-8 (M. Abramowitz and I. A. Stegun, Handbook of Mathematical Functions, 1964, equation 4.4.49).
double angle_of(double x, double y) {
  const double across = magnitude(x), up = magnitude(y);
  const double larger = greatest(across, up);
  if (!(larger > 0.0)) return 0.0;
  const double t = least(across, up) / larger, s = t * t;
  double sum = 0.0028662257;
  for (const double a : {-0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393, -0.1420889944,
                         0.1999355085, -0.3333314528, 1.0})
    sum = sum * s + a;
  const double octant = t * sum;
  const double quadrant = up > across ? 0.5 * pi - octant : octant;
  const double half = x < 0.0 ? pi - quadrant : quadrant;
  return y < 0.0 ? 2.0 * pi - half : half;
}

}  // namespace

RingTiles::RingTiles(const Surface& s, double edge)
    : kind_(s.kind), centre_(s.centre), axis_(s.normal), ahead_(perpendicular(s.normal)), radius_(s.radius) {
  aside_ = cross(axis_, ahead_);
  double length = pi * s.radius;
  if (kind_ == Surface::Kind::disc) {
    radius_ = s.other_radius;
    out_ = 1.0;
    up_ = 0.0;
    length = s.radius - s.other_radius;
  } else if (kind_ == Surface::Kind::frustum) {
    length = root(square(s.other_radius - s.radius) + square(s.height));
    out_ = (s.other_radius - s.radius) / length;
    up_ = s.height / length;
  }
  along_ = evenly(length, edge);
  const bool has_tip = kind_ == Surface::Kind::disc      ? s.other_radius == 0.0
                       : kind_ == Surface::Kind::frustum ? s.radius == 0.0 || s.other_radius == 0.0
                                                         : true;
  // Sectors meet in a tip: if that is all there is, they would be narrower than the whole.
  const bool whole = has_tip && length < (1.0 - 1e-9) * edge;
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < along_.count(); ++i) {
    const double round = 2.0 * pi * band(along_.edge(i), along_.edge(i + 1)).mean_radius;
    const auto sectors = whole ? 1u : static_cast<std::uint32_t>(parts_within(round, edge));
    rings_.push_back({next, sectors});
    next += sectors;
  }
}

/// A line from (r0, z0) to (r1, z1), turned about the axis: its points weigh as their distance r from it.
RingTiles::Band RingTiles::straight_band(double from, double to) const {
  const double r0 = greatest(radius_ + out_ * from, 0.0), r1 = greatest(radius_ + out_ * to, 0.0);
  const double width = to - from, sum = r0 + r1;
  Band b;
  b.mean_radius = 0.5 * sum;
  b.area = pi * sum * width;
  b.centre_radius = 2.0 / 3.0 * (sum - r0 * r1 / sum);
  b.centre_along = up_ * (from + width * (r0 + 2.0 * r1) / (3.0 * sum));
  b.normal_across = up_;
  // A disc's normal is the axis; that of a mantle points away from it.
  b.normal_along = kind_ == Surface::Kind::disc ? 1.0 : -out_;
  return b;
}

/// The same for an arc from the lower pole, r = R sin(t), z = -R cos(t) with t = way / R:
/// area = 2 pi R^2 (cos t0 - cos t1), integral of r^2 = R^3 (t/2 - sin(2t)/4), of r z = -R^3 sin(t)^2 / 2.
RingTiles::Band RingTiles::round_band(double from, double to) const {
  const double t0 = from / radius_, t1 = to / radius_;
  const double height = 2.0 * std::sin(0.5 * (t0 + t1)) * std::sin(0.5 * (t1 - t0));
  const double turned = 0.5 * (t1 - t0) - 0.25 * (std::sin(2.0 * t1) - std::sin(2.0 * t0));
  Band b;
  b.area = 2.0 * pi * square(radius_) * height;
  b.mean_radius = radius_ * height / (t1 - t0);
  b.normal_across = turned / height;
  b.normal_along = -0.5 * (square(std::sin(t1)) - square(std::sin(t0))) / height;
  b.centre_radius = radius_ * b.normal_across;
  b.centre_along = radius_ * b.normal_along;
  return b;
}

RingTiles::Band RingTiles::band(double from, double to) const {
  return kind_ == Surface::Kind::sphere ? round_band(from, to) : straight_band(from, to);
}

void RingTiles::append_to(std::vector<WallTile>& tiles, std::uint32_t surface) const {
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const Band b = band(along_.edge(i), along_.edge(i + 1));
    const double sectors = rings_[i].sectors;
    // The mean of the outward direction over a sector of half-angle a is sin(a) / a in its middle.
    const double shortened = rings_[i].sectors == 1 ? 0.0 : std::sin(pi / sectors) / (pi / sectors);
    for (std::uint32_t k = 0; k < rings_[i].sectors; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / sectors;
      const Vec3 outward = std::cos(angle) * ahead_ + std::sin(angle) * aside_;
      const Vec3 normal = (shortened * b.normal_across) * outward + b.normal_along * axis_;
      WallTile tile;
      tile.surface = surface;
      tile.area = b.area / sectors;
      tile.centre = centre_ + (shortened * b.centre_radius) * outward + b.centre_along * axis_;
      tile.normal = cancelled(normal) ? outward : normal / norm(normal);
      tile.u = angle * b.mean_radius;
      tile.v = 0.5 * (along_.edge(i) + along_.edge(i + 1));
      tiles.push_back(tile);
    }
  }
}

double RingTiles::way(double distance, double along) const {
  if (kind_ == Surface::Kind::sphere) return radius_ * angle_of(-along, distance);
  return (distance - radius_) * out_ + along * up_;
}

std::uint32_t RingTiles::at(const Vec3& point) const {
  const Vec3 from_centre = point - centre_;
  const double x = dot(from_centre, ahead_), y = dot(from_centre, aside_);
  const Ring& ring = rings_[along_.at(way(root(square(x) + square(y)), dot(from_centre, axis_)))];
  if (ring.sectors == 1) return ring.first;
  const double turn = angle_of(x, y) / (2.0 * pi);  // or a whole one
  return ring.first + std::min(static_cast<std::uint32_t>(turn * ring.sectors), ring.sectors - 1);
}

}  // namespace pulvis::measures
