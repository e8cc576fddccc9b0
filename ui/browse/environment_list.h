// The environments there are: built-in rigs, files of watched folders, files that were used; with panoramas.
#pragma once

#include <QFileSystemWatcher>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "core/scene/scene.h"
#include "ui/browse/panorama_maker.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QToolButton;

namespace dermis {

class ListPlace;
class Preferences;

class EnvironmentList : public QWidget {
  Q_OBJECT
 public:
  explicit EnvironmentList(Preferences& preferences, QWidget* parent = nullptr);
  ~EnvironmentList() override;
  /// Marks the one that is in use, and remembers a file.
  void showUsed(const EnvironmentSource& source);

 Q_SIGNALS:
  /// One of the two is empty.
  void chosen(const QString& builtin, const QString& path);

 private:
  void buildList();
  void fill();
  void filter();
  void addFile(const QString& path);
  void showPicture(QListWidgetItem& item);
  void showPanorama(const QString& environment);
  void showProgress(int waiting);
  [[nodiscard]] QStringList readFiles() const;

  Preferences& m_preferences;
  PanoramaMaker m_panoramas;
  EnvironmentSource m_used;
  QStringList m_files;  ///< those of the list
  QFileSystemWatcher m_watcher;
  QTimer m_soon;
  QLineEdit* m_search = nullptr;
  QListWidget* m_list = nullptr;
  std::unique_ptr<ListPlace> m_place;
  QLabel* m_progress = nullptr;
  QToolButton* m_cancel = nullptr;
};

}  // namespace dermis
