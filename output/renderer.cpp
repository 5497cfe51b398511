// SPDX-License-Identifier: Apache-2.0
#include "output/renderer.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

#include "output/colour_map.hpp"

namespace pulvis {
namespace {

constexpr int samples_per_edge = 2;    // of a pixel: four smooth the outlines
constexpr int sky_rays = 6;            // per sample, so 24 per pixel
constexpr int most_wall_layers = 8;    // seen through one another
constexpr double eye_distance = 3.0;   // outside the scene, whose radius is one
constexpr double beyond = 6.0;         // behind the scene for a ray from the eye
constexpr double sky_reach = 12.0;     // mean radii; voids wider than this are lit by the sky
constexpr double through_cut = 0.4;    // of the light that comes in just through the cut: keeps voids dark
constexpr double light_spread = 0.10;  // rad, half angle of the key light: soft edges of shadows
constexpr double start_gap = 1e-4;     // starts rays off the cut and between layers of walls
constexpr float glass_cover = 0.13f;   // of a wall in front
constexpr float rim_shade = 0.45f;     // of a disc's outline
constexpr double edge_pixels = 0.6, section_pixels = 1.3;  // half the thickness of lines

// Light is added in linear parts, pictures store sRGB (IEC 61966-2-1).
struct Light {
  float red = 0.0f, green = 0.0f, blue = 0.0f;
};
Light operator*(float s, const Light& a) { return {s * a.red, s * a.green, s * a.blue}; }
Light operator+(const Light& a, const Light& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}

float to_linear(float part) {
  return part <= 0.04045f ? part / 12.92f : std::pow((part + 0.055f) / 1.055f, 2.4f);
}
float to_srgb(float part) {
  return part <= 0.0031308f ? 12.92f * part : 1.055f * std::pow(part, 1.0f / 2.4f) - 0.055f;
}
Light linear(const Colour& c) { return {to_linear(c.red), to_linear(c.green), to_linear(c.blue)}; }
Colour stored(const Light& l) {
  return {to_srgb(std::min(l.red, 1.0f)), to_srgb(std::min(l.green, 1.0f)), to_srgb(std::min(l.blue, 1.0f))};
}

const Light background = linear({1.0f, 1.0f, 1.0f});
const Light wall_colour = linear({0.86f, 0.88f, 0.91f});
const Light glass_colour = linear({0.62f, 0.68f, 0.76f});
const Light edge_colour = linear({0.36f, 0.40f, 0.46f});
const Light section_colour = linear({0.16f, 0.18f, 0.22f});

// Scatters the bits of a pixel's number (the finaliser of MurmurHash3, public domain).
std::uint32_t scatter(std::uint32_t n) {
  n = (n ^ n >> 16) * 0x85ebca6bu;
  n = (n ^ n >> 13) * 0xc2b2ae35u;
  return n ^ n >> 16;
}

// The two-dimensional sequence of the plastic number (M. Roberts, 2018) with a start per pixel: even cover of
// the unit square by any number of points.
class Sequence {
 public:
  explicit Sequence(std::uint32_t pixel)
      : first_(scatter(pixel) * 0x1p-32), second_(scatter(pixel ^ 0x9e3779b9u) * 0x1p-32) {}
  void next(double& u, double& v) {
    first_ += 0.7548776662466927, second_ += 0.5698402909980532;
    first_ -= std::floor(first_), second_ -= std::floor(second_);
    u = first_, v = second_;
  }

