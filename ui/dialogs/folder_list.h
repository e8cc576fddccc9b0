// A short list of folders that a person can add to and take from.
#pragma once

#include <QStringList>
#include <QWidget>

class QListWidget;

namespace dermis {

class FolderList : public QWidget {
  Q_OBJECT
 public:
  /// `name` is for people and machines: "Preset folders", "presetFolders".
  FolderList(const QString& title, const QString& name, QWidget* parent = nullptr);
  void setFolders(const QStringList& folders);
  [[nodiscard]] QStringList folders() const;
  void add(const QString& folder);

 private:
  QListWidget* m_list = nullptr;
};

}  // namespace dermis
