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

 private:
  void takeChecked();

  Document& m_document;
  QComboBox* m_slot = nullptr;
  QToolButton* m_together = nullptr;
  QMenu* m_menu = nullptr;
  QListWidget* m_list = nullptr;
};

}  // namespace dermis
