// SPDX-License-Identifier: Apache-2.0
#include "output/picture_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace pulvis {
namespace {

struct Box {
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void add(const Vec3& point, double margin = 0.0) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis] - margin);
      high[axis] = std::max(high[axis], point[axis] + margin);
    }
  }
  bool empty() const { return low.x > high.x; }
  Vec3 centre() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * norm(high - low); }
};

// Height above the cut on the side taken away.
double height(const CutPlane& cut, const Vec3& point) { return dot(point - cut.point, cut.normal); }

Vec3 crossing(const Vec3& a, double height_a, const Vec3& b, double height_b) {
  return a + height_a / (height_a - height_b) * (b - a);
}

// The part of a segment behind the cut.
std::optional<Segment> behind(const Segment& segment, const std::optional<CutPlane>& cut) {
  if (!cut) return segment;
  const double a = height(*cut, segment[0]), b = height(*cut, segment[1]);
  if (a > 0.0 && b > 0.0) return std::nullopt;
  if (a <= 0.0 && b <= 0.0) return segment;
  const Vec3 middle = crossing(segment[0], a, segment[1], b);
  return a > 0.0 ? Segment{middle, segment[1]} : Segment{segment[0], middle};
}

// Cuts a triangle corner by corner (Sutherland and Hodgman): what remains has three or four corners.
void add_triangle_behind(PictureGeometry& geometry, const std::array<Vec3, 3>& triangle,
                         const std::optional<CutPlane>& cut) {
  std::vector<Vec3> kept, opened;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &here = triangle[i], &next = triangle[(i + 1) % 3];
    const double a = cut ? height(*cut, here) : -1.0, b = cut ? height(*cut, next) : -1.0;
    if (a <= 0.0) kept.push_back(here);
    if ((a <= 0.0) == (b <= 0.0)) continue;
    kept.push_back(crossing(here, a, next, b));
    opened.push_back(kept.back());
  }
  for (std::size_t i = 2; i < kept.size(); ++i)
    geometry.wall_corners.insert(geometry.wall_corners.end(), {kept[0], kept[i - 1], kept[i]});
  if (opened.size() == 2) geometry.sections.push_back({opened[0], opened[1]});
}

// Edges where triangles meet at more than 30 degrees or where no other triangle follows. Points are matched
// by their place, since meshes often give each triangle its own.
class SharpEdges {
 public:
  explicit SharpEdges(const Box& box) : grain_(1e-6 * std::max(box.radius(), 1e-300)) {}

  void add(const std::array<Vec3, 3>& triangle) {
    const Vec3 normal = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double length = norm(normal);
    if (length <= 0.0) return;
    for (std::size_t i = 0; i < 3; ++i) add_edge(triangle[i], triangle[(i + 1) % 3], normal / length);
  }

  template <class Use>
  void each(const Use& use) const {
    for (const auto& [key, edge] : edges_) {
      const bool smooth = edge.triangles == 2 && edge.cosine > std::cos(30.0 * 3.14159265358979 / 180.0);
      if (!smooth) use(edge.segment);
    }
  }

 private:
  using Place = std::array<std::int64_t, 3>;
  struct Edge {
    Segment segment;
    Vec3 normal;
    double cosine = 1.0;
    int triangles = 0;
  };

  Place place(const Vec3& point) const {
    return {std::llround(point.x / grain_), std::llround(point.y / grain_), std::llround(point.z / grain_)};
  }

  void add_edge(const Vec3& a, const Vec3& b, const Vec3& normal) {
    std::pair<Place, Place> ends{place(a), place(b)};
    if (ends.second < ends.first) std::swap(ends.first, ends.second);
    Edge& edge = edges_[ends];
    if (edge.triangles++ == 0) {
      edge.segment = {a, b};
      edge.normal = normal;
    } else {
      edge.cosine = std::abs(dot(edge.normal, normal));  // meshes need not be oriented
    }
  }

  double grain_;
  std::map<std::pair<Place, Place>, Edge> edges_;
};

struct KeptSpheres {
  std::vector<PictureSphere> whole, discs;
};

KeptSpheres spheres_behind(const std::vector<PictureSphere>& spheres, const std::optional<CutPlane>& cut) {
  KeptSpheres kept;
  kept.whole.reserve(spheres.size());
  for (const PictureSphere& sphere : spheres) {
    const double above = cut ? height(*cut, sphere.centre) : -sphere.radius;
    if (!(sphere.radius > 0.0) || !std::isfinite(above + norm(sphere.centre) + sphere.radius))
      throw std::invalid_argument("a sphere in a picture needs a finite place and a positive radius");
    if (above >= sphere.radius) continue;
    kept.whole.push_back(sphere);
    if (above <= -sphere.radius) continue;
    const double disc = std::sqrt(sphere.radius * sphere.radius - above * above);
    kept.discs.push_back({sphere.centre - above * cut->normal, disc, sphere.value});
  }
  return kept;
}

void add_walls(PictureGeometry& geometry, const SurfaceMesh& walls, const std::optional<CutPlane>& cut) {
  Box box;
  for (const Vec3& point : walls.points) box.add(point);
  SharpEdges sharp(box);
  for (const auto& corners : walls.triangles) {
    const std::array<Vec3, 3> triangle{walls.points.at(corners[0]), walls.points.at(corners[1]),
                                       walls.points.at(corners[2])};
    add_triangle_behind(geometry, triangle, cut);
    sharp.add(triangle);
  }
  sharp.each([&](const Segment& segment) {
    if (const auto rest = behind(segment, cut)) geometry.edges.push_back(*rest);
  });
}

}  // namespace

PictureGeometry picture_geometry(const PictureRequest& request) {
  PictureGeometry geometry;
  geometry.cut = request.cut;
  if (geometry.cut) geometry.cut->normal = geometry.cut->normal / norm(geometry.cut->normal);
  const KeptSpheres kept = spheres_behind(request.spheres, geometry.cut);
  add_walls(geometry, request.walls, geometry.cut);

  Box box;
  for (const PictureSphere& sphere : kept.whole) box.add(sphere.centre, sphere.radius);
  for (const Vec3& corner : geometry.wall_corners) box.add(corner);
  const Vec3 centre = box.empty() ? Vec3{} : box.centre();
  geometry.unit = box.empty() || box.radius() <= 0.0 ? 1.0 : box.radius();

  const auto scaled = [&](const Vec3& point) { return (point - centre) / geometry.unit; };
  const auto add = [&](const PictureSphere& sphere, std::vector<Ball>& balls, std::vector<float>& values) {
    const Vec3 place = scaled(sphere.centre);
    balls.push_back({static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z),
                     static_cast<float>(sphere.radius / geometry.unit)});
    values.push_back(sphere.value);
  };
  for (const PictureSphere& sphere : kept.whole) {
    add(sphere, geometry.spheres, geometry.sphere_values);
    geometry.mean_radius += sphere.radius / geometry.unit / static_cast<double>(kept.whole.size());
  }
  for (const PictureSphere& disc : kept.discs) add(disc, geometry.discs, geometry.disc_values);
  for (Vec3& corner : geometry.wall_corners) corner = scaled(corner);
  for (auto* segments : {&geometry.edges, &geometry.sections})
    for (Segment& segment : *segments) segment = {scaled(segment[0]), scaled(segment[1])};
  if (geometry.cut) geometry.cut->point = scaled(geometry.cut->point);
  return geometry;
}

}  // namespace pulvis
