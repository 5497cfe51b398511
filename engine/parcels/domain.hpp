// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// Simple shear of a box that is periodic along both axes, v_flow = rate (x_gradient - middle), by boundaries after
/// A. W. Lees, S. F. Edwards, J. Phys. C: Solid State Phys. 5 (1972) 1921-1928, doi:10.1088/0022-3719/5/15/006:
/// the images above the upper face of the gradient axis slide along the flow axis, and those below the lower face back.
struct Shear {
  int flow = 0, gradient = 1;   ///< axes
  double rate = 0.0;            ///< 1/s
  double shift_at_start = 0.0;  ///< m; how far the images above were at step 0
  bool any() const { return rate != 0.0 || shift_at_start != 0.0; }
};

/// The box outside which no parcel may be, m; an axis can be periodic.
struct Box {
  Vec3 min, max;
  bool periodic[3] = {false, false, false};
  Shear shear{};

  Vec3 extent() const { return max - min; }
  /// Velocity of the shear flow at a place, m/s; 0 in a box at rest.
  PULVIS_INLINE Vec3 flow_velocity(const Vec3& x) const {
    Vec3 velocity;
    const double middle = 0.5 * (min[shear.gradient] + max[shear.gradient]);
    velocity[shear.flow] = shear.rate * (x[shear.gradient] - middle);
    return velocity;
  }
};

/// Where the images of a sheared box are at one moment: those across the upper face of the gradient axis lie `shift`
/// further along the flow axis than without shear and move `jump` faster. Of a box that is not sheared: height 0.
struct Slide {
  int flow = 0, gradient = 1;
  double height = 0.0;  ///< m, of the box along the gradient axis
  double shift = 0.0;   ///< m, from -1/2 to 1/2 of the box's length along the flow axis
  double jump = 0.0;    ///< m/s

  /// A pure function of time, so that nothing of it needs to be remembered.
  static Slide of(const Box& box, double time) {
    Slide s;
    if (!box.shear.any()) return s;
    s.flow = box.shear.flow, s.gradient = box.shear.gradient;
    const double length = box.max[s.flow] - box.min[s.flow];
    s.height = box.max[s.gradient] - box.min[s.gradient];
    s.jump = box.shear.rate * s.height;
    const double gone = box.shear.shift_at_start + s.jump * time;
    s.shift = gone - length * static_cast<double>(static_cast<long long>(gone / length));
    if (s.shift > 0.5 * length) s.shift -= length;
    if (s.shift < -0.5 * length) s.shift += length;
    return s;
  }
  PULVIS_INLINE bool any() const { return height > 0.0; }

  /// 1 if a difference `d` along the gradient axis is shortest across the upper face, -1: the lower, else 0.
  PULVIS_INLINE static double crossed(double d, double height) {
    const double half = 0.5 * height;
    return d > half ? 1.0 : d < -half ? -1.0 : 0.0;
  }
  /// A difference of positions, brought to the image that is nearest along the gradient axis.
  PULVIS_INLINE Vec3 operator()(Vec3 d) const {
    const double across = crossed(d[gradient], height);
    d[gradient] -= across * height;
    d[flow] -= across * shift;
    return d;
  }
};

/// Nearest image of a difference of positions along the periodic axes. The length is 0 along the others.
struct NearestImage {
  Vec3 length;

  static NearestImage of(const Box& box) {
    const Vec3 e = box.extent();
    return {{box.periodic[0] ? e.x : 0.0, box.periodic[1] ? e.y : 0.0, box.periodic[2] ? e.z : 0.0}};
  }
  PULVIS_INLINE static double wrap(double d, double length) {
    const double half = length > 0.0 ? 0.5 * length : HUGE_VAL;
    return d - (d > half ? length : d < -half ? -length : 0.0);
  }
  PULVIS_INLINE Vec3 operator()(const Vec3& d) const {
    return {wrap(d.x, length.x), wrap(d.y, length.y), wrap(d.z, length.z)};
  }
};

/// The images of a box at one moment, sheared or not.
struct Images {
  NearestImage periods;
  Slide slide;

  static Images of(const Box& box, double time) { return {NearestImage::of(box), Slide::of(box, time)}; }
  /// Nearest image of a difference of positions.
  PULVIS_INLINE Vec3 operator()(const Vec3& d) const { return periods(slide.any() ? slide(d) : d); }
};

}  // namespace pulvis
