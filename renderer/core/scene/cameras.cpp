#include "core/scene/cameras.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/lower_case.h"

namespace dermis {
namespace {

constexpr std::array<NamedCameraRow, 8> kCameras = {{
    {"front", "Front"},
    {"three-quarter", "Three-quarter"},
    {"profile", "Profile"},
    {"ear", "Ear"},
    {"top-right", "Top right"},
    {"top-left", "Top left"},
    {"bottom-right", "Bottom right"},
    {"bottom-left", "Bottom left"},
}};

/// Space left round the framed bounds, as a factor.
constexpr float kMargin = 1.1F;
constexpr float kFieldOfView = 26.0F;

/// A box of these half extents, seen along `towards`, in view whole in a square picture: each corner gives the
/// distance at which it just touches the frustum.
float framingDistance(const glm::vec3& half, const glm::vec3& towards, const glm::vec3& up) {
  const glm::vec3 right = glm::normalize(glm::cross(up, towards));
  const glm::vec3 above = glm::cross(towards, right);
  const float slope = std::tan(glm::radians(kFieldOfView) * 0.5F);
  float distance = 0.0F;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p = half * glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const float extent = std::max(std::abs(glm::dot(p, right)), std::abs(glm::dot(p, above)));
    distance = std::max(distance, extent * kMargin / slope + glm::dot(p, towards));
  }
  return distance;
}

glm::vec3 halfExtents(const Bounds& bounds) {
  if (bounds.empty()) return glm::vec3(1.0F);
  return glm::max(0.5F * (bounds.max - bounds.min), glm::vec3(1e-6F));
}

}  // namespace

std::span<const NamedCameraRow> namedCameras() { return kCameras; }

Camera framingCamera(const Bounds& bounds, const glm::vec3& towardsCamera) {
  Camera camera;
  const glm::vec3 towards = glm::normalize(towardsCamera);
  camera.verticalFovDegrees = kFieldOfView;
  camera.target = bounds.centre();
  camera.up = std::abs(towards.y) > 0.999F ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  camera.position = camera.target + towards * framingDistance(halfExtents(bounds), towards, camera.up);
  return camera;
}

Camera framingCamera(const Bounds& bounds) { return framingCamera(bounds, {0.0F, 0.0F, 1.0F}); }

std::optional<Camera> namedCamera(std::string_view name, const Bounds& bounds) {
  const std::string id = lowerCase(name);
  if (id == "front") return framingCamera(bounds);
  if (id == "three-quarter") return framingCamera(bounds, {0.68F, 0.06F, 1.0F});
  if (id == "profile") return framingCamera(bounds, {1.0F, 0.0F, 0.0F});
  if (id == "top-right") return framingCamera(bounds, {0.6F, 0.5F, 1.0F});
  if (id == "top-left") return framingCamera(bounds, {-0.6F, 0.5F, 1.0F});
  if (id == "bottom-right") return framingCamera(bounds, {0.6F, -0.5F, 1.0F});
  if (id == "bottom-left") return framingCamera(bounds, {-0.6F, -0.5F, 1.0F});
  if (id == "ear") {
    // On a head the ear's middle lies a little above mid-height of what is usually cut at neck or shoulders, and an
    // ear is about a quarter of a head high.
    const glm::vec3 half = halfExtents(bounds);
    Camera camera = framingCamera(bounds, {1.0F, 0.05F, 0.25F});
    const glm::vec3 towards = glm::normalize(camera.position - camera.target);
    camera.target = bounds.centre() + glm::vec3(0.75F * half.x, 0.28F * half.y, 0.0F);
    camera.position =
        camera.target + towards * (0.36F * half.y / std::tan(glm::radians(kFieldOfView) * 0.5F) + 0.25F * half.x);
    return camera;
  }
  return std::nullopt;
}

void readCamera(JsonFields& fields, Camera& camera) {
  JsonReport& report = fields.report();
  fields.read("position", camera.position);
  fields.read("target", camera.target);
  fields.read("up", camera.up);
  if (!hasDirection(camera.up)) report.refuse(fields.pointerTo("up"), "has no direction; give a vector that is not 0");
  const glm::vec3 forward = camera.target - camera.position;
  if (!hasDirection(forward))
    report.refuse(fields.pointerTo("position"), "must differ from the target, or the camera looks nowhere");
  // The up vector's part across the view must be more than rounding.
  const glm::dvec3 across = glm::cross(glm::normalize(glm::dvec3(forward)), glm::normalize(glm::dvec3(camera.up)));
  if (!(glm::length(across) > 1e-5))
    report.refuse(fields.pointerTo("up"), "is parallel to the view direction; give another one");

  if (fields.find("vertical_fov_degrees") != nullptr) {
    fields.read("vertical_fov_degrees", camera.verticalFovDegrees);
    camera.orthographicHeight.reset();
    if (camera.verticalFovDegrees <= 0.0F || camera.verticalFovDegrees >= 180.0F)
      report.refuse(fields.pointerTo("vertical_fov_degrees"), "must be above 0 and below 180");
  }
  if (fields.find("orthographic_height") != nullptr) {
    float height = 1.0F;
    fields.read("orthographic_height", height);
    if (height <= 0.0F) report.refuse(fields.pointerTo("orthographic_height"), "must be above 0");
    camera.orthographicHeight = height;
  }
}

Result<Camera> cameraFromJson(const Json& json, const std::string& pointer, const Camera& base) {
  Camera camera = base;
  Warnings warnings;
  JsonReport report{"", warnings};
  JsonFields fields(json, pointer, report);
  readCamera(fields, camera);
  if (const Json unknown = fields.unknown(); !unknown.empty())
    report.refuse(fields.pointerTo(unknown.begin().key()), "is no key of a camera");
  if (report.error) return tl::unexpected(std::move(*report.error));
  return camera;
}

Json cameraToJson(const Camera& camera) {
  const auto vector = [](const glm::vec3& v) {
    return Json::array({jsonNumber(v.x), jsonNumber(v.y), jsonNumber(v.z)});
  };
  Json json = {{"position", vector(camera.position)}, {"target", vector(camera.target)}, {"up", vector(camera.up)}};
  if (camera.orthographicHeight)
    json["orthographic_height"] = jsonNumber(*camera.orthographicHeight);
  else
    json["vertical_fov_degrees"] = jsonNumber(camera.verticalFovDegrees);
  return json;
}

}  // namespace dermis
