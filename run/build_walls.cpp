// SPDX-License-Identifier: Apache-2.0
#include "run/build_walls.hpp"

#include <algorithm>

#include "meshes/mending.hpp"
#include "meshes/mesh_words.hpp"
#include "meshes/stl_file.hpp"

namespace pulvis {
namespace {

std::uint32_t body_of(const Wall& wall, Walls& walls) {
  for (std::uint32_t b = 0; b < walls.bodies.size(); ++b)
    if (walls.bodies[b].name == wall.body) return b;
  walls.bodies.push_back({wall.body, wall.motions});
  return static_cast<std::uint32_t>(walls.bodies.size() - 1);
}

std::vector<Surface> shapes_of(const Wall& wall) {
  switch (wall.shape) {
    case Wall::Shape::plane:
      return {plane_surface(wall.name, wall.point, wall.normal)};
    case Wall::Shape::rectangle:
      return {rectangle_surface(wall.name, wall.point, wall.along, wall.across)};
    case Wall::Shape::disc:
      return {disc_surface(wall.name, wall.point, wall.normal, wall.radius, wall.other_radius)};
    case Wall::Shape::box:
      return box_surfaces(wall.name, wall.region, wall.open);
    case Wall::Shape::cylinder:
      return cylinder_surfaces(wall.name, wall.region, wall.open);
    case Wall::Shape::cone:
      return frustum_surfaces(wall.name, wall.point, wall.normal, wall.radius, wall.other_radius, wall.height,
                              wall.open);
    case Wall::Shape::sphere:
      return {sphere_surface(wall.name, wall.point, wall.radius)};
    case Wall::Shape::mesh:
      break;
  }
  return {};
}

TriangleMesh read_mesh(const Case& c, const Wall& wall, BuiltWalls& built) {
  MendedMesh mended = named_by(c, fmt::format("walls.{}.path", wall.name),
                               [&] { return mend(read_stl(wall.path), wall.unit); });
  const std::string name = fmt::format("wall {}: {}", wall.name, wall.path.substr(wall.path.rfind('/') + 1));
  built.notes.push_back(describe(mended.report, name));
  const auto warnings = warnings_of(mended.report, name);
  built.warnings.insert(built.warnings.end(), warnings.begin(), warnings.end());
  for (Vec3& p : mended.mesh.points) p += wall.offset;
  return std::move(mended.mesh);
}

void add_mesh(const Case& c, const Wall& wall, Surface like, double largest_radius, BuiltWalls& built) {
  FacetedWall mesh(read_mesh(c, wall, built), {wall.feature_angle, largest_radius});
  mesh.first_surface = static_cast<std::uint32_t>(built.walls.surfaces.size());
  like.kind = Surface::Kind::patch;
  like.mesh = static_cast<std::uint32_t>(built.walls.meshes.size());
  for (std::uint32_t patch = 0; patch < mesh.patches(); ++patch) {
    like.patch = patch;
    like.name = fmt::format("{}.patch-{}", wall.name, patch + 1);
    built.walls.surfaces.push_back(like);
  }
  built.walls.meshes.push_back(std::move(mesh));
}

}  // namespace

BuiltWalls build_walls(const Case& c, const std::vector<Species>& species, double largest_radius) {
  BuiltWalls built;
  for (const Wall& wall : c.walls) {
    Surface like;
    like.body = body_of(wall, built.walls);
    like.wall = static_cast<std::uint32_t>(built.walls.names.size());
    like.species = static_cast<std::uint32_t>(species_of_material(species, wall.material));
    built.walls.names.push_back(wall.name);
    for (Surface s : shapes_of(wall)) {
      s.body = like.body;
      s.wall = like.wall;
      s.species = like.species;
      built.walls.surfaces.push_back(s);
    }
    if (wall.shape == Wall::Shape::mesh) add_mesh(c, wall, like, largest_radius, built);
  }
  return built;
}

bool bounds_of_wall(const Walls& walls, std::size_t wall, Vec3& low, Vec3& high) {
  low = {1e300, 1e300, 1e300};
  high = -low;
  bool bounded = true;
  for (const Surface& s : walls.surfaces)
    if (s.wall == wall && s.kind != Surface::Kind::patch) bounded = include(s, low, high) && bounded;
  for (const FacetedWall& mesh : walls.meshes)
    if (walls.surfaces[mesh.first_surface].wall == wall) mesh.include(low, high);
  return bounded;
}

}  // namespace pulvis
