#include "ui/document/carry_over.h"

#include <algorithm>

#include "core/base/file_reference.h"
#include "core/builtin/head/head.h"
#include "core/builtin/head/head_look.h"
#include "core/material/parameter_table.h"

namespace dermis {
namespace {

/// Puts the new model's own maps in place of those that belong to the earlier one; what multiplied such a map is itself
/// again where there is none. Which they were.
std::vector<std::size_t> replaceBelonging(Material& material, const Material& imported, bool isHead) {
  std::vector<std::size_t> replaced;
  for (std::size_t i = 0; i < kTextureSlotCount; ++i) {
    TextureBinding& binding = material.textures.at(i);
    const bool belongs = embeddedIndex(binding.path).has_value() || (!isHead && isHeadMap(binding.path));
    if (!belongs) continue;
    binding = imported.textures.at(i);
    replaced.push_back(i);
    if (binding.present()) continue;
    for (const ParameterRow& row : parameterTable())
      if (row.map == static_cast<TextureSlot>(i)) row.set(material.parameters, row.defaultValue());
  }
  return replaced;
}

/// Maps that belong to the earlier model stay with it: those that travelled inside its file and those that are laid out
/// for the built-in head.
void replaceBelonging(SlotLook& look, const ResolvedMaterial& imported, bool isHead) {
  const std::vector<std::size_t> replaced = replaceBelonging(look.worn.material, imported.material, isHead);
  if (replaced.empty()) return;
  for (const std::size_t i : replaced) look.worn.images.at(i) = imported.images.at(i);
  const std::string preset = look.binding ? look.binding->presetPath : std::string();
  bool edited = !preset.empty();
  // A preset that is no file is laid on the new model in the same way: edited is what somebody has changed since.
  if (preset.empty() && look.preset) {
    Material fitting = *look.preset;
    replaceBelonging(fitting, imported.material, isHead);
    edited = !(fitting == look.worn.material);
    look.preset = std::make_shared<Material>(std::move(fitting));
  }
  look.binding = MaterialBinding{look.worn.material, preset, edited};
}

}  // namespace

CarriedOver::CarriedOver(const Model& from, const Model& to)
    : m_from(from.bounds.centre()),
      m_to(to.bounds.centre()),
      m_ratio(to.bounds.radius() / std::max(from.bounds.radius(), 1e-12F)) {}

Camera CarriedOver::operator()(const Camera& camera) const {
  Camera next = camera;
  next.position = (*this)(camera.position);
  next.target = (*this)(camera.target);
  if (next.orthographicHeight) *next.orthographicHeight *= m_ratio;
  return next;
}

WholeLook carryOver(const WholeLook& before, const ModelSource& source, std::shared_ptr<const Model> model,
                    std::vector<ResolvedMaterial> imported) {
  WholeLook after = before;
  after.scene.model = source;
  after.millimetresPerUnit = source.millimetresPerUnit.value_or(model->millimetresPerUnit);

  const bool isHead = headLevel(source.builtin).has_value();
  after.slotLooks.clear();
  for (std::size_t i = 0; i < model->slots.size(); ++i) {
    const std::string& name = model->slots[i].name;
    const SlotLook* kept = nullptr;
    for (std::size_t j = 0; j < before.slotLooks.size(); ++j)
      if (before.model->slots[j].name == name) kept = &before.slotLooks[j];
    SlotLook look;
    if (kept != nullptr) {
      look = *kept;
      replaceBelonging(look, imported[i], isHead);
    } else if (const auto shelved = before.shelved.find(name); shelved != before.shelved.end()) {
      look = shelved->second;
      replaceBelonging(look, imported[i], isHead);
    } else {
      look.worn = std::move(imported[i]);
      look.binding = MaterialBinding{look.worn.material, {}, false};
    }
    if (look.binding) after.scene.materials[name] = *look.binding;
    after.slotLooks.push_back(std::move(look));
  }
  // Looks of slots that this model lacks wait for a model that has them.
  for (std::size_t j = 0; j < before.slotLooks.size(); ++j)
    after.shelved[before.model->slots[j].name] = before.slotLooks[j];

  if (before.model) {
    const CarriedOver place(*before.model, *model);
    const float s = place.ratio();
    const float millimetres = s * after.millimetresPerUnit / before.millimetresPerUnit;
    for (Light& light : after.scene.lights) {
      light.position = place(light.position);
      if (light.type != LightType::Directional) light.intensity *= s * s;
      if (light.animation.kind == AnimationKind::Sway) light.animation.amplitude *= s;
      light.radiusMm *= millimetres;
      light.sizeMm *= millimetres;
    }
    for (CameraBookmark& bookmark : after.scene.bookmarks) bookmark.camera = place(bookmark.camera);
    after.camera = place(after.camera);
    after.scene.camera = after.camera;
  }
  after.model = std::move(model);
  return after;
}

}  // namespace dermis
