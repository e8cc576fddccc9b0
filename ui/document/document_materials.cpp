// What slots wear: the part of Document that changes materials.
#include <algorithm>

#include "ui/document/document_commit.h"
#include "ui/text.h"
#include "ui/translation.h"

namespace dermis {

void Document::refreshImages(SlotLook& look) const {
  if (m_reread.empty()) return;
  for (std::size_t i = 0; i < kTextureSlotCount; ++i)
    if (const auto newer = m_reread.find(look.worn.material.textures.at(i).path); newer != m_reread.end())
      look.worn.images.at(i) = newer->second;
}

void Document::replaceImage(const std::string& path, const std::shared_ptr<const Image>& image) {
  m_reread[path] = image;
  for (SlotLook& look : m_now.slotLooks) refreshImages(look);
  tell(Change::Material);
}

bool Document::refreshPresets() {
  bool changed = false;
  for (std::size_t i = 0; i < m_now.slotLooks.size(); ++i) {
    SlotLook& look = m_now.slotLooks[i];
    changed = m_presets.refresh(look) || changed;
    if (look.binding) m_now.scene.materials[m_now.model->slots[i].name] = *look.binding;
  }
  for (auto& [slot, look] : m_now.shelved) m_presets.refresh(look);
  return changed;
}

void Document::applyLooks(const Looks& looks) {
  for (const auto& [slot, look] : looks) {
    const int index = slotIndex(slot);
    if (index < 0) continue;
    SlotLook& worn = m_now.slotLooks[static_cast<std::size_t>(index)];
    worn = look;
    refreshImages(worn);
    m_presets.refresh(worn);
    if (worn.binding)
      m_now.scene.materials[slot.toStdString()] = *worn.binding;
    else
      m_now.scene.materials.erase(slot.toStdString());
  }
  tell(Change::Material);
}

SlotLook* Document::lookToChange(Looks& looks, const QString& slot) const {
  for (auto& [name, look] : looks)
    if (name == slot) return &look;
  const SlotLook* look = slotLook(slot);
  return look == nullptr ? nullptr : &looks.emplace_back(slot, *look).second;
}

void Document::commitLooks(Looks after, const QString& text, const QString& key, Gesture gesture) {
  Looks before;
  QString where;
  for (auto& [slot, look] : after) {
    const SlotLook& worn = before.emplace_back(slot, *slotLook(slot)).second;
    where += slot + QLatin1Char('/');
    // The binding says what a file would hold: the same material, and whether it still is its preset.
    if (look.worn.material == worn.worn.material && !look.binding) continue;
    if (!look.binding) {
      const MaterialBinding* shared = m_now.scene.bindingFor(slot.toStdString());
      look.binding = shared != nullptr ? *shared : MaterialBinding{};
    }
    look.binding->material = look.worn.material;
    if (look.preset) look.binding->edited = !(*look.preset == look.worn.material);
  }
  commit(text, QStringLiteral("material/") + where + key, gesture, std::move(before), std::move(after),
         [this](const Looks& looks) { applyLooks(looks); });
}

void Document::commitLook(const QString& slot, SlotLook after, const QString& text, const QString& key,
                          Gesture gesture) {
  Looks looks;
  looks.emplace_back(slot, std::move(after));
  commitLooks(std::move(looks), text, key, gesture);
}

void Document::setParameter(const QString& slot, std::string_view id, const ParameterValue& value, Gesture gesture) {
  if (const ParameterRow* row = findParameter(id))
    setParameters({{slot, row, value}}, tr("%1 › %2 of %3").arg(tableText(row->group), tableText(row->label), slot),
                  dermis::text(id), gesture);
}

void Document::setParameters(const std::vector<ParameterEdit>& edits, const QString& text, const QString& key,
                             Gesture gesture) {
  Looks looks;
  for (const ParameterEdit& edit : edits)
    if (SlotLook* look = lookToChange(looks, edit.slot))
      dermis::setParameter(look->worn.material.parameters, *edit.row, clampToHardRange(*edit.row, edit.value));
  commitLooks(std::move(looks), text, key, gesture);
}

void Document::setShadingModel(const QStringList& slots_, ShadingModel model) {
  Looks looks;
  for (const QString& slot : slots_)
    if (SlotLook* look = lookToChange(looks, slot)) look->worn.material.model = model;
  commitLooks(
      std::move(looks),
      tr("Shading model %1 for %2").arg(tableText(shadingModelRow(model).label), slots_.join(QStringLiteral(", "))),
      QStringLiteral("model"), 0);
}

namespace {

/// Binds a map in a look.
void bindTexture(ResolvedMaterial& worn, const TextureEdit& edit) {
  Material& material = worn.material;
  const bool wasPresent = material.texture(edit.texture).present();
  material.texture(edit.texture) = edit.binding;
  worn.images.at(static_cast<std::size_t>(edit.texture)) = edit.binding.present() ? edit.image : nullptr;
  if (!edit.binding.present() || wasPresent) return;
  // So that a dropped albedo map isn't tinted by the default albedo.
  for (const ParameterRow& row : parameterTable()) {
    if (row.map != edit.texture || !row.usedBy(material.model)) continue;
    if (!(row.get(material.parameters) == row.defaultValue())) continue;
    if (row.type == ParameterType::Float) row.set(material.parameters, clampToHardRange(row, ParameterValue(1.0F)));
    if (row.type == ParameterType::Colour) row.set(material.parameters, ParameterValue(Colour{glm::vec3(1.0F)}));
  }
}

}  // namespace

void Document::setTexture(const QString& slot, TextureSlot texture, const TextureBinding& binding,
                          std::shared_ptr<const Image> image, Gesture gesture) {
  const SlotLook* look = slotLook(slot);
  if (look == nullptr) return;
  const QString text = !binding.present()                               ? tr("Clear %1 map of %2")
                       : look->worn.material.texture(texture).present() ? tr("Change %1 map of %2")
                                                                        : tr("Assign %1 map to %2");
  setTextures({{slot, texture, binding, std::move(image)}},
              text.arg(tableText(textureSlotRow(texture).label).toLower(), slot), gesture);
}

void Document::setTextures(const std::vector<TextureEdit>& edits, const QString& text, Gesture gesture) {
  Looks looks;
  QString key = QStringLiteral("texture");
  for (const TextureEdit& edit : edits) {
    SlotLook* look = lookToChange(looks, edit.slot);
    if (look == nullptr) continue;
    // What was decoded for this edit is the newest there is of its file.
    if (const auto known = m_reread.find(edit.binding.path); known != m_reread.end() && edit.image)
      known->second = edit.image;
    bindTexture(look->worn, edit);
    key += QLatin1Char('/') + dermis::text(textureSlotRow(edit.texture).id);
  }
  commitLooks(std::move(looks), text, key, gesture);
}

void Document::applyMaterial(const QStringList& slots_, const ResolvedMaterial& material,
                             const std::string& presetPath) {
  Looks looks;
  QStringList names;
  for (const QString& slot : slots_) {
    SlotLook* look = lookToChange(looks, slot);
    if (look == nullptr) continue;
    *look = SlotLook{material, MaterialBinding{material.material, presetPath, false},
                     std::make_shared<const Material>(material.material)};
    names << slot;
  }
  m_presets.holds(presetPath, material.material);
  refreshPresets();
  const QString name = QString::fromStdString(material.material.name);
  commitLooks(std::move(looks),
              tr("Apply %1 to %2").arg(name.isEmpty() ? tr("material") : name, names.join(QStringLiteral(", "))),
              QStringLiteral("apply"), 0);
}

void Document::dressAs(const QString& from, const QStringList& slots_) {
  const SlotLook* source = slotLook(from);
  if (source == nullptr) return;
  SlotLook worn = *source;
  if (!worn.binding) {
    const MaterialBinding* shared = m_now.scene.bindingFor(from.toStdString());
    worn.binding = shared != nullptr ? *shared : MaterialBinding{worn.worn.material, {}, false};
  }
  Looks looks;
  QStringList names;
  for (const QString& slot : slots_) {
    SlotLook* look = slot == from ? nullptr : lookToChange(looks, slot);
    if (look == nullptr) continue;
    *look = worn;
    names << slot;
  }
  commitLooks(std::move(looks), tr("Dress %1 as %2").arg(names.join(QStringLiteral(", ")), from),
              QStringLiteral("dress"), 0);
}

void Document::pasteMaterial(const QStringList& slots_, const ResolvedMaterial& material) {
  Looks looks;
  for (const QString& slot : slots_) {
    SlotLook* look = lookToChange(looks, slot);
    if (look == nullptr) continue;
    *look = SlotLook{material, MaterialBinding{material.material, {}, false}, nullptr};
  }
  commitLooks(std::move(looks), tr("Paste material on %1").arg(slots_.join(QStringLiteral(", "))),
              QStringLiteral("paste"), 0);
}

void Document::revertToPreset(const std::vector<std::pair<QString, ResolvedMaterial>>& presets) {
  Looks looks;
  QStringList names;
  for (const auto& [slot, material] : presets) {
    SlotLook* look = lookToChange(looks, slot);
    if (look == nullptr || !look->binding) continue;
    look->worn = material;
    look->preset = std::make_shared<const Material>(material.material);
    m_presets.holds(look->binding->presetPath, material.material);
    names << slot;
  }
  refreshPresets();
  commitLooks(std::move(looks), tr("Revert %1").arg(names.join(QStringLiteral(", "))), QStringLiteral("revert"), 0);
}

void Document::markPresetSaved(const QString& slot, const std::filesystem::path& presetPath, const std::string& name) {
  const int index = slotIndex(slot);
  if (index < 0) return;
  SlotLook& look = m_now.slotLooks[static_cast<std::size_t>(index)];
  look.worn.material.name = name;
  look.binding = MaterialBinding{look.worn.material, presetPath.string(), false};
  const bool other = m_presets.holds(presetPath.string(), look.worn.material);
  refreshPresets();
  // A scene's file names its presets: what it shows has changed with one of them.
  if (other) markUnsaved();
  tell(Change::Material);
}

void Document::presetRewritten(const std::string& from, const std::string& to, const Material& before,
                               const Material& after) {
  m_presets.rewritten(from, to, before, after);
  if (!refreshPresets()) return;
  if (from != to) markUnsaved();  // a scene's file names its presets
  tell(Change::Material);
}

}  // namespace dermis
