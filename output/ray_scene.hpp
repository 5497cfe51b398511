// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "engine/math/vec3.hpp"

namespace pulvis {

/// A sphere, or a disc of that centre and radius. Single precision: coordinates should be of order one.
struct Ball {
  float x = 0.0f, y = 0.0f, z = 0.0f, radius = 0.0f;
};

struct Ray {
  Vec3 origin, direction;  ///< direction of length one
  double near = 0.0, far = 0.0;
};

struct RayHit {
  double distance;
  std::uint32_t group;  ///< the number add_... returned
  std::uint32_t index;  ///< in that group
  Vec3 normal;          ///< of the surface, of length one, to either side
};

/// Shapes that rays are sent against. Add groups (which may be empty), `commit`, then ask from any thread.
class RayScene {
 public:
  explicit RayScene(int threads);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  std::uint32_t add_spheres(std::span<const Ball> spheres);
  std::uint32_t add_discs(std::span<const Ball> discs, const Vec3& normal);
  /// Three corners for each triangle.
  std::uint32_t add_triangles(std::span<const Vec3> corners);
  /// Thin rods with round ends.
  std::uint32_t add_rods(std::span<const std::array<Vec3, 2>> rods, double radius);
  /// Builds the search tree; std::bad_alloc if memory is short.
  void commit();

  std::optional<RayHit> nearest(const Ray& ray) const;
  bool blocked(const Ray& ray) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace pulvis
