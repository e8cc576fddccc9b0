#include "passes/displacement.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "core/material/parameter_table.h"

namespace dermis {

namespace {

constexpr auto kSlotIndex = static_cast<std::size_t>(TextureSlot::Displacement);
constexpr float kMostPieces = 64.0F;  // every driver's least GL_MAX_TESS_GEN_LEVEL

}  // namespace

bool canDisplace(const ResolvedScene& scene, std::size_t slot) {
  static const ParameterRow* const kRow = findParameter("surface.displacement_mm");
  const ResolvedMaterial& material = scene.slots[slot];
  return kRow->usedBy(material.material.model) && scene.model->hasUvs && material.images.at(kSlotIndex) != nullptr;
}

bool displaces(const ResolvedScene& scene, std::size_t slot) {
  return scene.slots[slot].material.parameters.surfaceDisplacementMm != 0.0F && canDisplace(scene, slot);
}

glm::vec2 valueRange(const Image& image) {
  if (!image.isFloatingPoint()) return {0.0F, 1.0F};
  glm::vec2 range(std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest());
  const std::size_t size = bytesPerChannel(image.type);
  for (std::size_t at = 0; at + size <= image.pixels.size(); at += size) {
    float value = 0.0F;
    if (image.type == PixelType::Half) {
      std::uint16_t bits = 0;
      std::memcpy(&bits, image.pixels.data() + at, sizeof bits);
      value = glm::unpackHalf1x16(bits);
    } else {
      std::memcpy(&value, image.pixels.data() + at, sizeof value);
    }
    if (!std::isfinite(value)) continue;
    range = {std::min(range.x, value), std::max(range.y, value)};
  }
  return range.x <= range.y ? range : glm::vec2(0.0F);
}

float displacementReach(const ResolvedScene& scene, std::size_t slot, const glm::vec2& values) {
  if (!displaces(scene, slot)) return 0.0F;
  const Material& material = scene.slots[slot].material;
  const MapBlock map = packMap(TextureSlot::Displacement, material.texture(TextureSlot::Displacement));
  // Luminance is a mean of channels; the alpha of an opaque image, 1, may be what is read.
  const glm::vec2 wide(std::min(values.x, 1.0F), std::max(values.y, 1.0F));
  const glm::vec2 read = map.transform.x * wide + map.transform.y - material.parameters.surfaceDisplacementMidlevel;
  return std::max(std::abs(read.x), std::abs(read.y)) * std::abs(material.parameters.surfaceDisplacementMm) /
         scene.millimetresPerUnit;
}

gl::ProgramSources tessellated(gl::ProgramSources sources) {
  sources.tessControl = "displace.tesc";
  sources.tessEvaluation = "displace.tese";
  sources.defines.emplace_back("DERMIS_DISPLACED");
  return sources;
}

DisplacementView displacementView(const CameraMatrices& camera, glm::ivec2 size, float pixelsPerPiece) {
  DisplacementView view;
  view.clipFromWorld = camera.viewProjection;
  view.eye = camera.orthographic ? glm::vec4(-camera.forward, 1.0F) : glm::vec4(camera.position, 0.0F);
  view.pixelsPerUnit = 0.5F * static_cast<float>(size.y) * camera.projection[1][1];
  view.pixelsPerPiece = pixelsPerPiece;
  return view;
}

float pixelsPerPiece(bool moving, bool software) { return (software ? 6.0F : 4.0F) * (moving ? 2.5F : 1.0F); }

gl::ProgramSources displacedCasterProgram() {
  gl::ProgramSources sources;
  sources.vertex = "surface.vert";
  sources.fragment = "shadow.frag";
  return tessellated(std::move(sources));
}

void drawDisplaced(const gl::Program& program, const SlotResources& slot, const Geometry& geometry, std::size_t part,
                   const DisplacementView& view) {
  const DisplacementDensity& density = geometry.displacementDensity(part);
  // Clip space's sides, x and y within ±w, as planes (Gribb & Hartmann 2001).
  const glm::mat4 rows = glm::transpose(view.clipFromWorld);
  std::array<glm::vec4, 4> planes = {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1]};
  for (glm::vec4& plane : planes) plane /= std::max(glm::length(glm::vec3(plane)), 1e-20F);

  const auto transform = slot.draw.maps.at(kSlotIndex).transform;
  const gl::Texture& map = *slot.textures.at(kSlotIndex);
  const float texels = std::sqrt(static_cast<float>(map.width()) * static_cast<float>(map.height()) *
                                 std::abs(transform.z * transform.w)) *
                       density.uvPerUnit;
  const float pieces = view.pixelsPerUnit / view.pixelsPerPiece;
  const glm::vec4 detail(pieces, kMostPieces, texels / pieces, view.leastFacing);
  glUniformMatrix4fv(program.uniform("u_displace_clip"), 1, GL_FALSE, &view.clipFromWorld[0][0]);
  glUniform4fv(program.uniform("u_displace_eye"), 1, &view.eye[0]);
  glUniform4fv(program.uniform("u_displace_planes"), 4, &planes[0][0]);
  glUniform4fv(program.uniform("u_displace_detail"), 1, &detail[0]);
  glUniform2f(program.uniform("u_displace_texels"), texels * density.meanEdge / kMostPieces, texels * density.meanEdge);
  glUniform1f(program.uniform("u_displace_reach"), slot.displacementReach);
  geometry.drawPatches(part, program.uniform("u_displace_seam"));
}

}  // namespace dermis