 private:
  double first_, second_;
};

// Two directions square to `axis` and to each other (T. Duff et al., JCGT 6(1), 2017).
void square_to(const Vec3& axis, Vec3& a, Vec3& b) {
  const double sign = std::copysign(1.0, axis.z);
  const double p = -1.0 / (sign + axis.z), q = axis.x * axis.y * p;
  a = {1.0 + sign * axis.x * axis.x * p, sign * q, -sign * axis.x};
  b = {q, sign + axis.y * axis.y * p, -axis.y};
}

// A direction about `axis`: `radius` is the sine of its angle to it.
Vec3 about(const Vec3& axis, double radius, double turn) {
  Vec3 a, b;
  square_to(axis, a, b);
  const double angle = 2.0 * 3.14159265358979 * turn;
  return radius * std::cos(angle) * a + radius * std::sin(angle) * b +
         std::sqrt(std::max(0.0, 1.0 - radius * radius)) * axis;
}

class Renderer {
 public:
  Renderer(const PictureGeometry& geometry, const Camera& camera, int threads)
      : geometry_(geometry), camera_(camera), powder_(threads), walls_(threads), lines_(threads) {
    spheres_ = powder_.add_spheres(geometry.spheres);
    if (geometry.cut) powder_.add_discs(geometry.discs, geometry.cut->normal);
    walls_.add_triangles(geometry.wall_corners);
    edges_ = lines_.add_rods(geometry.edges, edge_pixels * camera.pixel);
    lines_.add_rods(geometry.sections, section_pixels * camera.pixel);
    for (RayScene* scene : {&powder_, &walls_, &lines_}) scene->commit();
    // From the upper left behind the eye.
    const Vec3 key = 0.75 * camera.up - 0.55 * camera.right - 0.6 * camera.forward;
    key_ = key / norm(key);
  }

  Colour pixel(const Frame& frame, int x, int y) const {
    Sequence sequence(static_cast<std::uint32_t>(y * frame.width + x));
    Light sum;
    for (int i = 0; i < samples_per_edge * samples_per_edge; ++i) {
      const double px = x + (i % samples_per_edge + 0.5) / samples_per_edge - 0.5 * frame.width;
      const double py = y + (i / samples_per_edge + 0.5) / samples_per_edge - 0.5 * frame.height;
      const Vec3 origin = (camera_.centre_right + px * camera_.pixel) * camera_.right +
                          (camera_.centre_up - py * camera_.pixel) * camera_.up -
                          eye_distance * camera_.forward;
      sum = sum + sample(origin, sequence);
    }
    return stored(1.0f / (samples_per_edge * samples_per_edge) * sum);
  }

 private:
  Light sample(const Vec3& origin, Sequence& sequence) const {
    Ray ray{origin, camera_.forward, 0.0, beyond};
    // Lines lie in the cut itself and stand out of it by half their thickness, so they start at the eye.
    const auto line = lines_.nearest(ray);
    if (geometry_.cut) {
      const double slope = dot(camera_.forward, geometry_.cut->normal);
      if (std::abs(slope) > 1e-6)
        ray.near =
            std::max(0.0, dot(geometry_.cut->point - origin, geometry_.cut->normal) / slope - start_gap);
    }
    const auto powder = powder_.nearest(ray);
    const double slack = 4.0 * camera_.pixel;  // a line on a wall must not sink into it
    if (line && (!powder || line->distance < powder->distance + slack))
      return through_glass(ray, line->distance - slack, line->group == edges_ ? edge_colour : section_colour);
    if (powder) return through_glass(ray, powder->distance, shaded_powder(origin, *powder, sequence));
    return walls_alone(ray, sequence);
  }

  // Walls in front let through most of what is behind.
  Light through_glass(Ray ray, double distance, const Light& behind) const {
    ray.far = distance;
    float clear = 1.0f;
    for (int layer = 0; layer < most_wall_layers; ++layer) {
      const auto wall = walls_.nearest(ray);
      if (!wall) break;
      clear *= 1.0f - glass_cover;
      ray.near = wall->distance + start_gap;
    }
    return clear * behind + (1.0f - clear) * glass_colour;
  }

  // Where no powder is, the last wall closes the view.
  Light walls_alone(const Ray& ray, Sequence& sequence) const {
    std::optional<RayHit> last;
    Ray rest = ray;
    for (int layer = 0; layer < most_wall_layers; ++layer) {
      const auto wall = walls_.nearest(rest);
      if (!wall) break;
      last = wall;
      rest.near = wall->distance + start_gap;
    }
    if (!last) return background;
    Vec3 normal = last->normal;
    if (dot(normal, ray.direction) > 0.0) normal = -normal;
    const Vec3 place = ray.origin + last->distance * ray.direction + start_gap * normal;
    const double lit = 0.35 + 0.45 * sky(place, normal, sequence) + 0.24 * std::abs(dot(normal, key_));
    return through_glass(ray, last->distance - start_gap,
                         static_cast<float>(std::min(lit, 1.0)) * wall_colour);
  }

