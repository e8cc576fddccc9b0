// Named cameras: a list in the Camera & view dock.
#pragma once

#include <QWidget>

class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace dermis {

class Document;

class BookmarksBox : public QWidget {
  Q_OBJECT
 public:
  explicit BookmarksBox(Document& document, QWidget* parent = nullptr);
  /// Keeps where the camera is, as "View 1" and so on.
  void addHere();
  void removeSelected();
  /// Looks from there; a number that is none does nothing.
  void goTo(int index);

 Q_SIGNALS:
  /// The camera has been moved.
  void visited();

 private:
  void rename(QListWidgetItem* item);
  void refresh();

  Document& m_document;
  QListWidget* m_list = nullptr;
  QToolButton* m_add = nullptr;
  QToolButton* m_remove = nullptr;
};

}  // namespace dermis
