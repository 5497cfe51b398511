// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace pulvis::measures {

/// A disc in the plane.
struct Disc {
  double x = 0.0, y = 0.0;  ///< m; centre
  double radius = 0.0;      ///< m
};

/// A rectangle with sides along the coordinate axes.
struct Rectangle {
  double min_x = 0.0, min_y = 0.0, max_x = 0.0, max_y = 0.0;  ///< m
};

/// Area that a disc and a rectangle share, in m^2; exact but for rounding (some 1e-15 of the disc's area).
///
/// As for sphere and box, the rectangle is a sum with signs of corners {X >= x, Y >= y} with x,y >= 0 in
/// units of the radius. A corner is a sector less two triangles with their tips at the centre:
///   q = [ phi - x (s_x - y) - y (s_y - x) ] / 2,  s_x = sqrt(1-x^2),  phi = atan(s_x / x) - atan(y / s_y).
double disc_rectangle_area(const Disc& disc, const Rectangle& rectangle);

}  // namespace pulvis::measures
