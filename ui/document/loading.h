// Opening and saving: everything that touches files does so beside the event loop and comes back through the document.
#pragma once

#include <QObject>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <memory>

#include "core/io/asset_loader.h"
#include "ui/document/document.h"
#include "ui/jobs/task_runner.h"

namespace dermis {

struct LightRig;

enum class MessageKind { Info, Warning, Error };

/// What a file is, by its name.
enum class FileKind { Scene, Model, Preset, Environment, Image, Unknown };
[[nodiscard]] FileKind fileKind(const std::filesystem::path& path);
/// For file dialogs: "*.obj *.glb …".
[[nodiscard]] QString namePatterns(FileKind kind);

class Loading : public QObject {
  Q_OBJECT
 public:
  Loading(Document& document, TaskRunner& tasks, QObject* parent = nullptr);

  /// Asked before a scene takes the place of one that was edited while it loaded.
  void setMayDiscard(std::function<bool()> mayDiscard) { m_mayDiscard = std::move(mayDiscard); }

  /// The embedded default look, untitled.
  void newScene();
  void openScene(const std::filesystem::path& path);
  /// Work that never reached a file: the document is modified from the start. `done` follows once it is in place.
  void openUnsaved(const Scene& scene, const std::filesystem::path& path, std::function<void()> done);
  /// The scene that a picture remembers, untitled; what it names lies beside the picture, if it is still there.
  void openPictureScene(const std::filesystem::path& picture, const std::string& sceneText);
  void openModel(const ModelSource& source);
  /// `preset` is a path or "builtin:NAME"; one undo entry for all `slots_`.
  void applyPreset(const std::string& preset, const QStringList& slots_);
  /// Each slot to its own preset, as one undo entry; those without one are left alone.
  void revertToPreset(const QStringList& slots_);
  /// Another source; rotation, exposure and background are the document's.
  void setEnvironment(const EnvironmentSource& source);
  /// Keeps the channel, colour space and so on of what was bound there before.
  void assignTexture(const QStringList& slots_, TextureSlot texture, const std::filesystem::path& path);
  /// Maps by the names of files: one undo entry for all `slots_`. What was matched goes out as mapsMatched.
  void assignByName(const QStringList& slots_, const std::vector<std::filesystem::path>& files);
  /// The same with all images of a folder.
  void assignFolder(const QStringList& slots_, const QString& folder);
  /// Binds maps to files, as one undo entry. What can't be read is left out with a message.
  void bindMaps(std::vector<TextureEdit> edits, const QString& text);
  /// The picture of a file that has changed, wherever it is worn; no undo entry. Where it can't be read the last good
  /// picture stays. `tellWhy`: then a message says why.
  void rereadMap(const std::string& path, bool tellWhy);
  /// A missing map is at `file` now; other missing ones that lie beside it come along, in the same undo entry.
  void locateMap(const std::string& missing, const std::filesystem::path& file);
  /// A material from elsewhere, with its maps decoded, as one undo entry.
  void pasteMaterial(const QStringList& slots_, const Material& material);
  /// What the command line gives: one scene, one model, one environment, presets, in any order.
  void openAtStart(const std::vector<std::filesystem::path>& files);
  /// Stops all that is under way. Where nothing is open yet, the default look comes up: there is always a picture.
  void cancel();

  /// True when it was written. The sentence of what went wrong goes out as a message.
  bool saveScene(const std::filesystem::path& path);
  /// `name`: what the preset is called from now on; empty: as the slot's material.
  bool savePreset(const QString& slot, const std::filesystem::path& path, const std::string& name = {});
  bool saveRig(const LightRig& rig, const std::filesystem::path& path);

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);
  /// A file was opened or saved: it belongs in the list of recent ones.
  void fileUsed(const QString& path);
  void presetSaved(const QString& path);
  /// Another model is in place; `unitSource` says where its unit came from.
  void modelOpened(const QString& name, const QString& unitSource);
  /// Which files became which maps, in lines for people.
  void mapsMatched(const QString& report);
  /// rereadMap has ended.
  void mapReread(const QString& path, bool good);
  /// What is open now was made for no window in particular, or its camera for another model: frame it.
  void framingWanted();
  /// The scene, model or environment asked for is in place.
  void finished();

 private:
  /// What a worker brings back.
  template <class T>
  struct Outcome {
    Result<T> result;
    Warnings warnings;
  };
  /// Runs `work(options, warnings)` beside the event loop; `done(value)` follows where it succeeded, else a message.
  template <class Work, class Done>
  void run(const QString& lane, const QString& title, Work work, Done done, std::function<void()> failed = {});
  /// The same for a whole scene; `done` is not called where somebody keeps what was edited meanwhile.
  template <class Work, class Done>
  void runScene(const QString& title, Work work, Done done, std::function<void()> failed);
  void prepareFirst();
  void tellWarnings(const Warnings& warnings);

  Document& m_document;
  TaskRunner& m_tasks;
  std::function<bool()> m_mayDiscard;
  std::shared_ptr<AssetCache> m_cache = std::make_shared<AssetCache>();
};

}  // namespace dermis
