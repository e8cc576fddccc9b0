// What the File menu asks before it opens and saves.
#pragma once

#include <QObject>
#include <QStringList>

class QMenu;
class QWidget;

namespace dermis {

class Document;
class Loading;
struct LightRig;

class FileActions : public QObject {
  Q_OBJECT
 public:
  FileActions(Document& document, Loading& loading, QWidget* window);

  void newScene();
  /// By the file's kind; asks with a dialog where `path` is empty.
  void open(const QString& path = {});
  bool save();
  bool saveAs();
  void savePreset();
  void savePresetAs();
  /// Asks where to; null: nothing happens.
  void saveRig(const LightRig* rig);
  void chooseEnvironment();
  void openModel();
  void setEnvironmentFile(const QString& path);
  /// True when nothing would be lost: nothing unsaved, saved now, or the person said to discard it.
  [[nodiscard]] bool mayDiscard();
  void fillRecentMenu(QMenu* menu);
  void remember(const QString& path);

 private:
  [[nodiscard]] QString startFolder(const char* key) const;
  void rememberFolder(const char* key, const QString& path);

  Document& m_document;
  Loading& m_loading;
  QWidget* m_window = nullptr;
};

}  // namespace dermis
