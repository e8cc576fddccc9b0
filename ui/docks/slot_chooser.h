// Which slot the docks show, and which others an edit goes to as well.
#pragma once

#include <QWidget>

class QComboBox;
class QListWidget;
class QMenu;
class QToolButton;

namespace dermis {

class Document;

class SlotChooser : public QWidget {
  Q_OBJECT
 public:
  explicit SlotChooser(Document& document, QWidget* parent = nullptr);
  void refresh();

 Q_SIGNALS:
  /// A preset was dragged onto the box: it is for the slot that it shows.
  void presetDropped(const QString& preset);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void takeChecked();

  Document& m_document;
  QComboBox* m_slot = nullptr;
  QToolButton* m_together = nullptr;
  QMenu* m_menu = nullptr;
  QListWidget* m_list = nullptr;
};

}  // namespace dermis
