// SPDX-License-Identifier: Apache-2.0
#include "engine/walls/surface.hpp"

#include <algorithm>

namespace pulvis {
namespace {

NearestPoint nearest_on_rectangle(const Surface& s, const Vec3& p) {
  const Vec3 from_centre = p - s.centre;
  const double u = dot(from_centre, s.side[0]), v = dot(from_centre, s.side[1]);
  const double cu = std::clamp(u, -s.half[0], s.half[0]), cv = std::clamp(v, -s.half[1], s.half[1]);
  return {s.centre + cu * s.side[0] + cv * s.side[1], cu == u && cv == v, dot(from_centre, s.normal)};
}

NearestPoint nearest_on_disc(const Surface& s, const Vec3& p) {
  const Vec3 from_centre = p - s.centre;
  const double height = dot(from_centre, s.normal);
  const Vec3 across = from_centre - height * s.normal;
  const double distance = norm(across);
  if (distance <= s.half[0]) return {s.centre + across, true, height};
  return {s.centre + (s.half[0] / distance) * across, false, height};
}

NearestPoint nearest_on_tube(const Surface& s, const Vec3& p) {
  const Vec3 from_end = p - s.centre;
  const double along = dot(from_end, s.normal);
  const Vec3 across = from_end - along * s.normal;
  const double distance = norm(across);
  const Vec3 outward = distance > 0.0 ? across / distance : perpendicular(s.normal);
  const double clamped = std::clamp(along, 0.0, s.half[1]);
  return {s.centre + clamped * s.normal + s.half[0] * outward, clamped == along, distance - s.half[0]};
}

bool contains(const std::vector<std::string>& list, const char* name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

NearestPoint nearest_point(const Surface& s, const Vec3& p) {
  switch (s.kind) {
    case Surface::Kind::rectangle:
      return nearest_on_rectangle(s, p);
    case Surface::Kind::disc:
      return nearest_on_disc(s, p);
    case Surface::Kind::tube:
      return nearest_on_tube(s, p);
    case Surface::Kind::plane:
      break;
  }
  const double height = dot(p - s.centre, s.normal);
  return {p - height * s.normal, true, height};
}

Surface plane_surface(const std::string& name, const Vec3& point, const Vec3& normal) {
  Surface s;
  s.kind = Surface::Kind::plane;
  s.name = name;
  s.centre = point;
  s.normal = normal;
  return s;
}

std::vector<Surface> box_surfaces(const std::string& name, const Region& box,
                                  const std::vector<std::string>& open) {
  static constexpr const char* faces[6] = {"-x", "+x", "-y", "+y", "-z", "+z"};
  std::vector<Surface> surfaces;
  for (int face = 0; face < 6; ++face) {
    if (contains(open, faces[face])) continue;
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Surface s;
    s.kind = Surface::Kind::rectangle;
    s.name = name + "." + faces[face];
    s.centre = 0.5 * (box.min + box.max);
    s.centre[axis] = face % 2 == 0 ? box.min[axis] : box.max[axis];
    s.normal = s.side[0] = s.side[1] = Vec3{};
    s.normal[axis] = s.side[0][u] = s.side[1][v] = 1.0;
    s.half[0] = 0.5 * (box.max[u] - box.min[u]);
    s.half[1] = 0.5 * (box.max[v] - box.min[v]);
    surfaces.push_back(s);
  }
  return surfaces;
}

std::vector<Surface> cylinder_surfaces(const std::string& name, const Region& cylinder,
                                       const std::vector<std::string>& open) {
  std::vector<Surface> surfaces;
  Surface s;
  s.normal = cylinder.axis;
  s.half[0] = cylinder.radius;
  s.half[1] = cylinder.height;
  s.kind = Surface::Kind::tube;
  s.name = name + ".side";
  s.centre = cylinder.base;
  surfaces.push_back(s);
  s.kind = Surface::Kind::disc;
  if (!contains(open, "base")) {
    s.name = name + ".base";
    surfaces.push_back(s);
  }
  if (!contains(open, "top")) {
    s.name = name + ".top";
    s.centre = cylinder.base + cylinder.height * cylinder.axis;
    surfaces.push_back(s);
  }
  return surfaces;
}

}  // namespace pulvis
