// What a scene needs on the GPU: its geometry, its materials' blocks, its maps, its environment.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/scene/resolved_scene.h"
#include "gl/gl_objects.h"
#include "gl/job_queue.h"
#include "gl/shader_library.h"
#include "lighting/dfg_table.h"
#include "lighting/environment_map.h"
#include "passes/coarse_levels.h"
#include "passes/diffusion_kernels.h"
#include "passes/geometry.h"
#include "passes/mesh_bake_job.h"
#include "passes/texture_cache.h"
#include "passes/uniform_blocks.h"
#include "renderer.h"

namespace dermis {

/// How a part is drawn.
enum class DrawKind {
  Opaque,
  Blended,     ///< over what is there, premultiplied
  SeedBlended  ///< the same with the depth test off, as the published lens
};

/// One slot's material on the GPU.
struct SlotResources {
  ShadingModel model = ShadingModel::Skin;
  DrawKind kind = DrawKind::Opaque;
  bool cullBackFaces = false;
  bool hasCutOuts = false;          ///< discards where its alpha is low
  bool displaced = false;           ///< drawn as patches, through tessellated() programs
  float displacementReach = 0.0F;   ///< farthest that anything of it is displaced, scene units
  std::optional<int> constantMaps;  ///< the present maps, where the program knows them at compile time
  bool tiled = false;               ///< some map is a set of UDIM tiles: all are arrays, for programs withTiles()
  std::vector<std::byte> materialBytes;
  gl::Buffer materialBlock;
  DrawBlock draw;
  gl::Buffer drawBlock;
  std::array<std::shared_ptr<const gl::Texture>, kTextureSlotCount> textures;
  std::shared_ptr<const Image> heightMap;  ///< whose values `heightValues` are
  glm::vec2 heightValues{0.0F};
  std::shared_ptr<const Model> eyesOf;  ///< whose eyeballs `eyes` are
  std::vector<Eyeball> eyes;
};

class SceneResources {
 public:
  SceneResources(const RendererOptions& options, bool software);

  /// What to draw from now on; nothing is uploaded yet. True where the picture may change. A changed environment is
  /// queued.
  bool setScene(std::shared_ptr<const ResolvedScene> scene, gl::JobQueue& jobs);
  /// Uploads what the scene needs and isn't resident, and nothing else.
  void upload(RenderStatistics& statistics, Warnings& messages);

  /// Fewer triangles are wanted: geometry() has them some frames later.
  void wantCoarse();

  [[nodiscard]] bool isSoftware() const { return m_software; }
  [[nodiscard]] const ResolvedScene* scene() const { return m_scene.get(); }
  [[nodiscard]] const Geometry& geometry() const { return *m_geometry; }
  /// Grows whenever geometry() is another, or something else was baked of it.
  [[nodiscard]] std::uint64_t geometryRevision() const { return m_geometryRevision; }
  /// The model's, grown by what is displaced.
  [[nodiscard]] const Bounds& bounds() const { return m_bounds; }
  [[nodiscard]] const std::vector<SlotResources>& slots() const { return m_slots; }

  [[nodiscard]] const DiffusionKernels& kernels() const { return m_kernels; }

  /// Null until the first one is complete.
  [[nodiscard]] const EnvironmentMap* environment() const { return m_environment.get(); }
  /// Grows whenever another environment comes into use.
  [[nodiscard]] std::uint64_t environmentRevision() const { return m_environmentRevision; }
  /// The maps of the environment in use (black ones while there is none) and the DFG tables, on their units.
  void bindLight() const;
  /// A slot's blocks and maps.
  void bindSlot(const SlotResources& slot) const;
  void unbindSamplers() const;

  /// Grows whenever more is known of the model's vertices.
  [[nodiscard]] std::uint64_t meshBakeRevision() const { return m_meshBakes.revision(); }

  /// Grows whenever maps that were on their way have arrived.
  [[nodiscard]] std::uint64_t textureRevision() const { return m_textureRevision; }

  /// Forgets what jobs were for: another environment or model asks again.
  void jobsCancelled() {
    m_wantedEnvironment = m_environmentOf;
    m_meshBakes.cancelled();
    m_textures.forgetPending();
    m_stale = true;
  }
  [[nodiscard]] std::uint64_t environmentsBaked() const { return m_environmentsBaked; }
  [[nodiscard]] std::uint64_t environmentsFromCache() const { return m_environmentsFromCache; }
  [[nodiscard]] Warnings takeEnvironmentWarnings() { return std::exchange(m_environmentWarnings, {}); }

 private:
  /// Queues what is too large to be uploaded by a frame.
  void requestTextures(gl::JobQueue& jobs);
  /// In place of a map that is on its way and has nothing before it.
  [[nodiscard]] static std::shared_ptr<const gl::Texture> standIn(TextureSlot kind, bool asArray);
  void uploadBake();
  void uploadSlot(std::size_t index, RenderStatistics& statistics, Warnings& messages);

  RendererOptions m_options;
  bool m_software;
  std::shared_ptr<const ResolvedScene> m_scene;
  bool m_stale = false;

  std::shared_ptr<const Model> m_model;  ///< the one m_geometry is of
  std::optional<Geometry> m_geometry;
  std::uint64_t m_geometryRevision = 0;
  MeshBakes m_meshBakes;
  CoarseLevels m_coarse;
  std::shared_ptr<const MeshBake> m_bake;  ///< the one m_geometry has
  Bounds m_bounds;
  std::vector<SlotResources> m_slots;
  DiffusionKernels m_kernels;
  TextureCache m_textures;
  std::uint64_t m_textureRevision = 0;
  Warnings m_textureMessages;
  gl::Sampler m_rawSampler;  ///< skips sRGB decoding: the thesis decodes its albedo itself
  bool m_canSkipDecode = false;

  DfgTables m_dfg;
  gl::Texture m_blackCube, m_blackCubes;
  std::shared_ptr<const EnvironmentMap> m_environment;
  std::shared_ptr<const EnvironmentImages> m_environmentOf, m_wantedEnvironment;
  std::uint64_t m_environmentRevision = 0, m_environmentsBaked = 0, m_environmentsFromCache = 0;
  Warnings m_environmentWarnings;
};

/// Whether a material is drawn over what is there, after opaque ones.
[[nodiscard]] bool isBlended(const Material& material);

/// Whether a material discards where its alpha is low.
[[nodiscard]] bool hasCutOuts(const Material& material);

/// Bits, by TextureSlot, of the maps that a slot's material has and its model can place.
[[nodiscard]] int presentMaps(const ResolvedScene& scene, std::size_t slot);

/// Whether some map of a slot is a set of UDIM tiles.
[[nodiscard]] bool readsTiles(const ResolvedScene& scene, std::size_t slot);

/// The same program for such a slot (map_tiles.glsl), or as it is for others.
[[nodiscard]] gl::ProgramSources withTiles(gl::ProgramSources sources, bool tiled);

/// Whether two scenes give the same picture of the surface and sky (their camera and view apart).
[[nodiscard]] bool samePicture(const ResolvedScene& a, const ResolvedScene& b);

}  // namespace dermis
