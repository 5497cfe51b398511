// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>

#include "measures/shapes.hpp"

namespace pulvis::measures {

/// The inside of the die where it stands now. If the die moves, the caller moves this with it: measures
/// are taken in the die's frame. Its top is open for powder heaped above it.
struct Container {
  enum class Shape { box, cylinder };
  Shape shape = Shape::box;
  Vec3 min{}, max{};                  ///< m; box
  Vec3 base{}, axis{0, 0, 1};         ///< m, unit vector; cylinder: centre of its lower end, and along it
  double radius = 0.0, height = 0.0;  ///< m; cylinder
  Vec3 up{0, 0, 1};                   ///< against gravity; any length, zero means no gravity: see DieFrame
};

/// Volume of the inside, m^3.
double volume(const Container& container);

/// Whether a point (a parcel's centre) lies inside; the boundary belongs to the inside.
bool is_inside(const Container& container, const Vec3& point);

/// Coordinates of the die: origin in the lowest corner of the box around its inside, third axis up.
///
/// Box: up is the coordinate axis closest to `up` (with its sign), the first axis is the next coordinate
/// axis in the order x, y, z, x, and the second completes a right-handed set. With up = +z these are x, y, z.
/// Cylinder: if `up` is within 45 degrees of its axis it stands and the third axis is its own axis;
/// otherwise it lies, the first axis is its own axis and the third is `up` made normal to that.
class DieFrame {
 public:
  /// Throws Failure if the inside has no volume or a number is not finite.
  explicit DieFrame(const Container& container);

  const Vec3& origin() const { return origin_; }             ///< m, in the coordinates of the container
  const std::array<Vec3, 3>& axes() const { return axes_; }  ///< unit vectors
  const Vec3& size() const { return size_; }                 ///< m; of the box around the inside
  Vec3 to_local(const Vec3& point) const;                    ///< m; coordinates of the die
  Vec3 to_container(const Vec3& local) const;                ///< m; and back

  /// Part of a box (in coordinates of the die) that lies inside the die, m^3. Exact.
  double volume_inside(const Box& local) const;

  /// Area inside the die of a column seen from above, m^2: `local` without its heights.
  double area_inside(const Box& local) const;

  /// Whether a point (in coordinates of the die) is inside the die or straight above its inside.
  bool inside_or_above(const Vec3& local) const;

  /// Whether a sphere with this centre can reach into the die from the inside: always in a box, where cells
  /// cut off what is outside; in a cylinder only if the centre is within its side wall.
  bool within_side_wall(const Vec3& local) const;

 private:
  enum class Form { box, standing_cylinder, lying_cylinder };

  void place_box(const Container& container);
  void place_cylinder(const Container& container);
  Box clipped(const Box& local) const;

  Form form_ = Form::box;
  Vec3 origin_, size_;
  std::array<Vec3, 3> axes_{};
  double radius_ = 0.0;
};

}  // namespace pulvis::measures
