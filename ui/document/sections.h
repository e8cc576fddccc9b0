// The sections of a document: what one undo entry keeps of before and after. Images are shared, never copied.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/resolved_scene.h"

namespace dermis {

/// What a slot wears, with the decoded maps, and the preset it came from.
struct SlotLook {
  ResolvedMaterial worn;                   ///< texture paths absolute, or embedded:N
  std::optional<MaterialBinding> binding;  ///< unset: worn because of "*", or because nothing was said
  std::shared_ptr<const Material> preset;  ///< the preset's content as it was read, where the look came from one

  /// Equal in meaning: a binding that says just what would be worn without it counts for nothing.
  bool operator==(const SlotLook& o) const {
    const auto path = [](const SlotLook& look) { return look.binding ? look.binding->presetPath : std::string(); };
    return worn.material == o.worn.material && worn.images == o.worn.images && preset == o.preset &&
           path(*this) == path(o);
  }
};

/// The model's size, with the lamps that are measured in millimetres.
struct ModelScale {
  std::optional<float> said;  ///< by the scene; unset: the model's own
  float used = 1000.0F;
  std::vector<Light> lights;
  bool operator==(const ModelScale&) const = default;
};

struct EnvironmentLook {
  EnvironmentSource source;
  std::shared_ptr<const EnvironmentImages> images;
  /// The images of a scene's own rig follow it (RigEdit).
  bool operator==(const EnvironmentLook& o) const {
    return source == o.source && (static_cast<bool>(source.rig) || images == o.images);
  }
};

struct Lens {
  float verticalFovDegrees = 26.0F;
  std::optional<float> orthographicHeight;
  bool operator==(const Lens&) const = default;
};

/// The whole of a document, for the steps that change all of it.
struct WholeLook {
  Scene scene;
  std::shared_ptr<const Model> model;
  float millimetresPerUnit = 1000.0F;
  std::vector<SlotLook> slotLooks;          ///< parallel to model->slots
  std::map<std::string, SlotLook> shelved;  ///< looks of slots that the model open now lacks
  std::shared_ptr<const EnvironmentImages> environment;
  Camera camera;
  bool operator==(const WholeLook&) const { return false; }  // never merges, so never compared
};

}  // namespace dermis
