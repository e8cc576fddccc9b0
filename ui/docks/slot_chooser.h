// Which slot the docks show, and which others an edit goes to as well.
#pragma once

#include <QWidget>

class QComboBox;
class QListWidget;
class QMenu;
class QMimeData;
class QToolButton;

namespace dermis {

class Document;
class SlotDropList;

class SlotChooser : public QWidget {
  Q_OBJECT
 public:
  explicit SlotChooser(Document& document, QWidget* parent = nullptr);
  void refresh();

 Q_SIGNALS:
  /// A preset was dragged onto the box, or onto one slot of the list that comes up below it.
  void presetDropped(const QString& preset, const QStringList& slots_);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void takeChecked();
  [[nodiscard]] static bool takes(const QMimeData* data);
  void take(const QMimeData* data, const QStringList& slots_);

  Document& m_document;
  QComboBox* m_slot = nullptr;
  QToolButton* m_together = nullptr;
  QMenu* m_menu = nullptr;
  QListWidget* m_list = nullptr;
  SlotDropList* m_drop = nullptr;
};

}  // namespace dermis
