// SPDX-License-Identifier: Apache-2.0
#include "measures/container.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/failure.hpp"
#include "measures/disc_rectangle.hpp"

namespace pulvis::measures {
namespace {

/// The axis (0, 1, 2) along which a vector is longest; the last of equals, so that z wins over x.
int longest_axis(const Vec3& v) {
  int longest = 2;
  for (int axis = 1; axis >= 0; --axis)
    if (magnitude(v[axis]) > magnitude(v[longest])) longest = axis;
  return longest;
}

Vec3 unit_vector(int axis, double length = 1.0) {
  Vec3 unit;
  unit[axis] = length;
  return unit;
}

Vec3 normalised(const Vec3& v) { return v / norm(v); }

/// A unit vector normal to `direction`; exactly a coordinate axis if `direction` is one.
Vec3 any_normal(const Vec3& direction) {
  const Vec3 seed = unit_vector((longest_axis(direction) + 1) % 3);
  return normalised(seed - dot(seed, direction) * direction);
}

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require(bool condition, const char* what) {
  if (!condition) throw Failure(Exit::bad_case, std::string("the measured die ") + what);
}

}  // namespace

double volume(const Container& container) {
  if (container.shape == Container::Shape::cylinder)
    return std::numbers::pi * square(container.radius) * container.height;
  const Vec3 size = container.max - container.min;
  return size.x * size.y * size.z;
}

bool is_inside(const Container& container, const Vec3& point) {
  if (container.shape == Container::Shape::box) {
    const Vec3 &low = container.min, &high = container.max;
    return low.x <= point.x && point.x <= high.x && low.y <= point.y && point.y <= high.y &&
           low.z <= point.z && point.z <= high.z;
  }
  const Vec3 from_base = point - container.base;
  const double along = dot(from_base, container.axis);
  const Vec3 across = from_base - along * container.axis;
  return 0.0 <= along && along <= container.height && dot(across, across) <= square(container.radius);
}

DieFrame::DieFrame(const Container& container) {
  require(finite(container.up), "has an upward direction that is not finite");
  if (container.shape == Container::Shape::box)
    place_box(container);
  else
    place_cylinder(container);
}

void DieFrame::place_box(const Container& container) {
  const Vec3 &low = container.min, &high = container.max;
  require(finite(low) && finite(high), "has corners that are not finite");
  require(low.x < high.x && low.y < high.y && low.z < high.z, "has no inside: its min must be below its max");

  const int upward = longest_axis(container.up);
  axes_[2] = unit_vector(upward, container.up[upward] < 0.0 ? -1.0 : 1.0);
  axes_[0] = unit_vector((upward + 1) % 3);
  axes_[1] = cross(axes_[2], axes_[0]);

  // The axes are signed coordinate axes: their sum tells for each coordinate where the die's zero is.
  const Vec3 signs = axes_[0] + axes_[1] + axes_[2];
  for (int axis = 0; axis < 3; ++axis) origin_[axis] = signs[axis] > 0.0 ? low[axis] : high[axis];
  const Vec3 width = high - low;
  for (int axis = 0; axis < 3; ++axis)
    size_[axis] = magnitude(dot(axes_[static_cast<std::size_t>(axis)], width));
}

void DieFrame::place_cylinder(const Container& container) {
  require(finite(container.base) && finite(container.axis), "has a base or an axis that is not finite");
  require(container.radius > 0.0 && std::isfinite(container.radius) && container.height > 0.0 &&
              std::isfinite(container.height),
          "has no inside: radius and height must be above zero");
  require(magnitude(norm(container.axis) - 1.0) < 1e-9, "has an axis that is not a unit vector");

  radius_ = container.radius;
  const Vec3& axis = container.axis;
  const Vec3& up = container.up;
  const double along = dot(up, axis);
  const double half_square = 0.5 * dot(up, up);  // cosine of 45 degrees, squared, times the length squared
  if (square(along) >= half_square) {
    form_ = Form::standing_cylinder;
    axes_[2] = along < 0.0 ? -axis : axis;
    axes_[0] = any_normal(axes_[2]);
    axes_[1] = cross(axes_[2], axes_[0]);
    const Vec3 bottom = along < 0.0 ? container.base + container.height * axis : container.base;
    origin_ = bottom - radius_ * (axes_[0] + axes_[1]);
    size_ = {2.0 * radius_, 2.0 * radius_, container.height};
  } else {
    form_ = Form::lying_cylinder;
    axes_[0] = axis;
    axes_[2] = normalised(up - along * axis);
    axes_[1] = cross(axes_[2], axes_[0]);
    origin_ = container.base - radius_ * (axes_[1] + axes_[2]);
    size_ = {container.height, 2.0 * radius_, 2.0 * radius_};
  }
}

Vec3 DieFrame::to_local(const Vec3& point) const {
  const Vec3 from_origin = point - origin_;
  return {dot(from_origin, axes_[0]), dot(from_origin, axes_[1]), dot(from_origin, axes_[2])};
}

Vec3 DieFrame::to_container(const Vec3& local) const {
  return origin_ + (local.x * axes_[0] + local.y * axes_[1] + local.z * axes_[2]);
}

Box DieFrame::clipped(const Box& local) const {
  Box part;
  for (int axis = 0; axis < 3; ++axis) {
    part.min[axis] = std::clamp(local.min[axis], 0.0, size_[axis]);
    part.max[axis] = std::max(part.min[axis], std::min(local.max[axis], size_[axis]));
  }
  return part;
}

double DieFrame::volume_inside(const Box& local) const {
  const Box part = clipped(local);
  const Vec3 &low = part.min, &high = part.max;
  const Disc disc{radius_, radius_, radius_};
  switch (form_) {
    case Form::standing_cylinder:
      return disc_rectangle_area(disc, {low.x, low.y, high.x, high.y}) * (high.z - low.z);
    case Form::lying_cylinder:
      return disc_rectangle_area(disc, {low.y, low.z, high.y, high.z}) * (high.x - low.x);
    case Form::box:
      break;
  }
  return (high.x - low.x) * (high.y - low.y) * (high.z - low.z);
}

double DieFrame::area_inside(const Box& local) const {
  const Box part = clipped(local);
  const Vec3 &low = part.min, &high = part.max;
  if (form_ == Form::standing_cylinder)
    return disc_rectangle_area({radius_, radius_, radius_}, {low.x, low.y, high.x, high.y});
  return (high.x - low.x) * (high.y - low.y);
}

bool DieFrame::within_side_wall(const Vec3& local) const {
  const double from_y = local.y - radius_;
  switch (form_) {
    case Form::standing_cylinder:
      return square(local.x - radius_) + square(from_y) <= square(radius_);
    case Form::lying_cylinder:
      return square(from_y) + square(local.z - radius_) <= square(radius_);
    case Form::box:
      break;
  }
  return true;
}

bool DieFrame::inside_or_above(const Vec3& local) const {
  const bool over_the_die = 0.0 <= local.x && local.x <= size_.x && 0.0 <= local.y && local.y <= size_.y;
  if (!over_the_die || !(local.z >= 0.0)) return false;
  if (form_ == Form::lying_cylinder && local.z > radius_) return true;  // the side wall lies below
  return within_side_wall(local);
}

}  // namespace pulvis::measures
