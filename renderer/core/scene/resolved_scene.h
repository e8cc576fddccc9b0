// A scene with everything its paths point to, decoded: what the renderer draws. Values shared by pointer are immutable;
// the renderer tells by pointer what has changed, so an unchanged image is never uploaded twice.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/model.h"
#include "core/scene/scene.h"

namespace dermis {

struct MeshBake;

/// The decoded light of an environment, not yet prefiltered. One lat-long image, or six cube faces, or a constant.
struct EnvironmentImages {
  std::shared_ptr<const Image> latLong;               ///< Float RGB(A), linear Rec.709, cleaned
  std::array<std::shared_ptr<const Image>, 6> faces;  ///< Float, +X −X +Y −Y +Z −Z; row 0 is t = 0
  glm::vec3 constant{0.0F};                           ///< where neither is set
  std::uint64_t contentHash = 0;                      ///< of the bytes; names the disk cache
  std::string name;
  /// While something of it is dragged: prefiltered coarsely, and not kept on disk.
  bool preview = false;
};

/// A slot's material with its decoded maps; images[i] belongs to TextureSlot i and is null where there is none.
struct ResolvedMaterial {
  Material material;
  std::array<std::shared_ptr<const Image>, kTextureSlotCount> images;
};

struct ResolvedScene {
  Scene scene;
  std::shared_ptr<const Model> model;                    ///< never null
  float millimetresPerUnit = 1000.0F;                    ///< the scene's, else the model's
  std::vector<ResolvedMaterial> slots;                   ///< parallel to model->slots
  std::shared_ptr<const EnvironmentImages> environment;  ///< never null
  /// What was baked of the model. Null: the renderer bakes it where RendererOptions::bakeMeshes says so.
  std::shared_ptr<const MeshBake> bake;
  Camera camera;  ///< the scene's, or one that frames the bounds
};

}  // namespace dermis
