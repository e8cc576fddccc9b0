// The document: the scene, what its paths resolved to, and the undo stack. The only place that changes a scene.
#pragma once

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <filesystem>
#include <memory>

#include "core/material/parameter_table.h"
#include "ui/document/preset_memory.h"
#include "ui/document/sections.h"
#include "ui/rows/gesture.h"

namespace dermis {

/// What has changed; panels refresh what concerns them.
enum class Change { Everything, Material, Environment, Lights, View, Lens, Camera, Unit, Bookmarks };

struct ParameterEdit {
  QString slot;
  const ParameterRow* row = nullptr;
  ParameterValue value;
};

struct TextureEdit {
  QString slot;
  TextureSlot texture = TextureSlot::Albedo;
  TextureBinding binding;  ///< empty path: cleared
  std::shared_ptr<const Image> image;
};

class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);
  /// Nobody is told of what the undo stack says while it goes: unsaved work stays unsaved.
  ~Document() override;

  // --- reading ---------------------------------------------------------------------------------------------------
  /// False until the first look has been resolved.
  [[nodiscard]] bool isReady() const { return m_now.model != nullptr; }
  [[nodiscard]] const Scene& scene() const { return m_now.scene; }
  [[nodiscard]] const std::shared_ptr<const Model>& model() const { return m_now.model; }
  [[nodiscard]] float millimetresPerUnit() const { return m_now.millimetresPerUnit; }
  [[nodiscard]] const Camera& camera() const { return m_now.camera; }
  [[nodiscard]] const std::shared_ptr<const EnvironmentImages>& environmentImages() const { return m_now.environment; }
  [[nodiscard]] QStringList slotNames() const;
  /// Null where the model has no slot of that name.
  [[nodiscard]] const SlotLook* slotLook(const QString& slot) const;
  /// Of the current slot; null before the document is ready.
  [[nodiscard]] const SlotLook* currentLook() const { return slotLook(m_currentSlot); }
  [[nodiscard]] const QString& currentSlot() const { return m_currentSlot; }
  /// What an edit of the Material and Texture docks goes to: the current slot, and those chosen beside it.
  [[nodiscard]] const QStringList& editedSlots() const { return m_editedSlots; }
  /// What the renderer draws now; the same pointer until something changes. Null before the document is ready.
  [[nodiscard]] std::shared_ptr<const ResolvedScene> snapshot() const;
  /// What a file of this document holds: materials of slots that the model lacks are left out.
  [[nodiscard]] Scene sceneForSaving() const;

  [[nodiscard]] QUndoStack& undoStack() { return m_undo; }
  [[nodiscard]] bool isModified() const { return !m_undo.isClean(); }
  /// Another number after every edit, undo and redo: whether anything was done meanwhile.
  [[nodiscard]] quint64 edits() const { return m_edits; }
  /// The scene's file; empty while it has none.
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  /// For the title bar: the file's name, or the scene's own.
  [[nodiscard]] QString displayName() const;

  // --- changing: one undo entry a gesture ------------------------------------------------------------------------
  /// Clamps to the hard range. Unknown slots and ids are ignored. `gesture` 0 makes an entry of its own.
  void setParameter(const QString& slot, std::string_view id, const ParameterValue& value, Gesture gesture);
  /// Several values, on several slots, as one entry named `text`; `key` keeps different edits of a gesture apart.
  void setParameters(const std::vector<ParameterEdit>& edits, const QString& text, const QString& key, Gesture gesture);
  void setShadingModel(const QStringList& slots_, ShadingModel model);
  /// Binds a map (or clears it: an empty path). A `× map` value still at its default becomes 1 in the same step.
  void setTexture(const QString& slot, TextureSlot texture, const TextureBinding& binding,
                  std::shared_ptr<const Image> image, Gesture gesture = 0);
  /// The same for several maps, as one entry named `text`.
  void setTextures(const std::vector<TextureEdit>& edits, const QString& text, Gesture gesture = 0);
  /// Puts a material on slots, with its decoded maps. `presetPath` empty: an inline one.
  void applyMaterial(const QStringList& slots_, const ResolvedMaterial& material, const std::string& presetPath);
  /// Slots wear what `from` wears, preset and maps, as one entry.
  void dressAs(const QString& from, const QStringList& slots_);
  /// A material without a preset, on several slots.
  void pasteMaterial(const QStringList& slots_, const ResolvedMaterial& material);
  /// Each slot back to its preset, which comes with its decoded maps; slots without a preset are left alone.
  void revertToPreset(const std::vector<std::pair<QString, ResolvedMaterial>>& presets);

  void setEnvironment(const EnvironmentSource& source, std::shared_ptr<const EnvironmentImages> images);
  /// Rotation, exposure and background of the environment there is.
  void setEnvironmentSettings(const EnvironmentSource& settings, const QString& text, Gesture gesture);
  /// The same for a gesture on the scene's own rig, whose images may follow later (setRigImages).
  void setEnvironmentLook(EnvironmentLook look, const QString& text, Gesture gesture);
  /// `text` names the undo entry; empty: as a new light.
  void addLight(const Light& light, const QString& text = {});
  void removeLight(std::size_t index);
  /// `what` names the edited property in the undo entry and keeps different ones apart.
  void setLight(std::size_t index, const Light& light, const QString& what, Gesture gesture);
  void setView(const ViewSettings& view, Gesture gesture);
  void setLens(const Lens& lens, Gesture gesture);
  /// How large the model is. Lamps keep their size beside it, as if it had been opened so.
  void setMillimetresPerUnit(float millimetres, Gesture gesture);
  /// Named cameras; `text` names the undo entry.
  void setBookmarks(const std::vector<CameraBookmark>& bookmarks, const QString& text);
  /// Another look on the same document: a stored snapshot put back, model and all, as one undo entry.
  void restoreLook(const WholeLook& look, const QString& text);
  /// The whole of it as it is now, to be kept and restored.
  [[nodiscard]] const WholeLook& wholeLook() const { return m_now; }
  /// Another model: slots of the same name keep their look, the others wear `imported`; lights and camera are carried
  /// over by the ratio of the bounds.
  void openModel(const ModelSource& source, std::shared_ptr<const Model> model, std::vector<ResolvedMaterial> imported);

  // --- changing without an undo entry ----------------------------------------------------------------------------
  /// Navigation.
  void setCamera(const Camera& camera);
  /// The only edited slot, too.
  void setCurrentSlot(const QString& slot);
  /// Those that the model has; the current slot stays among them.
  void setEditedSlots(const QStringList& slots_);
  /// The file at `path` holds another picture now: every slot that wears it shows it, those of undo entries as well.
  void replaceImage(const std::string& path, const std::shared_ptr<const Image>& image);
  /// What the scene's rig has become as light.
  void setRigImages(std::shared_ptr<const EnvironmentImages> images);
  /// A new or opened scene: forgets the undo history. `path` empty: untitled.
  void replace(const ResolvedScene& scene, const std::filesystem::path& path);
  /// What is open differs from its file though there is nothing to undo.
  void markUnsaved() { m_undo.resetClean(); }
  void markSaved(const std::filesystem::path& path);
  /// The slot's material is now what `presetPath` holds, and `name` is what it is called there. Other slots that wear
  /// this preset, undo entries as well, differ from it by as much.
  void markPresetSaved(const QString& slot, const std::filesystem::path& presetPath, const std::string& name);
  /// A preset's file was renamed or given tags; `from` and `to` may be the same.
  void presetRewritten(const std::string& from, const std::string& to, const Material& before, const Material& after);

 Q_SIGNALS:
  void changed(dermis::Change what);
  void currentSlotChanged();
  /// Title, path or modified state.
  void titleChanged();

 private:
  template <class Section, class Apply>
  void commit(const QString& text, const QString& key, Gesture gesture, Section before, Section after, Apply apply);
  using Looks = std::vector<std::pair<QString, SlotLook>>;
  void commitLook(const QString& slot, SlotLook after, const QString& text, const QString& key, Gesture gesture);
  void commitLooks(Looks after, const QString& text, const QString& key, Gesture gesture);
  /// The look of a slot among those already changed, else a copy of what it wears; null for an unknown slot.
  [[nodiscard]] SlotLook* lookToChange(Looks& looks, const QString& slot) const;
  void refreshImages(SlotLook& look) const;
  /// What all slots say of their presets, beside what the files hold. True where anything changed.
  bool refreshPresets();
  void commitLights(std::vector<Light> after, const QString& text, const QString& key, Gesture gesture);
  [[nodiscard]] int slotIndex(const QString& slot) const;
  void applyLooks(const Looks& looks);
  void applyEnvironment(const EnvironmentLook& look);
  void applyWhole(const WholeLook& whole);
  void tell(Change what);

  WholeLook m_now;
  PresetMemory m_presets;
  QUndoStack m_undo;
  quint64 m_edits = 0;
  std::filesystem::path m_path;
  QString m_currentSlot;
  QStringList m_editedSlots;
  std::map<std::string, std::shared_ptr<const Image>> m_reread;  ///< the newest picture of files that have changed
  mutable std::shared_ptr<const ResolvedScene> m_snapshot;
};

}  // namespace dermis
