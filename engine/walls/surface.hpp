// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/math/region.hpp"
#include "engine/math/vec3.hpp"

namespace pulvis {

/// One smooth piece of a wall, in the frame of its body. Thin: parcels can touch it from both sides.
/// A shape answers where its nearest point is; forces are the contact law's business.
struct Surface {
  enum class Kind { plane, rectangle, disc, tube };
  Kind kind = Kind::plane;
  std::string name;        ///< e.g. "die.-x", for messages and forces
  std::uint32_t body = 0;  ///< index of the body it belongs to
  Vec3 centre;           ///< m: a point of the plane; middle of rectangle, disc; lower end of the tube's axis
  Vec3 normal{0, 0, 1};  ///< unit vector: of the plane; axis of the tube
  Vec3 side[2];          ///< rectangle: unit vectors along its edges
  double half[2] = {0, 0};  ///< m; rectangle: half the edges; tube: {radius, height}; disc: {radius, -}
};

struct NearestPoint {
  Vec3 point;        ///< m
  bool in_face;      ///< false: on an edge of the surface
  double elevation;  ///< m: signed distance from the unbounded surface (tube: from its axis minus radius)
};

/// Nearest point of the surface to `p` (both in the body's frame). A point on a tube's axis has no nearest
/// point; one of them is returned.
NearestPoint nearest_point(const Surface& surface, const Vec3& p);

/// The surfaces of a box with faces named -x +x -y +y -z +z, of a cylinder with base, side, top, of a plane.
/// `open` lists the faces left out.
std::vector<Surface> box_surfaces(const std::string& name, const Region& box,
                                  const std::vector<std::string>& open);
std::vector<Surface> cylinder_surfaces(const std::string& name, const Region& cylinder,
                                       const std::vector<std::string>& open);
Surface plane_surface(const std::string& name, const Vec3& point, const Vec3& normal);

}  // namespace pulvis
