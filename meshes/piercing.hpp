// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <optional>

#include "engine/walls/triangle_mesh.hpp"

namespace pulvis {

struct Piercing {
  Vec3 place;                ///< m
  std::uint32_t triangle_a;  ///< of the first mesh; the number of the triangle, not of the facet in a file
  std::uint32_t triangle_b;
};

/// Whether an edge of one mesh passes through a surface of the other: its ends lie on opposite sides by more
/// than `tolerance` (m), and it crosses inside a triangle, by more than `tolerance` from its rim; or it
/// crosses at an edge of two triangles, from outside both to inside both. So bodies that touch, slide flush
/// on each other or share faces and edges do not pierce.
/// Not seen: an edge exactly through a corner of many triangles, if none of the other edges pierces; and a
/// body that lies wholly within another.
/// The same meshes give the same answer, which is one of possibly many.
std::optional<Piercing> first_piercing(const TriangleMesh& a, const TriangleMesh& b, double tolerance);

}  // namespace pulvis
