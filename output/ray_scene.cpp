// SPDX-License-Identifier: Apache-2.0
#include "output/ray_scene.hpp"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace pulvis {
namespace {

// Embree gives no buffer of length nothing; no hit carries this number.
constexpr std::uint32_t empty_group = RTC_INVALID_GEOMETRY_ID;

RTCRay to_embree(const Ray& ray) {
  RTCRay result{};
  result.org_x = static_cast<float>(ray.origin.x);
  result.org_y = static_cast<float>(ray.origin.y);
  result.org_z = static_cast<float>(ray.origin.z);
  result.dir_x = static_cast<float>(ray.direction.x);
  result.dir_y = static_cast<float>(ray.direction.y);
  result.dir_z = static_cast<float>(ray.direction.z);
  result.tnear = static_cast<float>(ray.near);
  result.tfar = static_cast<float>(ray.far);
  result.mask = ~0u;
  return result;
}

void store(float* target, const Vec3& point) {
  target[0] = static_cast<float>(point.x);
  target[1] = static_cast<float>(point.y);
  target[2] = static_cast<float>(point.z);
}

}  // namespace

struct RayScene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  ~Embree() {
    if (scene != nullptr) ::rtcReleaseScene(scene);
    if (device != nullptr) ::rtcReleaseDevice(device);
  }

  RTCGeometry start(RTCGeometryType type) { return ::rtcNewGeometry(device, type); }

  template <class Number>
  Number* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t size,
                 std::size_t count) {
    void* data = ::rtcSetNewGeometryBuffer(geometry, type, 0, format, size, count);
    if (data == nullptr) {
      ::rtcReleaseGeometry(geometry);
      throw std::bad_alloc();
    }
    return static_cast<Number*>(data);
  }

  std::uint32_t attach(RTCGeometry geometry) {
    ::rtcCommitGeometry(geometry);
    const std::uint32_t group = ::rtcAttachGeometry(scene, geometry);
    ::rtcReleaseGeometry(geometry);
    return group;
  }

  void check() const {
    const RTCError error = ::rtcGetDeviceError(device);
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (error != RTC_ERROR_NONE)
      throw std::runtime_error(fmt::format("ray tracing failed, Embree error {}", static_cast<int>(error)));
  }
};

RayScene::RayScene(int threads) : embree_(std::make_unique<Embree>()) {
  embree_->device = ::rtcNewDevice(fmt::format("threads={}", std::max(threads, 0)).c_str());
  if (embree_->device == nullptr) throw std::runtime_error("ray tracing cannot start (Embree)");
  embree_->scene = ::rtcNewScene(embree_->device);
  ::rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_COMPACT);  // a million spheres beside the simulation
  embree_->check();
}

RayScene::~RayScene() = default;

std::uint32_t RayScene::add_spheres(std::span<const Ball> spheres) {
  if (spheres.empty()) return empty_group;
  RTCGeometry geometry = embree_->start(RTC_GEOMETRY_TYPE_SPHERE_POINT);
  std::ranges::copy(spheres, embree_->buffer<Ball>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                                   sizeof(Ball), spheres.size()));
  return embree_->attach(geometry);
}

std::uint32_t RayScene::add_discs(std::span<const Ball> discs, const Vec3& normal) {
  if (discs.empty()) return empty_group;
  RTCGeometry geometry = embree_->start(RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  std::ranges::copy(discs, embree_->buffer<Ball>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                                 sizeof(Ball), discs.size()));
  float* normals = embree_->buffer<float>(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3,
                                          3 * sizeof(float), discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) store(normals + 3 * i, normal);
  return embree_->attach(geometry);
}

std::uint32_t RayScene::add_triangles(std::span<const Vec3> corners) {
  if (corners.empty()) return empty_group;
  RTCGeometry geometry = embree_->start(RTC_GEOMETRY_TYPE_TRIANGLE);
  float* points = embree_->buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3,
                                         3 * sizeof(float), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) store(points + 3 * i, corners[i]);
  auto* indices = embree_->buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                                 3 * sizeof(std::uint32_t), corners.size() / 3);
  for (std::size_t i = 0; i < corners.size() / 3 * 3; ++i) indices[i] = static_cast<std::uint32_t>(i);
  return embree_->attach(geometry);
}

std::uint32_t RayScene::add_rods(std::span<const std::array<Vec3, 2>> rods, double radius) {
  if (rods.empty()) return empty_group;
  RTCGeometry geometry = embree_->start(RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  float* points = embree_->buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                         4 * sizeof(float), 2 * rods.size());
  auto* indices = embree_->buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT,
                                                 sizeof(std::uint32_t), rods.size());
  for (std::size_t i = 0; i < 2 * rods.size(); ++i) {
    store(points + 4 * i, rods[i / 2][i % 2]);
    points[4 * i + 3] = static_cast<float>(radius);
  }
  for (std::size_t i = 0; i < rods.size(); ++i) indices[i] = static_cast<std::uint32_t>(2 * i);
  return embree_->attach(geometry);
}

void RayScene::commit() {
  ::rtcCommitScene(embree_->scene);
  embree_->check();
}

std::optional<RayHit> RayScene::nearest(const Ray& ray) const {
  RTCIntersectContext context;
  ::rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = to_embree(ray);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ::rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Vec3 normal{query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z};
  const double length = norm(normal);
  return RayHit{query.ray.tfar, query.hit.geomID, query.hit.primID,
                length > 0.0 ? normal / length : -ray.direction};
}

bool RayScene::blocked(const Ray& ray) const {
  RTCIntersectContext context;
  ::rtcInitIntersectContext(&context);
  RTCRay query = to_embree(ray);
  ::rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0.0f;  // Embree's sign for "something is in the way"
}

}  // namespace pulvis
