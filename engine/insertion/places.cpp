// SPDX-License-Identifier: Apache-2.0
#include "engine/insertion/drawing.hpp"
#include "engine/math/functions.hpp"

namespace pulvis {
namespace {

/// A coordinate from the middle of the region at which a sphere lies over one of the openings; all openings
/// that it could lie over within `half_room` are as likely. It may come out beyond half_room at the rim.
double over_an_opening(double a, const Sieve& sieve, double radius, double half_room) {
  const double slack = greatest(sieve.opening - 2.0 * radius, 0.0);
  const auto each_side = static_cast<std::int64_t>((half_room + 0.5 * slack) / sieve.pitch);
  const double drawn = a * static_cast<double>(2 * each_side + 1);
  const auto opening = static_cast<std::int64_t>(drawn);
  return static_cast<double>(opening - each_side) * sieve.pitch +
         (drawn - static_cast<double>(opening) - 0.5) * slack;
}

}  // namespace

int fall_axis(const Vec3& velocity) {
  const double x = magnitude(velocity.x), y = magnitude(velocity.y), z = magnitude(velocity.z);
  return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
}

Places::Places(const SourceModel& m) : region_(m.region), sieve_(m.sieve) {
  if (region_.shape == Region::Shape::box) {
    low_ = region_.min;
    high_ = region_.max;
    const int axis = fall_axis(m.velocity);
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, extent = high_ - low_;
    middle_ = 0.5 * (low_ + high_);
    along_ = unit[axis];
    height_ = extent[axis];
    for (int k = 0; k < 2; ++k) {
      across_[k] = unit[(axis + 1 + k) % 3];
      width_[k] = extent[(axis + 1 + k) % 3];
    }
    return;
  }
  const Vec3 end = region_.base + region_.height * region_.axis;
  for (int axis = 0; axis < 3; ++axis) {
    low_[axis] = least(region_.base[axis], end[axis]) - region_.radius;
    high_[axis] = greatest(region_.base[axis], end[axis]) + region_.radius;
  }
  middle_ = 0.5 * (region_.base + end);
  along_ = region_.axis;
  across_[0] = perpendicular(along_);
  across_[1] = cross(along_, across_[0]);
  height_ = region_.height;
  width_[0] = width_[1] = 2.0 * region_.radius;
}

std::optional<Vec3> Places::under_sieve(double radius, const std::array<double, 3>& drawn) const {
  const double room[2] = {0.5 * width_[0] - radius, 0.5 * width_[1] - radius};
  const double u = over_an_opening(drawn[0], *sieve_, radius, room[0]),
               v = over_an_opening(drawn[1], *sieve_, radius, room[1]);
  const bool inside = region_.shape == Region::Shape::box ? magnitude(u) <= room[0] && magnitude(v) <= room[1]
                                                          : u * u + v * v <= square(room[0]);
  if (!inside) return std::nullopt;
  const double along = (drawn[2] - 0.5) * greatest(height_ - 2.0 * radius, 0.0);
  return middle_ + u * across_[0] + v * across_[1] + along * along_;
}

std::optional<Vec3> Places::at(double radius, const std::array<double, 3>& drawn) const {
  if (sieve_) return under_sieve(radius, drawn);
  const auto [a, b, c] = drawn;
  if (region_.shape == Region::Shape::box) {
    const Vec3 room = high_ - low_ - Vec3{2 * radius, 2 * radius, 2 * radius};
    return low_ + Vec3{radius, radius, radius} +
           Vec3{a * greatest(room.x, 0.0), b * greatest(room.y, 0.0), c * greatest(room.z, 0.0)};
  }
  const double distance = greatest(region_.radius - radius, 0.0) * root(a);
  const double along = radius + c * greatest(region_.height - 2 * radius, 0.0);
  return region_.base + along * along_ + (distance * cosine_of_cycles(b)) * across_[0] +
         (distance * sine_of_cycles(b)) * across_[1];
}

}  // namespace pulvis
