#include "core/scene/cameras.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

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

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return result;
}

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

Result<float> numberFrom(const nlohmann::ordered_json& json, const std::string& pointer) {
  if (!json.is_number()) return inputError(pointer + " must be a number");
  const auto value = json.get<double>();
  if (!std::isfinite(value) || std::abs(value) > 1e30) return inputError(pointer + " must be a finite number");
  return static_cast<float>(value);
}

Result<glm::vec3> vectorFrom(const nlohmann::ordered_json& json, const std::string& pointer) {
  if (!json.is_array() || json.size() != 3) return inputError(pointer + " must be a list of three numbers");
  glm::vec3 result;
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Result<float> value = numberFrom(json[index], pointer + "/" + std::to_string(i));
    if (!value) return tl::unexpected(value.error());
    result[i] = *value;
  }
  return result;
}

/// The double whose shortest decimal is that of the float, so that 0.45F is written 0.45.
double shortest(float value) {
  std::array<char, 48> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double result = 0.0;
  std::from_chars(text.data(), end, result);
  return result;
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
  const std::string id = lowered(name);
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

Result<Camera> cameraFromJson(const nlohmann::ordered_json& json, const std::string& pointer, const Camera& base) {
  if (!json.is_object())
    return inputError((pointer.empty() ? std::string("a camera") : pointer) + " must be an object");
  Camera camera = base;
  const auto readVector = [&](const char* key, glm::vec3& into) -> Result<void> {
    if (!json.contains(key)) return {};
    const Result<glm::vec3> value = vectorFrom(json[key], pointer + "/" + key);
    if (!value) return tl::unexpected(value.error());
    into = *value;
    return {};
  };
  if (auto r = readVector("position", camera.position); !r) return tl::unexpected(r.error());
  if (auto r = readVector("target", camera.target); !r) return tl::unexpected(r.error());
  if (auto r = readVector("up", camera.up); !r) return tl::unexpected(r.error());
  if (json.contains("vertical_fov_degrees")) {
    const Result<float> fov = numberFrom(json["vertical_fov_degrees"], pointer + "/vertical_fov_degrees");
    if (!fov) return tl::unexpected(fov.error());
    if (*fov <= 0.0F || *fov >= 180.0F) return inputError(pointer + "/vertical_fov_degrees must lie between 0 and 180");
    camera.verticalFovDegrees = *fov;
    camera.orthographicHeight.reset();
  }
  if (json.contains("orthographic_height") && !json["orthographic_height"].is_null()) {
    const Result<float> height = numberFrom(json["orthographic_height"], pointer + "/orthographic_height");
    if (!height) return tl::unexpected(height.error());
    if (*height <= 0.0F) return inputError(pointer + "/orthographic_height must be above 0");
    camera.orthographicHeight = *height;
  }
  const glm::vec3 forward = camera.target - camera.position;
  if (!(glm::length(forward) > 0.0F)) return inputError(pointer + "/position and target must differ");
  if (!(glm::length(glm::cross(forward, camera.up)) > 0.0F))
    return inputError(pointer + "/up must not lie along the viewing direction");
  return camera;
}

nlohmann::ordered_json cameraToJson(const Camera& camera) {
  const auto vector = [](const glm::vec3& v) {
    return nlohmann::ordered_json::array({shortest(v.x), shortest(v.y), shortest(v.z)});
  };
  nlohmann::ordered_json json;
  json["position"] = vector(camera.position);
  json["target"] = vector(camera.target);
  json["up"] = vector(camera.up);
  if (camera.orthographicHeight)
    json["orthographic_height"] = shortest(*camera.orthographicHeight);
  else
    json["vertical_fov_degrees"] = shortest(camera.verticalFovDegrees);
  return json;
}

}  // namespace dermis
