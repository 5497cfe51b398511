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
  enum class Kind {
    plane,
    rectangle,
    disc,     ///< or a ring, if its inner radius is not 0
    frustum,  ///< mantle of a cylinder, a cone or a truncated cone
    sphere,   ///< shell
    patch     ///< triangles of a mesh: asked through FacetedWall
  };
  Kind kind = Kind::plane;
  std::string name;           ///< e.g. "die.-x", for messages and forces
  std::uint32_t body = 0;     ///< index of the body it belongs to
  std::uint32_t wall = 0;     ///< index of the named wall it belongs to
  std::uint32_t species = 0;  ///< of its material
  Vec3 centre;  ///< m: a point of the plane; middle of rectangle, disc, sphere; lower end of the axis
  Vec3 normal{0, 0, 1};               ///< unit vector: of plane, rectangle, disc; axis of the frustum
  Vec3 side[2];                       ///< rectangle: unit vectors along its edges
  double half[2] = {0, 0};            ///< m; rectangle: half the edges
  double radius = 0.0;                ///< m; disc, sphere; frustum: at the lower end
  double other_radius = 0.0;          ///< m; frustum: at the upper end; disc: of the hole
  double height = 0.0;                ///< m; frustum
  std::uint32_t mesh = 0, patch = 0;  ///< patch: which of which mesh
};

struct NearestPoint {
  Vec3 point;              ///< m
  bool in_face = true;     ///< false: on an edge of the surface
  double elevation = 0.0;  ///< m: signed distance from the surface continued beyond its edges
};

/// Nearest point of the surface to `p` (both in the body's frame); not for patches. Where several are
/// nearest (on the axis of a tube, in the middle of a sphere), one of them is returned.
NearestPoint nearest_point(const Surface& surface, const Vec3& p);

/// Widens the box from `low` to `high` so that it holds the surface; false if it has no bounds (a plane) or is
/// a patch, whose mesh knows them.
bool include(const Surface& surface, Vec3& low, Vec3& high);

/// The surfaces of a box with faces named -x +x -y +y -z +z, of a truncated cone with base, side, top (equal
/// radii: a cylinder; one of them 0: a cone), of a plane, a sphere, a rectangle. `open` lists the faces left
/// out.
std::vector<Surface> box_surfaces(const std::string& name, const Region& box,
                                  const std::vector<std::string>& open);
std::vector<Surface> frustum_surfaces(const std::string& name, const Vec3& base, const Vec3& axis,
                                      double radius, double top_radius, double height,
                                      const std::vector<std::string>& open);
std::vector<Surface> cylinder_surfaces(const std::string& name, const Region& cylinder,
                                       const std::vector<std::string>& open);
Surface plane_surface(const std::string& name, const Vec3& point, const Vec3& normal);
Surface disc_surface(const std::string& name, const Vec3& centre, const Vec3& normal, double radius,
                     double hole_radius);
Surface sphere_surface(const std::string& name, const Vec3& centre, double radius);
/// `along` and `across` are its edges from the corner, at right angles to each other, m.
Surface rectangle_surface(const std::string& name, const Vec3& corner, const Vec3& along, const Vec3& across);

}  // namespace pulvis
