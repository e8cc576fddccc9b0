#include "ui/document/document.h"

#include <algorithm>

#include "core/base/file_reference.h"
#include "ui/document/carry_over.h"
#include "ui/document/document_commit.h"

namespace dermis {

Document::Document(QObject* parent) : QObject(parent) {
  connect(&m_undo, &QUndoStack::cleanChanged, this, &Document::titleChanged);
  connect(&m_undo, &QUndoStack::indexChanged, this, [this] { ++m_edits; });
}

Document::~Document() { m_undo.disconnect(this); }

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
  for (auto& [slot, binding] : scene.materials) {
    m_presets.refresh(binding);
    // A preset that has been thrown away is kept in the scene itself: its path would open nothing. One that was not
    // there from the start may come back.
    std::error_code unreadable;
    if (!binding.presetPath.empty() && !namesNoFile(binding.presetPath) && !binding.missing &&
        !std::filesystem::exists(binding.presetPath, unreadable))
      binding.edited = true;
  }
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

void Document::addLight(const Light& light, const QString& text) {
  if (m_now.scene.lights.size() >= kMaxLights) return;
  std::vector<Light> after = m_now.scene.lights;
  after.push_back(light);
  commitLights(std::move(after), text.isEmpty() ? tr("Add light") : text, QStringLiteral("add"), 0);
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
  refreshPresets();
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
    // Navigation is not part of a look; it comes along to another model.
    next.camera = whole.model == m_now.model ? m_now.camera : CarriedOver(*m_now.model, *whole.model)(m_now.camera);
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
  m_presets.clear();
  for (const auto& [slot, binding] : whole.scene.materials)
    if (!binding.edited && !binding.missing) m_presets.holds(binding.presetPath, binding.material);
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