  Light shaded_powder(const Vec3& origin, const RayHit& hit, Sequence& sequence) const {
    const Vec3 place = origin + hit.distance * camera_.forward;
    if (hit.group != spheres_) return disc(place, hit.index);
    const Ball& sphere = geometry_.spheres[hit.index];
    const Vec3 outward = place - Vec3{sphere.x, sphere.y, sphere.z};
    const Vec3 normal = outward / norm(outward);
    const Vec3 start = place + 0.003 * sphere.radius * normal;
    const double light = 0.50 * sky(start, normal, sequence) + 0.55 * key_light(start, normal, sequence) +
                         0.08 * std::max(0.0, -dot(normal, camera_.forward));
    return static_cast<float>(light) * linear(viridis(geometry_.sphere_values[hit.index]));
  }

  // Plain, so that its colour is the colour bar's; a fine dark rim parts discs that touch.
  Light disc(const Vec3& place, std::uint32_t index) const {
    const Ball& disc = geometry_.discs[index];
    const double to_rim = disc.radius - norm(place - Vec3{disc.x, disc.y, disc.z});
    const double rim = std::min(0.9 * camera_.pixel, 0.12 * disc.radius);
    return (to_rim < rim ? rim_shade : 1.0f) * linear(viridis(geometry_.disc_values[index]));
  }

  // How much light arrives from `direction`, 0 to 1. Where the cut has taken the powder away nothing is in
  // the way; but light that falls through the cut onto what lies close behind it counts for less, since
  // voids that are as bright as the cut faces cannot be told from them.
  double arriving(const Vec3& start, const Vec3& direction, double reach) const {
    double share = 1.0;
    if (geometry_.cut) {
      const double slope = dot(direction, geometry_.cut->normal);
      const double depth = dot(geometry_.cut->point - start, geometry_.cut->normal);
      if (slope > 1e-9 && depth - start_gap < reach * slope) {
        reach = std::max(0.0, depth / slope - start_gap);
        if (reach < void_reach()) share = through_cut;
      }
    }
    return powder_.blocked({start, direction, 0.0, reach}) ? 0.0 : share;
  }

  double void_reach() const { return geometry_.mean_radius > 0.0 ? sky_reach * geometry_.mean_radius : 1.0; }

  // The part of the sky that is seen, weighted by its cosine.
  double sky(const Vec3& start, const Vec3& normal, Sequence& sequence) const {
    double light = 0.0;
    for (int i = 0; i < sky_rays; ++i) {
      double u = 0.0, v = 0.0;
      sequence.next(u, v);
      light += arriving(start, about(normal, std::sqrt(u), v), void_reach());
    }
    return light / sky_rays;
  }

  double key_light(const Vec3& start, const Vec3& normal, Sequence& sequence) const {
    double u = 0.0, v = 0.0;
    sequence.next(u, v);
    const Vec3 direction = about(key_, light_spread * std::sqrt(u), v);
    const double facing = dot(normal, direction);
    return facing > 0.0 ? facing * arriving(start, direction, beyond) : 0.0;
  }

  const PictureGeometry& geometry_;
  const Camera& camera_;
  RayScene powder_, walls_, lines_;
  std::uint32_t spheres_ = 0, edges_ = 0;
  Vec3 key_;
};

}  // namespace

void render(Image& image, const Frame& frame, const PictureGeometry& geometry, const Camera& camera,
            int threads) {
  const int count =
      threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const Renderer renderer(geometry, camera, count);
  // Rows are taken in turn, since those with powder cost most.
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int y = next_row++; y < frame.height; y = next_row++)
      for (int x = 0; x < frame.width; ++x)
        image.set(frame.left + x, frame.top + y, renderer.pixel(frame, x, y));
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < count; ++i) helpers.emplace_back(work);
  work();
}

}  // namespace pulvis
