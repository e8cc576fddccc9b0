// A field to search with: an icon, a button that empties it, and Esc for the same.
#pragma once

#include <QLineEdit>

namespace dermis {

class SearchField : public QLineEdit {
  Q_OBJECT
 public:
  /// `name` is the place holder and what assistive technology says.
  SearchField(const QString& name, const QString& id, QWidget* parent = nullptr);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace dermis
