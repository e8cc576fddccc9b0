#include "ui/main_window/file_actions.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <map>
#include <utility>

#include "core/base/file_reference.h"
#include "core/light_rig/light_rig.h"
#include "ui/browse/preset_library.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/document/document.h"
#include "ui/document/loading.h"
#include "ui/text.h"

namespace dermis {
namespace {
const QString kRecentKey = QStringLiteral("recentFiles");
constexpr int kRecent = 8;
}  // namespace

FileActions::FileActions(Document& document, Loading& loading, QWidget* window)
    : QObject(window), m_document(document), m_loading(loading), m_window(window) {}

QString FileActions::startFolder(const char* key) const {
  return QSettings().value(QStringLiteral("folders/") + QLatin1String(key)).toString();
}

void FileActions::rememberFolder(const char* key, const QString& path) {
  QSettings().setValue(QStringLiteral("folders/") + QLatin1String(key), QFileInfo(path).path());
}

bool FileActions::mayDiscard() {
  if (!m_document.isModified()) return true;
  QMessageBox question(QMessageBox::Question, tr("Unsaved changes"),
                       tr("“%1” has unsaved changes.").arg(m_document.displayName()),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
  question.setObjectName(QStringLiteral("unsavedChanges"));
  question.setInformativeText(tr("Save them before going on?"));
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void FileActions::newScene() {
  if (mayDiscard()) m_loading.newScene();
}

void FileActions::open(const QString& given) {
  QString path = given;
  if (path.isEmpty()) {
    const QString all = QStringList{namePatterns(FileKind::Scene), namePatterns(FileKind::Model),
                                    namePatterns(FileKind::Preset), QStringLiteral("*.hdr *.exr")}
                            .join(QLatin1Char(' '));
    path = QFileDialog::getOpenFileName(
        m_window, tr("Open"), startFolder("open"),
        tr("All that can be opened (%1);;Scenes (%2);;Models (%3);;Presets (%4);;Environments (*.hdr *.exr);;All files "
           "(*)")
            .arg(all, namePatterns(FileKind::Scene), namePatterns(FileKind::Model), namePatterns(FileKind::Preset)));
    if (path.isEmpty()) return;
    rememberFolder("open", path);
  }
  if (QFileInfo(path).isDir()) {
    m_loading.assignFolder(m_document.editedSlots(), path);
    return;
  }
  switch (fileKind(toPath(path))) {
    case FileKind::Scene:
      if (mayDiscard()) m_loading.openScene(toPath(path));
      break;
    case FileKind::Model: {
      ModelSource source;
      source.path = path.toStdString();
      source.builtin.clear();
      m_loading.openModel(source);
      break;
    }
    case FileKind::Preset:
      m_loading.applyPreset(path.toStdString(), m_document.editedSlots());
      break;
    case FileKind::Environment:
    case FileKind::Image:
      setEnvironmentFile(path);
      break;
    case FileKind::Unknown:
      Q_EMIT m_loading.message(MessageKind::Error,
                               tr("%1 can't be opened: by its name it is no scene (.dermis), "
                                  "model, preset (.json) or environment (.hdr, .exr, a light rig's .json).")
                                   .arg(path));
  }
}

void FileActions::openModel() {
  const QString path =
      QFileDialog::getOpenFileName(m_window, tr("Open model"), startFolder("models"),
                                   tr("Models (%1);;All files (*)").arg(namePatterns(FileKind::Model)));
  if (path.isEmpty()) return;
  rememberFolder("models", path);
  ModelSource source;
  source.path = path.toStdString();
  source.builtin.clear();
  m_loading.openModel(source);
}

void FileActions::chooseEnvironment() {
  const QString path = QFileDialog::getOpenFileName(
      m_window, tr("Choose an environment"), startFolder("environments"),
      tr("Images and light rigs (%1);;All files (*)").arg(namePatterns(FileKind::Environment)));
  if (path.isEmpty()) return;
  rememberFolder("environments", path);
  setEnvironmentFile(path);
}

void FileActions::setEnvironmentFile(const QString& path) {
  EnvironmentSource source;
  source.builtin.clear();
  source.path = QFileInfo(path).absoluteFilePath().toStdString();
  m_loading.setEnvironment(source);
}

bool FileActions::save() { return m_document.path().empty() ? saveAs() : m_loading.saveScene(m_document.path()); }

bool FileActions::saveAs() {
  const QString start = m_document.path().empty() ? startFolder("scenes") + QStringLiteral("/untitled.dermis")
                                                  : pathText(m_document.path());
  const QString path =
      askWhereToSave(m_window, tr("Save scene"), start, tr("Scenes (*.dermis)"), {QStringLiteral("dermis")});
  if (path.isEmpty()) return false;
  rememberFolder("scenes", path);
  return m_loading.saveScene(toPath(path));
}

void FileActions::savePreset() {
  const SlotLook* look = m_document.currentLook();
  if (look == nullptr) return;
  const std::string path = look->binding ? look->binding->presetPath : std::string();
  // What the program carries can't be written over: that becomes a preset of the user's own. One that was thrown away
  // doesn't come back unasked.
  if (path.empty() || namesNoFile(path) || !QFileInfo::exists(text(path)))
    savePresetAs();
  else
    m_loading.savePreset(m_document.currentSlot(), path);
}

void FileActions::savePresetAs() {
  const SlotLook* look = m_document.currentLook();
  if (look == nullptr) return;
  const QString name = look->worn.material.name.empty() ? m_document.currentSlot() : text(look->worn.material.name);
  const QString start = userPresetFolder() + QLatin1Char('/') + fileNameOf(name) + QStringLiteral(".json");
  const QString path =
      askWhereToSave(m_window, tr("Save preset"), start, tr("Presets (*.json)"), {QStringLiteral("json")});
  if (path.isEmpty()) return;
  // Another file is another preset, and it is called as its file; the proposed one keeps what a file's name can't say.
  const QString chosen = QFileInfo(path).completeBaseName();
  m_loading.savePreset(m_document.currentSlot(), toPath(path),
                       chosen == fileNameOf(name) ? name.toStdString() : chosen.toStdString());
}

void FileActions::saveRig(const LightRig* rig) {
  if (rig == nullptr) return;
  const QString path = askWhereToSave(
      m_window, tr("Save light rig"),
      startFolder("environments") + QLatin1Char('/') + fileNameOf(text(rig->name)) + QStringLiteral(".json"),
      tr("Light rigs (*.json)"), {QStringLiteral("json")});
  if (path.isEmpty()) return;
  rememberFolder("environments", path);
  m_loading.saveRig(*rig, toPath(path));
}

void FileActions::remember(const QString& path) {
  QSettings settings;
  QStringList recent = settings.value(kRecentKey).toStringList();
  recent.removeAll(path);
  recent.prepend(path);
  // So many of each kind: a folder of presets tried one after another must not push out the scenes.
  std::map<FileKind, int> counts;
  recent.removeIf([&](const QString& file) { return ++counts[fileKind(toPath(file))] > kRecent; });
  settings.setValue(kRecentKey, recent);
}

void FileActions::fillRecentMenu(QMenu* menu) {
  menu->clear();
  const QStringList all = QSettings().value(kRecentKey).toStringList();
  const std::pair<FileKind, QString> kinds[] = {{FileKind::Scene, tr("Scenes")},
                                                {FileKind::Model, tr("Models")},
                                                {FileKind::Preset, tr("Presets")},
                                                {FileKind::Environment, tr("Environments")},
                                                {FileKind::Image, tr("Images")}};
  for (const auto& [kind, title] : kinds) {
    bool first = true;
    for (const QString& path : all) {
      if (fileKind(toPath(path)) != kind) continue;
      if (std::exchange(first, false)) menu->addSection(title);
      const bool exists = QFileInfo::exists(path);
      QAction* action = menu->addAction(QFileInfo(path).fileName());
      action->setToolTip(exists ? path : tr("%1 is not there any more").arg(path));
      action->setEnabled(exists);
      connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
  }
  if (menu->isEmpty()) menu->addAction(tr("None yet"))->setEnabled(false);
  menu->addSeparator();
  connect(menu->addAction(tr("Clear list")), &QAction::triggered, this, [] { QSettings().remove(kRecentKey); });
}

}  // namespace dermis
