// A label that shows as much of a file's name as fits, its beginning and its end.
#pragma once

#include <QLabel>

namespace dermis {

class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void setFullText(const QString& text);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();
  QString m_full;
};

}  // namespace dermis
