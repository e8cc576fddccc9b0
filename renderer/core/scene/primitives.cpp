#include "core/scene/primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "core/base/file_reference.h"

namespace dermis {
namespace {

constexpr float kPrimitiveMillimetresPerUnit = 100.0F;

Model namedPrimitive() {
  Model model;
  model.slots.push_back({"default", Material{}});
  model.millimetresPerUnit = kPrimitiveMillimetresPerUnit;
  model.unitSource = "built in: 100 mm";
  return model;
}

void closeSinglePart(Model& model) {
  model.parts = {{0, 0, static_cast<std::uint32_t>(model.indices.size())}};
  for (const glm::vec3& p : model.positions) model.bounds.grow(p);
}

std::string uniqueSlotName(const Model& model, const std::string& name) {
  const auto taken = [&](const std::string& candidate) {
    return std::any_of(model.slots.begin(), model.slots.end(), [&](const ModelSlot& s) { return s.name == candidate; });
  };
  if (!taken(name)) return name;
  for (int i = 2;; ++i)
    if (std::string candidate = name + "." + std::to_string(i); !taken(candidate)) return candidate;
}

/// `embedded:N` counts from the start of a model's own list, which now begins `offset` images later.
void shiftEmbedded(Material& material, std::size_t offset) {
  for (TextureBinding& binding : material.textures)
    if (const auto index = embeddedIndex(binding.path)) binding.path = embeddedReference(*index + offset);
}

}  // namespace

Model makeSphere(int segments) {
  Model model = namedPrimitive();
  const int columns = std::max(segments, 8);
  const int rows = columns / 2;
  const double pi = std::numbers::pi;
  const auto vertexCount = static_cast<std::size_t>(columns + 1) * static_cast<std::size_t>(rows + 1);
  model.positions.reserve(vertexCount);
  model.normals.reserve(vertexCount);
  model.tangents.reserve(vertexCount);
  model.uvs.reserve(vertexCount);

  for (int j = 0; j <= rows; ++j) {
    const double theta = pi * (1.0 - static_cast<double>(j) / rows);  // from the upper pole; row 0 is the lower one
    const bool pole = j == 0 || j == rows;
    for (int i = 0; i <= columns; ++i) {
      // A pole has one vertex a column; it takes the u of the middle of its only triangle.
      const double u = (static_cast<double>(i) + (pole ? 0.5 : 0.0)) / columns;
      const double phi = (u - 0.5) * 2.0 * pi;
      const double sine = pole ? 0.0 : std::sin(theta);
      const glm::vec3 n(static_cast<float>(sine * std::sin(phi)), static_cast<float>(std::cos(theta)),
                        static_cast<float>(sine * std::cos(phi)));
      model.positions.push_back(n);
      model.normals.push_back(n);
      model.tangents.emplace_back(static_cast<float>(std::cos(phi)), 0.0F, static_cast<float>(-std::sin(phi)), 1.0F);
      model.uvs.emplace_back(static_cast<float>(u), static_cast<float>(static_cast<double>(j) / rows));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      if (j > 0)
        model.indices.insert(model.indices.end(), {at(i, j), at(i + 1, j), at(j == rows - 1 ? i : i + 1, j + 1)});
      if (j < rows - 1) model.indices.insert(model.indices.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  closeSinglePart(model);
  return model;
}

Model makePlane() {
  Model model = namedPrimitive();
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
    model.positions.emplace_back(uv * 2.0F - 1.0F, 0.0F);
    model.normals.emplace_back(0.0F, 0.0F, 1.0F);
    model.tangents.emplace_back(1.0F, 0.0F, 0.0F, 1.0F);
    model.uvs.push_back(uv);
  }
  model.indices = {0, 1, 2, 0, 2, 3};
  closeSinglePart(model);
  return model;
}

void appendModel(Model& model, const Model& other, const Placement& placement) {
  const bool first = model.positions.empty();
  glm::mat4 turn(1.0F);
  turn = glm::rotate(turn, glm::radians(placement.rotateDegrees.z), glm::vec3(0, 0, 1));
  turn = glm::rotate(turn, glm::radians(placement.rotateDegrees.y), glm::vec3(0, 1, 0));
  turn = glm::rotate(turn, glm::radians(placement.rotateDegrees.x), glm::vec3(1, 0, 0));
  const glm::mat3 linear = glm::mat3(turn) * glm::mat3(glm::scale(glm::mat4(1.0F), placement.scale));
  // Normals go with the inverse transpose. A mirroring scale also turns triangles and bitangents round.
  const float determinant = glm::determinant(linear);
  const bool invertible = std::abs(determinant) > 1e-30F;
  const glm::mat3 normalMatrix = invertible ? glm::transpose(glm::inverse(linear)) : glm::mat3(turn);
  const bool mirrored = determinant < 0.0F;
  const auto unitOr = [](const glm::vec3& v, const glm::vec3& fallback) {
    const float length = glm::length(v);
    return length > 0.0F && std::isfinite(length) ? v / length : fallback;
  };

  const auto vertexOffset = static_cast<std::uint32_t>(model.positions.size());
  const auto slotOffset = static_cast<std::uint32_t>(model.slots.size());
  const auto indexOffset = static_cast<std::uint32_t>(model.indices.size());
  for (std::size_t i = 0; i < other.positions.size(); ++i) {
    const glm::vec3 p = linear * other.positions[i] + placement.translate;
    model.positions.push_back(p);
    model.bounds.grow(p);
    model.normals.push_back(unitOr(normalMatrix * other.normals[i], other.normals[i]));
    const glm::vec3 tangent = unitOr(linear * glm::vec3(other.tangents[i]), glm::vec3(other.tangents[i]));
    model.tangents.emplace_back(tangent, mirrored ? -other.tangents[i].w : other.tangents[i].w);
    model.uvs.push_back(other.uvs[i]);
  }
  for (std::size_t i = 0; i + 2 < other.indices.size(); i += 3) {
    const std::uint32_t a = other.indices[i] + vertexOffset;
    const std::uint32_t b = other.indices[i + 1] + vertexOffset;
    const std::uint32_t c = other.indices[i + 2] + vertexOffset;
    model.indices.insert(model.indices.end(), {a, mirrored ? c : b, mirrored ? b : c});
  }
  for (const ModelPart& part : other.parts)
    model.parts.push_back({part.slot + slotOffset, part.firstIndex + indexOffset, part.indexCount});
  for (const ModelSlot& slot : other.slots) {
    ModelSlot added = slot;
    added.name = uniqueSlotName(model, slot.name);
    shiftEmbedded(added.imported, model.embedded.size());
    model.slots.push_back(std::move(added));
  }
  model.embedded.insert(model.embedded.end(), other.embedded.begin(), other.embedded.end());
  model.warnings.insert(model.warnings.end(), other.warnings.begin(), other.warnings.end());
  model.hasUvs = first ? other.hasUvs : model.hasUvs || other.hasUvs;
  if (first) {
    model.millimetresPerUnit = other.millimetresPerUnit;
    model.unitSource = other.unitSource;
  }
}

}  // namespace dermis
