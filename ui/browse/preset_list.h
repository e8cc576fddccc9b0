// The list of presets: pictures and names, to be dragged onto a slot.
#pragma once

#include <QListWidget>

class QMimeData;

namespace dermis {

/// The preset that is being dragged: "builtin:NAME" or a file's path; empty where it is something else.
[[nodiscard]] QString draggedPreset(const QMimeData* data);

class PresetList : public QListWidget {
  Q_OBJECT
 public:
  static constexpr int kPathRole = Qt::UserRole;
  static constexpr int kKeyRole = Qt::UserRole + 1;
  static constexpr int kTagsRole = Qt::UserRole + 2;
  static constexpr int kNameRole = Qt::UserRole + 3;

  explicit PresetList(QWidget* parent = nullptr);
  [[nodiscard]] QString currentPath() const;

 protected:
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
};

}  // namespace dermis
