// The picker's two areas: saturation and value in a square, hue in a strip.
#pragma once

#include <QWidget>

#include "ui/rows/gesture.h"

namespace dermis {

/// Saturation to the right, value upwards, of one hue; sRGB, because people judge evenness on a screen.
class SaturationSquare : public QWidget {
  Q_OBJECT
 public:
  explicit SaturationSquare(QWidget* parent = nullptr);
  void showHsv(float hue, float saturation, float value);
  [[nodiscard]] float hue() const { return m_hue; }
  [[nodiscard]] float saturation() const { return m_saturation; }
  [[nodiscard]] float value() const { return m_value; }

 Q_SIGNALS:
  void picked(float saturation, float value, dermis::Gesture gesture);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void pickAt(const QPointF& at);
  float m_hue = 0.0F, m_saturation = 0.0F, m_value = 0.0F;
  GestureClock m_clock;
};

class HueStrip : public QWidget {
  Q_OBJECT
 public:
  explicit HueStrip(QWidget* parent = nullptr);
  void showHue(float hue);

 Q_SIGNALS:
  void picked(float hue, dermis::Gesture gesture);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void pickAt(const QPointF& at);
  float m_hue = 0.0F;
  GestureClock m_clock;
};

}  // namespace dermis
