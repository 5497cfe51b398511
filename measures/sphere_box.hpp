// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "measures/shapes.hpp"

namespace pulvis::measures {

/// Volume of a sphere, 4/3 pi r^3, in m^3.
double sphere_volume(double radius);

/// Volume that a sphere and a box share, in m^3; exact but for rounding (some 1e-15 of the sphere's
/// volume), never negative and never above the volume of either. 0 for an empty box or a radius <= 0.
///
/// Derivation. In units of the radius and from the sphere's centre, each side of the box is a sum of
/// half-spaces whose plane is x >= 0 away from the centre (HalfSpaces), so the volume is a sum with signs
/// of *corners* Q(x,y,z) = |{X >= x, Y >= y, Z >= z, X^2+Y^2+Z^2 <= 1}| with x,y,z >= 0.
///
/// Q is bounded by a piece of the sphere, of area S, and by a flat piece on each of three planes, of areas
/// A_x, A_y, A_z. The divergence theorem for the field r, whose divergence is 3 and which meets the sphere
/// at a right angle and the plane X = x at depth -x, gives
///   Q = (S - x A_x - y A_y - z A_z) / 3.
/// Write s_xy = sqrt(1-x^2-y^2): the edge X=x, Y=y ends on the sphere at height s_xy.
///
/// The piece of sphere is a triangle of arcs of small circles. On the circle X = x the geodesic curvature
/// times length is x d(phi), phi being the angle about the X axis, and two circles meet at the inner angle
/// alpha_xy with tan(alpha_xy) = s_xy / (x y). Gauss and Bonnet then give
///   S = alpha_xy + alpha_yz + alpha_zx - pi - x phi_x - y phi_y - z phi_z,
///   phi_x = atan(s_xy / y) - atan(z / s_xz)   (length of the arc on X = x, in angle).
/// The flat piece on X = x is a sector of a disc of radius sqrt(1-x^2) less two triangles:
///   A_x = [ (1-x^2) phi_x - y (s_xy - z) - z (s_xz - y) ] / 2.
/// Together
///   Q = (alpha_xy + alpha_yz + alpha_zx - pi) / 3 - sum_x x (3-x^2) phi_x / 6
///       + (x y s_xy + y z s_yz + z x s_zx) / 3 - x y z.
/// With z = 0 this is half of a wedge cut by two planes, with y = z = 0 a quarter of the cap
/// pi/3 (1-x)^2 (2+x). Derived for this program; checked against quadrature in tests/measures.
double sphere_box_volume(const Sphere& sphere, const Box& box);

}  // namespace pulvis::measures
