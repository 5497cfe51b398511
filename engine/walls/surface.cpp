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
  if (distance <= s.radius && distance >= s.other_radius) return {s.centre + across, true, height};
  const double rim = distance > s.radius ? s.radius : s.other_radius;
  const Vec3 outward = distance > 0.0 ? across / distance : perpendicular(s.normal);
  return {s.centre + rim * outward, false, height};
}

/// In the half-plane through the axis the mantle is a straight line from (radius, 0) to (other_radius,
/// height).
NearestPoint nearest_on_frustum(const Surface& s, const Vec3& p) {
  const Vec3 from_end = p - s.centre;
  const double along = dot(from_end, s.normal);
  const Vec3 across = from_end - along * s.normal;
  const double distance = norm(across);
  const Vec3 outward = distance > 0.0 ? across / distance : perpendicular(s.normal);
  const double widening = s.other_radius - s.radius;
  if (widening == 0.0) {
    const double clamped = std::clamp(along, 0.0, s.height);
    return {s.centre + clamped * s.normal + s.radius * outward, clamped == along, distance - s.radius};
  }
  const double slant = root(square(widening) + square(s.height));
  const double out = widening / slant, up = s.height / slant;  // unit vector along the line
  const double way = (distance - s.radius) * out + along * up;
  const double clamped = std::clamp(way, 0.0, slant);
  return {s.centre + (clamped * up) * s.normal + (s.radius + clamped * out) * outward, clamped == way,
          (distance - s.radius) * up - along * out};
}

NearestPoint nearest_on_sphere(const Surface& s, const Vec3& p) {
  const Vec3 from_centre = p - s.centre;
  const double distance = norm(from_centre);
  const Vec3 outward = distance > 0.0 ? from_centre / distance : s.normal;
  return {s.centre + s.radius * outward, true, distance - s.radius};
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
    case Surface::Kind::frustum:
      return nearest_on_frustum(s, p);
    case Surface::Kind::sphere:
      return nearest_on_sphere(s, p);
    case Surface::Kind::plane:
    case Surface::Kind::patch:  // never asked here
      break;
  }
  const double height = dot(p - s.centre, s.normal);
  return {p - height * s.normal, true, height};
}

bool include(const Surface& s, Vec3& low, Vec3& high) {
  if (s.kind == Surface::Kind::plane || s.kind == Surface::Kind::patch) return false;
  const auto widen = [&](const Vec3& centre, const Vec3& reach) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = least(low[axis], centre[axis] - reach[axis]);
      high[axis] = greatest(high[axis], centre[axis] + reach[axis]);
    }
  };
  // How far a circle with this axis reaches along x, y and z.
  const auto across = [&](double radius) {
    const auto reach = [&](double along) { return radius * root(greatest(1.0 - square(along), 0.0)); };
    return Vec3{reach(s.normal.x), reach(s.normal.y), reach(s.normal.z)};
  };
  if (s.kind == Surface::Kind::rectangle) {
    Vec3 reach;
    for (int axis = 0; axis < 3; ++axis)
      reach[axis] = magnitude(s.side[0][axis]) * s.half[0] + magnitude(s.side[1][axis]) * s.half[1];
    widen(s.centre, reach);
  } else if (s.kind == Surface::Kind::sphere) {
    widen(s.centre, {s.radius, s.radius, s.radius});
  } else {
    widen(s.centre, across(s.radius));
    if (s.kind == Surface::Kind::frustum) widen(s.centre + s.height * s.normal, across(s.other_radius));
  }
  return true;
}

Surface plane_surface(const std::string& name, const Vec3& point, const Vec3& normal) {
  Surface s;
  s.kind = Surface::Kind::plane;
  s.name = name;
  s.centre = point;
  s.normal = normal;
  return s;
}

Surface disc_surface(const std::string& name, const Vec3& centre, const Vec3& normal, double radius,
                     double hole_radius) {
  Surface s = plane_surface(name, centre, normal);
  s.kind = Surface::Kind::disc;
  s.radius = radius;
  s.other_radius = hole_radius;
  return s;
}

Surface sphere_surface(const std::string& name, const Vec3& centre, double radius) {
  Surface s = plane_surface(name, centre, {0, 0, 1});
  s.kind = Surface::Kind::sphere;
  s.radius = radius;
  return s;
}

Surface rectangle_surface(const std::string& name, const Vec3& corner, const Vec3& along,
                          const Vec3& across) {
  Surface s;
  s.kind = Surface::Kind::rectangle;
  s.name = name;
  s.centre = corner + 0.5 * (along + across);
  s.half[0] = 0.5 * norm(along);
  s.half[1] = 0.5 * norm(across);
  s.side[0] = along / norm(along);
  s.side[1] = across / norm(across);
  s.normal = cross(s.side[0], s.side[1]);
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

std::vector<Surface> frustum_surfaces(const std::string& name, const Vec3& base, const Vec3& axis,
                                      double radius, double top_radius, double height,
                                      const std::vector<std::string>& open) {
  Surface side;
  side.kind = Surface::Kind::frustum;
  side.name = name + ".side";
  side.centre = base;
  side.normal = axis;
  side.radius = radius;
  side.other_radius = top_radius;
  side.height = height;
  std::vector<Surface> surfaces{side};
  if (radius > 0.0 && !contains(open, "base"))
    surfaces.push_back(disc_surface(name + ".base", base, axis, radius, 0.0));
  if (top_radius > 0.0 && !contains(open, "top"))
    surfaces.push_back(disc_surface(name + ".top", base + height * axis, axis, top_radius, 0.0));
  return surfaces;
}

std::vector<Surface> cylinder_surfaces(const std::string& name, const Region& c,
                                       const std::vector<std::string>& open) {
  return frustum_surfaces(name, c.base, c.axis, c.radius, c.radius, c.height, open);
}

}  // namespace pulvis
