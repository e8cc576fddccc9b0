// What lies over the picture and is never in an export: statistics, a ruler, and what is in the way of a picture.
#pragma once

#include <QLabel>
#include <QWidget>

namespace dermis {

/// A bar of a round number of millimetres.
class ScaleBar : public QWidget {
  Q_OBJECT
 public:
  explicit ScaleBar(QWidget* parent);
  void showScale(double millimetresPerPixel);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int m_pixels = 0;
  QString m_text;
};

/// A line of text on a dark, half transparent ground.
class OverlayLabel : public QLabel {
  Q_OBJECT
 public:
  explicit OverlayLabel(QWidget* parent);
};

}  // namespace dermis
