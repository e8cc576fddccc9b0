#include "ui/document/document.h"

#include <algorithm>

#include "core/base/file_reference.h"
#include "ui/document/carry_over.h"
#include "ui/document/section_command.h"
#include "ui/text.h"

namespace dermis {

Document::Document(QObject* parent) : QObject(parent) {
  connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
}

QStringList Document::slotNames() const {
  QStringList names;
  if (m_now.model)
    for (const ModelSlot& slot : m_now.model->slots) names << QString::fromStdString(slot.name);
  return names;
}

int Document::slotIndex(const QString& slot) const {
  if (!m_now.model) return -1;
  const std::string name = slot.toStdString();
  const auto& all = m_now.model->slots;
  const auto found = std::find_if(all.begin(), all.end(), [&](const ModelSlot& s) { return s.name == name; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

const SlotLook* Document::slotLook(const QString& slot) const {
  const int index = slotIndex(slot);
  return index < 0 ? nullptr : &m_now.slotLooks[static_cast<std::size_t>(index)];
}

std::shared_ptr<const ResolvedScene> Document::snapshot() const {
  if (!m_now.model) return nullptr;
  if (!m_snapshot) {
    auto scene = std::make_shared<ResolvedScene>();
    scene->scene = m_now.scene;
    scene->model = m_now.model;
    scene->millimetresPerUnit = m_now.millimetresPerUnit;
    for (const SlotLook& look : m_now.slotLooks) scene->slots.push_back(look.worn);
    scene->environment = m_now.environment;
    scene->camera = m_now.camera;
    m_snapshot = std::move(scene);
  }
  return m_snapshot;
}

Scene Document::sceneForSaving() const {
  Scene scene = m_now.scene;
  std::erase_if(scene.materials, [this](const auto& entry) {
    return entry.first != "*" && slotIndex(QString::fromStdString(entry.first)) < 0;
  });
  // A preset that has been renamed or thrown away is kept in the scene itself: its path would open nothing.
  for (auto& [slot, binding] : scene.materials)
    if (!binding.presetPath.empty() && !namesNoFile(binding.presetPath) && !std::filesystem::exists(binding.presetPath))
      binding.edited = true;
  scene.camera = m_now.camera;
  return scene;
}

QString Document::displayName() const {
  if (!m_path.empty()) return QString::fromStdString(m_path.filename().string());
  return tr("Untitled");
}

void Document::tell(Change what) {
  m_snapshot.reset();
  Q_EMIT changed(what);
}

template <class Section, class Apply>
void Document::commit(const QString& text, const QString& key, Gesture gesture, Section before, Section after,
                      Apply apply) {
  if (before == after) return;
  m_undo.push(new SectionCommand<Section>(text, key, gesture, std::move(before), std::move(after), std::move(apply)));
}

// --- materials -----------------------------------------------------------------------------------------------------

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

void Document::applyLooks(const Looks& looks) {
  for (const auto& [slot, look] : looks) {
    const int index = slotIndex(slot);
    if (index < 0) continue;
    SlotLook& worn = m_now.slotLooks[static_cast<std::size_t>(index)];
    worn = look;
    refreshImages(worn);
    if (look.binding)
      m_now.scene.materials[slot.toStdString()] = *look.binding;
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
    setParameters({{slot, row, value}},
                  tr("%1 › %2 of %3").arg(dermis::text(row->group), dermis::text(row->label), slot), dermis::text(id),
                  gesture);
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
      tr("Shading model %1 for %2").arg(dermis::text(shadingModelRow(model).label), slots_.join(QStringLiteral(", "))),
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
              text.arg(dermis::text(textureSlotRow(texture).label).toLower(), slot), gesture);
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

void Document::applyMaterial(const QString& slot, const ResolvedMaterial& material, const std::string& presetPath) {
  const SlotLook* look = slotLook(slot);
  if (look == nullptr) return;
  SlotLook after;
  after.worn = material;
  after.binding = MaterialBinding{material.material, presetPath, false};
  after.preset = std::make_shared<const Material>(material.material);
  const QString name = QString::fromStdString(material.material.name);
  commitLook(slot, std::move(after), tr("Apply %1 to %2").arg(name.isEmpty() ? tr("material") : name, slot),
             QStringLiteral("apply"), 0);
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

void Document::revertToPreset(const QString& slot, const ResolvedMaterial& material) {
  const SlotLook* look = slotLook(slot);
  if (look == nullptr || !look->preset) return;
  SlotLook after = *look;
  after.worn = material;
  commitLook(slot, std::move(after), tr("Revert %1").arg(slot), QStringLiteral("revert"), 0);
}

void Document::markPresetSaved(const QString& slot, const std::filesystem::path& presetPath) {
  const int index = slotIndex(slot);
  if (index < 0) return;
  SlotLook look = m_now.slotLooks[static_cast<std::size_t>(index)];
  look.binding = MaterialBinding{look.worn.material, presetPath.string(), false};
  look.preset = std::make_shared<const Material>(look.worn.material);
  applyLooks({{slot, look}});
}

// --- environment, lights, view --------------------------------------------------------------------------------------

void Document::setEnvironment(const EnvironmentSource& source, std::shared_ptr<const EnvironmentImages> images) {
  const QString name = images ? QString::fromStdString(images->name) : QString();
  commit(tr("Environment %1").arg(name), QStringLiteral("environment"), 0,
         EnvironmentLook{m_now.scene.environment, m_now.environment}, EnvironmentLook{source, std::move(images)},
         [this](const EnvironmentLook& look) { applyEnvironment(look); });
}

void Document::setEnvironmentLook(EnvironmentLook look, const QString& text, Gesture gesture) {
  commit(text, QStringLiteral("rig/") + text, gesture, EnvironmentLook{m_now.scene.environment, m_now.environment},
         std::move(look), [this](const EnvironmentLook& next) { applyEnvironment(next); });
}

void Document::setRigImages(std::shared_ptr<const EnvironmentImages> images) {
  m_now.environment = std::move(images);
  tell(Change::Environment);
}

void Document::applyEnvironment(const EnvironmentLook& look) {
  m_now.scene.environment = look.source;
  m_now.environment = look.images;
  tell(Change::Environment);
}

void Document::setEnvironmentSettings(const EnvironmentSource& settings, const QString& text, Gesture gesture) {
  commit(text, QStringLiteral("environment/") + text, gesture, m_now.scene.environment, settings,
         [this](const EnvironmentSource& source) {
           m_now.scene.environment = source;
           tell(Change::Environment);
         });
}

void Document::commitLights(std::vector<Light> after, const QString& text, const QString& key, Gesture gesture) {
  commit(text, QStringLiteral("lights/") + key, gesture, m_now.scene.lights, std::move(after),
         [this](const std::vector<Light>& lights) {
           m_now.scene.lights = lights;
           tell(Change::Lights);
         });
}

void Document::addLight(const Light& light) {
  if (m_now.scene.lights.size() >= kMaxLights) return;
  std::vector<Light> after = m_now.scene.lights;
  after.push_back(light);
  commitLights(std::move(after), tr("Add light"), QStringLiteral("add"), 0);
}

void Document::removeLight(std::size_t index) {
  if (index >= m_now.scene.lights.size()) return;
  std::vector<Light> after = m_now.scene.lights;
  after.erase(after.begin() + static_cast<std::ptrdiff_t>(index));
  commitLights(std::move(after), tr("Remove light"), QStringLiteral("remove"), 0);
}

void Document::setLight(std::size_t index, const Light& light, const QString& what, Gesture gesture) {
  if (index >= m_now.scene.lights.size()) return;
  std::vector<Light> after = m_now.scene.lights;
  after[index] = light;
  commitLights(std::move(after), tr("Light %1 › %2").arg(index + 1).arg(what),
               QStringLiteral("%1/%2").arg(index).arg(what), gesture);
}

void Document::setView(const ViewSettings& view, Gesture gesture) {
  const bool exposure = view.exposureStops != m_now.scene.view.exposureStops;
  commit(exposure ? tr("View exposure") : tr("View transform"),
         exposure ? QStringLiteral("view/exposure") : QStringLiteral("view/transform"), gesture, m_now.scene.view, view,
         [this](const ViewSettings& settings) {
           m_now.scene.view = settings;
           tell(Change::View);
         });
}

void Document::setLens(const Lens& lens, Gesture gesture) {
  commit(tr("Lens"), QStringLiteral("lens"), gesture,
         Lens{m_now.camera.verticalFovDegrees, m_now.camera.orthographicHeight}, lens, [this](const Lens& next) {
           m_now.camera.verticalFovDegrees = next.verticalFovDegrees;
           m_now.camera.orthographicHeight = next.orthographicHeight;
           tell(Change::Lens);
         });
}

void Document::setBookmarks(const std::vector<CameraBookmark>& bookmarks, const QString& text) {
  commit(text, QStringLiteral("bookmarks"), 0, m_now.scene.bookmarks, bookmarks,
         [this](const std::vector<CameraBookmark>& next) {
           m_now.scene.bookmarks = next;
           tell(Change::Bookmarks);
         });
}

void Document::setCamera(const Camera& camera) {
  if (camera == m_now.camera) return;
  m_now.camera = camera;
  tell(Change::Camera);
}

// --- the whole ------------------------------------------------------------------------------------------------------

void Document::applyWhole(const WholeLook& whole) {
  m_now = whole;
  for (SlotLook& look : m_now.slotLooks) refreshImages(look);
  const QStringList names = slotNames();
  const bool lost = !names.contains(m_currentSlot);
  if (lost) m_currentSlot = names.value(0);
  m_editedSlots = {m_currentSlot};
  tell(Change::Everything);
  if (lost) Q_EMIT currentSlotChanged();
}

void Document::setMillimetresPerUnit(float millimetres, Gesture gesture) {
  if (!m_now.model || !(millimetres > 0.0F)) return;
  const ModelScale before{m_now.scene.model.millimetresPerUnit, m_now.millimetresPerUnit, m_now.scene.lights};
  ModelScale after{millimetres, millimetres, before.lights};
  for (Light& light : after.lights) {
    light.radiusMm *= millimetres / before.used;
    light.sizeMm *= millimetres / before.used;
  }
  if (before.used == millimetres) after = before;
  commit(tr("Unit of the model"), QStringLiteral("unit"), gesture, before, after, [this](const ModelScale& scale) {
    m_now.scene.model.millimetresPerUnit = scale.said;
    m_now.millimetresPerUnit = scale.used;
    m_now.scene.lights = scale.lights;
    tell(Change::Unit);
  });
}

void Document::openModel(const ModelSource& source, std::shared_ptr<const Model> model,
                         std::vector<ResolvedMaterial> imported) {
  WholeLook after = carryOver(m_now, source, std::move(model), std::move(imported));
  const QString name = QString::fromStdString(
      source.path.empty() ? source.builtin : std::filesystem::path(source.path).filename().string());
  commit(tr("Open model %1").arg(name), QStringLiteral("model"), 0, m_now, std::move(after),
         [this](const WholeLook& whole) { applyWhole(whole); });
}

void Document::restoreLook(const WholeLook& look, const QString& text) {
  if (look.scene == m_now.scene && look.model == m_now.model && look.environment == m_now.environment) return;
  commit(text, QStringLiteral("look"), 0, m_now, look, [this](const WholeLook& whole) {
    WholeLook next = whole;
    next.camera = m_now.camera;  // navigation is not part of a look
    applyWhole(next);
  });
}

void Document::replace(const ResolvedScene& scene, const std::filesystem::path& path) {
  WholeLook whole;
  whole.scene = scene.scene;
  whole.model = scene.model;
  whole.millimetresPerUnit = scene.millimetresPerUnit;
  whole.environment = scene.environment;
  whole.camera = scene.camera;
  for (std::size_t i = 0; i < scene.slots.size(); ++i) {
    SlotLook look;
    look.worn = scene.slots[i];
    if (const auto own = whole.scene.materials.find(scene.model->slots[i].name); own != whole.scene.materials.end()) {
      // From here on paths are absolute; saving makes them relative to the file again.
      own->second.material = look.worn.material;
      look.binding = own->second;
      if (!own->second.edited) look.preset = std::make_shared<const Material>(look.worn.material);
    }
    whole.slotLooks.push_back(std::move(look));
  }
  m_undo.clear();
  m_reread.clear();
  m_path = path;
  m_currentSlot.clear();
  applyWhole(whole);
  Q_EMIT titleChanged();
}

void Document::markSaved(const std::filesystem::path& path) {
  m_path = path;
  m_undo.setClean();
  Q_EMIT titleChanged();
}

void Document::setCurrentSlot(const QString& slot) {
  if (slotIndex(slot) < 0 || (slot == m_currentSlot && m_editedSlots.size() == 1)) return;
  m_currentSlot = slot;
  m_editedSlots = {slot};
  Q_EMIT currentSlotChanged();
}

void Document::setEditedSlots(const QStringList& slots_) {
  QStringList next;
  for (const QString& name : slotNames())
    if (slots_.contains(name) || name == m_currentSlot) next << name;
  if (next == m_editedSlots) return;
  m_editedSlots = next;
  Q_EMIT currentSlotChanged();
}

}  // namespace dermis
