// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "output/renderer.hpp"

namespace pulvis {
namespace {

constexpr double degree = 3.14159265358979 / 180.0;
constexpr double azimuth = 24.0 * degree;               // beside the normal of the cut, so that depth is seen
constexpr double elevation = 22.0 * degree;             // enough to see the floor and the powder's surface
constexpr double elevation_from_above = 55.0 * degree;  // onto a horizontal cut
constexpr double margin = 1.03;                         // air around the scene

Vec3 unit(const Vec3& a) { return a / norm(a); }

// Any direction square to `up`; for the usual upward z it is -y, the front of a case.
Vec3 some_front(const Vec3& up) {
  const Vec3 first = std::abs(up.y) < 0.9 ? Vec3{0.0, -1.0, 0.0} : Vec3{1.0, 0.0, 0.0};
  return unit(first - dot(first, up) * up);
}

// The direction from the scene towards the eye.
Vec3 towards_eye(const std::optional<CutPlane>& cut, const Vec3& up) {
  Vec3 front = some_front(up);
  double rise = elevation;
  if (cut) {
    const double vertical = dot(cut->normal, up);
    const Vec3 level = cut->normal - vertical * up;
    if (norm(level) > 0.3) front = unit(level);
    if (std::abs(vertical) > 0.6) rise = std::copysign(elevation_from_above, vertical);
  }
  const Vec3 side = cross(up, front);
  const Vec3 turned = std::cos(azimuth) * front + std::sin(azimuth) * side;
  return std::cos(rise) * turned + std::sin(rise) * up;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double place, double radius) {
    low = std::min(low, place - radius);
    high = std::max(high, place + radius);
  }
  double size() const { return std::max(high - low, 0.0); }
  double centre() const { return high < low ? 0.0 : 0.5 * (low + high); }
};

}  // namespace

Camera camera_for(const PictureGeometry& geometry, const Vec3& up, const Frame& frame) {
  const Vec3 vertical = unit(up);
  Camera camera;
  camera.forward = -towards_eye(geometry.cut, vertical);
  camera.right = unit(cross(camera.forward, vertical));
  camera.up = cross(camera.right, camera.forward);

  Extent across, upright;
  const auto add = [&](const Vec3& place, double radius) {
    across.add(dot(place, camera.right), radius);
    upright.add(dot(place, camera.up), radius);
  };
  for (const Ball& sphere : geometry.spheres) add({sphere.x, sphere.y, sphere.z}, sphere.radius);
  for (const Vec3& corner : geometry.wall_corners) add(corner, 0.0);
  camera.centre_right = across.centre();
  camera.centre_up = upright.centre();
  camera.pixel = margin * std::max({across.size() / frame.width, upright.size() / frame.height, 1e-6});
  return camera;
}

}  // namespace pulvis
