#include "passes/scene_resources.h"

#include <algorithm>

#include "core/image/image_tiles.h"
#include "core/material/parameter_table.h"
#include "core/material/scattering_length.h"
#include "core/scene/missing_tiles.h"
#include "passes/displacement.h"

namespace dermis {

namespace {

bool sameEnvironment(const std::shared_ptr<const EnvironmentImages>& a,
                     const std::shared_ptr<const EnvironmentImages>& b) {
  if (a == b) return true;
  return a && b && a->contentHash != 0 && a->contentHash == b->contentHash && a->constant == b->constant;
}

DrawKind drawKindOf(const Material& material) {
  if (material.model == ShadingModel::Lens)
    return material.parameters.lensSeedBlending ? DrawKind::SeedBlended : DrawKind::Blended;
  if (material.model == ShadingModel::MetallicRoughness &&
      material.parameters.metallicRoughnessAlphaMode == AlphaMode::Blend)
    return DrawKind::Blended;
  return DrawKind::Opaque;
}

/// glTF asks for culling unless a material is double-sided; a lens is a shell whose far side is not seen. Everything
/// else draws both sides: scans have holes.
bool cullsBackFaces(const Material& material) {
  if (material.model == ShadingModel::Lens) return true;
  return material.model == ShadingModel::MetallicRoughness && !material.parameters.metallicRoughnessDoubleSided;
}

/// Whether some part is a cornea of its own.
bool hasShell(const ResolvedScene& scene) {
  return std::any_of(scene.slots.begin(), scene.slots.end(),
                     [](const ResolvedMaterial& slot) { return slot.material.model == ShadingModel::Lens; });
}

}  // namespace

bool isBlended(const Material& material) { return drawKindOf(material) != DrawKind::Opaque; }

bool hasCutOuts(const Material& material) {
  return material.model == ShadingModel::MetallicRoughness &&
         material.parameters.metallicRoughnessAlphaMode == AlphaMode::Mask;
}

bool samePicture(const ResolvedScene& a, const ResolvedScene& b) {
  if (a.model != b.model || a.bake != b.bake || a.millimetresPerUnit != b.millimetresPerUnit ||
      a.slots.size() != b.slots.size())
    return false;
  if (!sameEnvironment(a.environment, b.environment)) return false;
  const EnvironmentSource& ea = a.scene.environment;
  const EnvironmentSource& eb = b.scene.environment;
  if (ea.rotationDegrees != eb.rotationDegrees || ea.exposureStops != eb.exposureStops ||
      ea.background != eb.background)
    return false;
  if (a.scene.lights != b.scene.lights) return false;
  return std::equal(
      a.slots.begin(), a.slots.end(), b.slots.begin(), [](const ResolvedMaterial& x, const ResolvedMaterial& y) {
        return x.images == y.images && x.material.model == y.material.model &&
               x.material.parameters == y.material.parameters && x.material.textures == y.material.textures;
      });
}

SceneResources::SceneResources(const RendererOptions& options, bool software)
    : m_options(options),
      m_software(software),
      m_textures(options.maximumTextureSize, software ? 1.0F : 16.0F),
      m_dfg(DfgTables::create()) {
  m_canSkipDecode = epoxy_has_gl_extension("GL_EXT_texture_sRGB_decode");
  m_rawSampler = gl::Sampler::create("without sRGB decoding");
  const GLuint sampler = m_rawSampler.id();
  glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glSamplerParameteri(sampler, GL_TEXTURE_WRAP_T, GL_REPEAT);
  if (m_canSkipDecode) glSamplerParameteri(sampler, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  GLfloat most = 1.0F;
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
  glSamplerParameterf(sampler, GL_TEXTURE_MAX_ANISOTROPY, std::min(software ? 1.0F : 16.0F, most));

  // Bound while there is no environment: reading an unbound unit is defined, but drivers complain.
  const std::vector<float> black(6 * 4, 0.0F);
  m_blackCube = gl::Texture::create({.target = GL_TEXTURE_CUBE_MAP, .label = "no environment"});
  m_blackCube.uploadAll(0, GL_RGBA, GL_FLOAT, black.data());
  m_blackCubes = gl::Texture::create({.target = GL_TEXTURE_CUBE_MAP_ARRAY, .label = "no environment, prefiltered"});
  m_blackCubes.uploadAll(0, GL_RGBA, GL_FLOAT, black.data());
}

bool SceneResources::setScene(std::shared_ptr<const ResolvedScene> scene, gl::JobQueue& jobs) {
  if (scene == m_scene) return false;
  const bool changed = !m_scene || !scene || !samePicture(*m_scene, *scene);
  m_scene = std::move(scene);
  m_stale = true;
  if (m_scene) requestTextures(jobs);
  if (m_scene && m_options.bakeMeshes) m_meshBakes.want(*m_scene, m_options.cacheFolder, jobs);
  if (!m_scene || !m_scene->environment) return changed;

  if (!sameEnvironment(m_scene->environment, m_wantedEnvironment)) {
    m_wantedEnvironment = m_scene->environment;
    if (sameEnvironment(m_wantedEnvironment, m_environmentOf)) {
      jobs.cancel("environment");  // back to the one in use before the other was ready
    } else {
      EnvironmentBakeOptions bake;
      bake.cacheFolder = m_options.cacheFolder;
      if (m_software) bake.maximumSharpFace = 512;
      // The last complete environment stays in use until this one is complete.
      jobs.add("environment",
               makeEnvironmentJob(
                   m_wantedEnvironment, bake,
                   [this, images = m_wantedEnvironment](std::shared_ptr<const EnvironmentMap> map, Warnings warnings) {
                     ++(map->figures().fromCache ? m_environmentsFromCache : m_environmentsBaked);
                     m_environment = std::move(map);
                     m_environmentOf = images;
                     ++m_environmentRevision;
                     m_environmentWarnings.insert(m_environmentWarnings.end(), warnings.begin(), warnings.end());
                   }));
    }
  }
  return changed;
}

namespace {

/// How a slot's map is read. The thesis decodes its albedo in the shader. An 8-bit map keeps its sRGB format and is
/// bound with a sampler that doesn't decode, so that switching the shading model uploads nothing; others have no such
/// format.
TextureBinding readAs(const ResolvedMaterial& source, TextureSlot kind) {
  TextureBinding binding = source.material.texture(kind);
  const auto& image = source.images.at(static_cast<std::size_t>(kind));
  // Nor have sets of tiles, which that sampler would repeat.
  const bool decodesItself = source.material.model == ShadingModel::Thesis && kind == TextureSlot::Albedo;
  if (image && decodesItself && (image->type != PixelType::U8 || !image->tiles.empty())) binding.colorSpace = "raw";
  return binding;
}

}  // namespace

void SceneResources::requestTextures(gl::JobQueue& jobs) {
  if (!m_scene->model->hasUvs) return;
  bool any = false;
  for (const ResolvedMaterial& slot : m_scene->slots)
    for (std::size_t i = 0; i < kTextureSlotCount; ++i) {
      const auto kind = static_cast<TextureSlot>(i);
      if (slot.images.at(i) && m_textures.request(slot.images.at(i), readAs(slot, kind), kind, m_textureMessages))
        any = true;
    }
  if (!any) return;
  auto step = [this]() -> Result<bool> {
    const bool done = m_textures.step(m_textureMessages);
    if (done) {
      m_stale = true;
      ++m_textureRevision;
    }
    return done;
  };
  jobs.add("textures", gl::makeJob("Sending maps to the graphics driver", std::move(step),
                                   [this] { return m_textures.fraction(); }));
}

void SceneResources::upload(RenderStatistics& statistics, Warnings& messages) {
  if (!m_scene) return;
  if (m_geometry && m_model == m_scene->model) uploadBake();
  if (!m_stale) return;
  m_stale = false;
  messages.insert(messages.end(), m_textureMessages.begin(), m_textureMessages.end());
  m_textureMessages.clear();
  if (m_model != m_scene->model) {
    m_geometry = Geometry::upload(*m_scene->model);
    ++m_geometryRevision;
    m_model = m_scene->model;
    m_slots.clear();  // another model's maps must not stand in for this one's
    m_bake = nullptr;
    uploadBake();
    ++statistics.geometryUploads;
    statistics.triangles = m_model->indices.size() / 3;
  }
  statistics.diffusionKernelsMade += m_kernels.update(*m_scene, messages);
  m_slots.resize(m_scene->slots.size());
  float reach = 0.0F;
  for (std::size_t i = 0; i < m_slots.size(); ++i) {
    uploadSlot(i, statistics, messages);
    if (canDisplace(*m_scene, i)) m_geometry->prepareDisplacement(*m_model);
    reach = std::max(reach, m_slots[i].displacementReach);
  }
  m_bounds = m_model->bounds;
  m_bounds.min -= reach;
  m_bounds.max += reach;
  m_textures.releaseUnused();
  statistics.texturesUploaded = m_textures.uploaded();
  statistics.texturesReleased = m_textures.released();
  statistics.residentTextures = m_textures.resident();
}

void SceneResources::uploadBake() {
  std::shared_ptr<const MeshBake> bake = m_meshBakes.of(*m_scene);
  if (bake && bake->vertices.size() != m_model->positions.size()) bake = nullptr;
  if (bake == m_bake) return;
  m_geometry->setBake(bake.get());
  ++m_geometryRevision;
  m_bake = std::move(bake);
}

void SceneResources::wantCoarse() {
  if (m_geometry->hasCoarse() || m_model != m_scene->model) return;
  const auto levels = m_coarse.of(m_model);
  if (!levels) return;
  m_geometry->setCoarse(*levels);
}

int presentMaps(const ResolvedScene& scene, std::size_t slot) {
  int bits = 0;
  for (std::size_t i = 0; i < kTextureSlotCount; ++i)
    if (scene.model->hasUvs && scene.slots[slot].images.at(i)) bits |= 1 << i;
  return bits;
}

bool readsTiles(const ResolvedScene& scene, std::size_t slot) {
  const auto& images = scene.slots[slot].images;
  return scene.model->hasUvs &&
         std::any_of(images.begin(), images.end(), [](const auto& image) { return image && !image->tiles.empty(); });
}

gl::ProgramSources withTiles(gl::ProgramSources sources, bool tiled) {
  if (tiled) sources.defines.emplace_back("DERMIS_TILES");
  return sources;
}

std::shared_ptr<const gl::Texture> SceneResources::standIn(TextureSlot kind, bool asArray) {
  const bool normal = kind == TextureSlot::Normal || kind == TextureSlot::DetailNormal;
  const std::array<float, 4> texel =
      normal ? std::array<float, 4>{0.5F, 0.5F, 1.0F, 1.0F} : std::array<float, 4>{0.5F, 0.5F, 0.5F, 1.0F};
  gl::Texture texture =
      gl::Texture::create({.format = GL_RGBA16F, .width = 1, .height = 1, .label = "a map on its way"});
  texture.upload(0, GL_RGBA, GL_FLOAT, texel.data());
  return std::make_shared<gl::Texture>(asArray ? texture.asArray() : std::move(texture));
}

void SceneResources::uploadSlot(std::size_t index, RenderStatistics& statistics, Warnings& messages) {
  const ResolvedMaterial& source = m_scene->slots[index];
  SlotResources& slot = m_slots[index];
  slot.model = source.material.model;
  slot.kind = drawKindOf(source.material);
  slot.cullBackFaces = cullsBackFaces(source.material);
  slot.hasCutOuts = hasCutOuts(source.material);

  std::vector<std::byte> bytes = packMaterialBlock(source.material.parameters);
  if (bytes != slot.materialBytes) {
    if (!slot.materialBlock) slot.materialBlock = gl::Buffer::writable("material block", bytes.size());
    slot.materialBlock.update(0, bytes);
    slot.materialBytes = std::move(bytes);
    ++statistics.uniformBlocksUploaded;
  }

  DrawBlock draw;
  std::array<std::shared_ptr<const gl::Texture>, kTextureSlotCount> textures;
  // Without texture coordinates there is no place in a map to read.
  const bool hasUvs = m_scene->model->hasUvs;
  slot.tiled = readsTiles(*m_scene, index);
  for (std::size_t i = 0; i < kTextureSlotCount; ++i) {
    const auto kind = static_cast<TextureSlot>(i);
    const TextureBinding binding = readAs(source, kind);
    draw.maps.at(i) = packMap(kind, binding);
    if (!source.images.at(i) || !hasUvs) continue;
    textures.at(i) = m_textures.get(source.images.at(i), binding, kind, messages, slot.tiled);
    draw.mapTiles.at(i) = tileBits(*source.images.at(i));
    // Until a large map has arrived, the one before it stays.
    if (const auto& before = slot.textures.at(i); !textures.at(i)) {
      const bool fits = before && (before->spec().target == GL_TEXTURE_2D_ARRAY) == slot.tiled;
      textures.at(i) = fits ? before : standIn(kind, slot.tiled);
      draw.mapTiles.at(i) = fits ? slot.draw.mapTiles.at(i) : std::array<std::uint32_t, 4>{};
    } else if (before != textures.at(i)) {
      if (std::string missing = missingTilesText(*m_scene, index, kind); !missing.empty())
        messages.push_back(std::move(missing));
    }
    if (binding.flipGreen) draw.mapBits.y |= 1 << i;
  }
  slot.displaced = displaces(*m_scene, index);
  if (slot.displaced) {
    const auto& heights = source.images.at(static_cast<std::size_t>(TextureSlot::Displacement));
    if (slot.heightMap != heights) slot.heightValues = valueRange(*heights);
    slot.heightMap = heights;
  }
  slot.displacementReach = displacementReach(*m_scene, index, slot.heightValues);
  draw.mapBits.x = presentMaps(*m_scene, index);
  // Software GL runs both sides of a branch, so its programs leave out what fetches from absent maps.
  slot.constantMaps = m_software ? std::optional<int>(draw.mapBits.x) : std::nullopt;
  draw.mapBits.z = hasUvs ? 1 : 0;
  draw.mapBits.w = m_kernels.id(index);
  const ScatteringLength scattering = scatteringLength(source.material.parameters);
  draw.scattering = glm::vec4(scattering.mm, static_cast<float>(scattering.reading));
  draw.meanAlbedo = glm::vec4(m_kernels.meanAlbedo(*m_scene, index), 0.0F);
  if (slot.model == ShadingModel::Eye) {
    if (slot.eyesOf != m_model) {
      slot.eyes.clear();
      for (const ModelPart& part : m_model->parts)
        if (part.slot == index) slot.eyes = findEyeballs(*m_model, part);
      slot.eyesOf = m_model;
    }
    packEyes(draw, slot.eyes, hasShell(*m_scene));
  }
  slot.textures = std::move(textures);
  const bool isNew = !slot.drawBlock;
  if (isNew) slot.drawBlock = gl::Buffer::writable("draw block", sizeof(DrawBlock));
  if (isNew || !std::ranges::equal(bytesOf(draw), bytesOf(slot.draw))) {
    slot.draw = draw;
    slot.drawBlock.update(0, bytesOf(slot.draw));
    ++statistics.uniformBlocksUploaded;
  }
}

void SceneResources::bindLight() const {
  m_dfg.bind();
  if (m_environment) {
    m_environment->bind();
    return;
  }
  m_blackCubes.bind(EnvironmentMap::kPrefilteredUnit);
  m_blackCube.bind(EnvironmentMap::kIrradianceUnit);
  m_blackCube.bind(EnvironmentMap::kSharpUnit);
}

void SceneResources::bindSlot(const SlotResources& slot) const {
  slot.materialBlock.bindUniform(kMaterialBinding);
  slot.drawBlock.bindUniform(kDrawBinding);
  for (std::size_t i = 0; i < kTextureSlotCount; ++i)
    if (slot.textures.at(i)) slot.textures.at(i)->bind(static_cast<GLuint>(i));
  constexpr auto kAlbedoUnit = static_cast<GLuint>(TextureSlot::Albedo);
  glBindSampler(kAlbedoUnit, slot.model == ShadingModel::Thesis && m_canSkipDecode ? m_rawSampler.id() : 0);
}

void SceneResources::unbindSamplers() const { glBindSampler(static_cast<GLuint>(TextureSlot::Albedo), 0); }

}  // namespace dermis
