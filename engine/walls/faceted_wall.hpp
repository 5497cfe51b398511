// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "engine/walls/box_tree.hpp"
#include "engine/walls/surface.hpp"
#include "engine/walls/triangle_mesh.hpp"

namespace pulvis {

/// When two triangles with a common edge are one surface.
struct Smoothness {
  /// They are, if their normals differ by less than this, rad (STL meshes round walls off so).
  double feature_angle = 20.0 * pi / 180.0;
  /// But not where the surface bends more sharply than a sphere of this radius, m: a sphere in a fillet
  /// narrower than itself touches both of its sides. 0: however sharply.
  double largest_radius = 0.0;
};

/// A mesh made ready for contacts. Its triangles are gathered into patches, each one smooth surface: a parcel
/// has one contact with a patch, at the nearest of its points, and the contact's history belongs to the
/// patch, not to a triangle. Between patches lie edges like those between the faces of a box.
class FacetedWall {
 public:
  FacetedWall(TriangleMesh mesh, const Smoothness& smoothness);

  std::uint32_t first_surface = 0;  ///< its patches are Walls::surfaces from here on

  const TriangleMesh& mesh() const { return mesh_; }
  std::uint32_t patches() const { return patches_; }
  std::uint32_t patch_of(std::uint32_t triangle) const { return facet_[triangle].patch; }
  const Vec3& normal_of(std::uint32_t triangle) const { return facet_[triangle].normal; }

  /// Widens the box from `low` to `high` so that it holds the mesh.
  void include(Vec3& low, Vec3& high) const;

  /// Calls visit(triangle) for all triangles closer to `p` than `far`, and some that are not, in a fixed order.
  template <class Visit>
  void for_near(const Vec3& p, double far, Visit&& visit) const {
    tree_.for_near(p, far, visit);
  }

  /// Nearest point of one triangle. `in_face` is false only on the rim of its patch.
  NearestPoint nearest(std::uint32_t triangle, const Vec3& p) const;

  /// Whether the way from `from` to `to` passes through the triangle. Ways through an edge that two triangles
  /// share pass through at least one of them, to the last bit.
  bool passed(std::uint32_t triangle, const Vec3& from, const Vec3& to) const;

 private:
  struct Facet {
    Vec3 normal;  ///< unit vector
    std::uint32_t patch = 0;
    std::uint8_t smooth_edge = 0;    ///< bit k: the edge from corner k to the next lies inside the patch
    std::uint8_t smooth_corner = 0;  ///< bit k: corner k lies inside the patch
  };
  void gather_patches(const Smoothness& smoothness);

  TriangleMesh mesh_;
  std::vector<Facet> facet_;
  BoxTree tree_;
  std::uint32_t patches_ = 0;
};

}  // namespace pulvis
