#include "core/bake/ray_scene.h"

#include <embree3/rtcore.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

namespace dermis {

namespace {

RTCRayHit rayFrom(const glm::vec3& o, const glm::vec3& d, float nearest) {
  RTCRayHit ray{};
  ray.ray = RTCRay{o.x, o.y, o.z, nearest, d.x, d.y, d.z, 0.0F, std::numeric_limits<float>::infinity(), ~0U, 0, 0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

struct RayScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(const Model& model, const std::vector<bool>& castingSlots) {
  RayScene made;
  Bounds bounds;
  for (const ModelPart& part : model.parts) {
    if (part.slot < castingSlots.size() && !castingSlots[part.slot]) continue;
    for (std::uint32_t i = part.firstIndex; i + 2 < part.firstIndex + part.indexCount; i += 3) {
      const glm::uvec3 corners(model.indices[i], model.indices[i + 1], model.indices[i + 2]);
      const glm::vec3& a = model.positions[corners.x];
      const glm::vec3 normal = glm::cross(model.positions[corners.y] - a, model.positions[corners.z] - a);
      // The vertex normals say which side is outside, whatever the winding.
      const glm::vec3 sum = model.normals[corners.x] + model.normals[corners.y] + model.normals[corners.z];
      made.m_corners.push_back(corners);
      made.m_outward.push_back(glm::dot(normal, sum) < 0.0F ? -normal : normal);
      for (int c = 0; c < 3; ++c) bounds.grow(model.positions[corners[c]]);
    }
  }
  made.m_bias = 1e-5F * bounds.radius();

  made.m_handles = std::make_unique<Handles>();
  RTCDevice device = made.m_handles->device = rtcNewDevice(nullptr);
  if (device == nullptr)
    return runtimeError("Embree does not start (error " + std::to_string(rtcGetDeviceError(nullptr)) +
                        "); thickness and occlusion cannot be computed from the model");
  RTCScene scene = made.m_handles->scene = rtcNewScene(device);
  if (!made.m_corners.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                             model.positions.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3),
                                              made.m_corners.size());
    if (vertices != nullptr && triangles != nullptr) {
      std::memcpy(vertices, model.positions.data(), model.positions.size() * sizeof(glm::vec3));
      std::memcpy(triangles, made.m_corners.data(), made.m_corners.size() * sizeof(glm::uvec3));
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    return runtimeError("Embree cannot hold the model (error " + std::to_string(error) +
                        "); thickness and occlusion are not computed from it");
  return made;
}

void RayScene::blocked(const glm::vec3& origin, std::span<const glm::vec3> directions, std::span<bool> result) const {
  // In streams: a third faster than one by one.
  constexpr std::size_t kStream = 128;
  std::array<RTCRay, kStream> rays;
  for (std::size_t first = 0; first < directions.size(); first += kStream) {
    const std::size_t count = std::min(kStream, directions.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec3& d = directions[first + i];
      rays[i] = RTCRay{origin.x, origin.y, origin.z, 0.0F, d.x, d.y, d.z, 0.0F, std::numeric_limits<float>::infinity(),
                       ~0U,      0,        0};
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1M(m_handles->scene, &context, rays.data(), static_cast<unsigned>(count), sizeof(RTCRay));
    for (std::size_t i = 0; i < count; ++i) result[first + i] = rays[i].tfar < 0.0F;
  }
}

void RayScene::firstHits(const glm::vec3& origin, std::span<const glm::vec3> directions,
                         std::span<std::optional<Hit>> result) const {
  constexpr std::size_t kStream = 128;
  std::array<RTCRayHit, kStream> rays;
  for (std::size_t first = 0; first < directions.size(); first += kStream) {
    const std::size_t count = std::min(kStream, directions.size() - first);
    for (std::size_t i = 0; i < count; ++i) rays[i] = rayFrom(origin, directions[first + i], 0.0F);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1M(m_handles->scene, &context, rays.data(), static_cast<unsigned>(count), sizeof(RTCRayHit));
    for (std::size_t i = 0; i < count; ++i) {
      const RTCRayHit& ray = rays[i];
      result[first + i].reset();
      if (ray.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        result[first + i] = Hit{ray.ray.tfar, ray.hit.primID, {ray.hit.u, ray.hit.v}};
    }
  }
}

std::optional<RayScene::Hit> RayScene::exitAlong(const glm::vec3& origin, const glm::vec3& direction,
                                                 float contact) const {
  constexpr int kMostSurfaces = 16;
  std::optional<Hit> left;  // where the last body ended
  float nearest = 0.0F;
  for (int i = 0, inside = 1; i < kMostSurfaces; ++i) {
    RTCRayHit ray = rayFrom(origin, direction, nearest);
    if (left) ray.ray.tfar = left->distance + contact;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(m_handles->scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return left;
    const bool leaves = glm::dot(m_outward[ray.hit.primID], direction) > 0.0F;
    if (left && leaves) return left;
    left.reset();
    inside += leaves ? -1 : 1;
    if (inside == 0) left = Hit{ray.ray.tfar, ray.hit.primID, {ray.hit.u, ray.hit.v}};
    nearest = ray.ray.tfar + m_bias;
  }
  return left;
}

}  // namespace dermis
