// The Presets dock: the looks that the program carries, and those of the user's folder.
#pragma once

#include <QWidget>

class QFileSystemWatcher;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace dermis {

class Document;
class Loading;

/// Where the user's presets are kept; made when it is first needed.
[[nodiscard]] QString userPresetFolder();

class PresetsPanel : public QWidget {
  Q_OBJECT
 public:
  PresetsPanel(Document& document, Loading& loading, QWidget* parent = nullptr);
  /// Reads the user's folder again.
  void refresh();

 Q_SIGNALS:
  void saveRequested();
  void saveAsRequested();

 private:
  void applySelected();
  void refreshSelection();
  void filter();

  Document& m_document;
  Loading& m_loading;
  QLineEdit* m_search = nullptr;
  QListWidget* m_list = nullptr;
  QPushButton* m_apply = nullptr;
  QFileSystemWatcher* m_watcher = nullptr;
};

}  // namespace dermis
