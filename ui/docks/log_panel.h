// The Log dock: every message, with its time.
#pragma once

#include <QWidget>

#include "ui/document/loading.h"

class QListWidget;

namespace dermis {

class LogPanel : public QWidget {
  Q_OBJECT
 public:
  explicit LogPanel(QWidget* parent = nullptr);
  void add(MessageKind kind, const QString& sentence);

 private:
  QListWidget* m_list = nullptr;
};

}  // namespace dermis
