// A line below the menus that says what went wrong, without stopping anybody.
#pragma once

#include <QFrame>
#include <QTimer>

#include "ui/document/loading.h"

class QLabel;

namespace dermis {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);
  /// Errors stay until closed; warnings leave by themselves.
  void showMessage(MessageKind kind, const QString& sentence);
  [[nodiscard]] QString message() const;

 private:
  QLabel* m_icon = nullptr;
  QLabel* m_text = nullptr;
  QTimer m_leave;
};

}  // namespace dermis
