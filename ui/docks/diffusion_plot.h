// Diffusion profiles over millimetres, painted: three channels of two families, and the width of a pixel.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "core/material/diffusion_profile.h"

namespace dermis {

/// What is drawn.
struct DiffusionCurves {
  DiffusionProfile chosen;
  std::optional<DiffusionProfile> other;  ///< the family that the material doesn't use, dashed
  double pixelMm = 0.0;                   ///< of one pixel at the focus; 0: not known
  bool operator==(const DiffusionCurves&) const = default;
};

class DiffusionPlot : public QWidget {
  Q_OBJECT
 public:
  explicit DiffusionPlot(QWidget* parent = nullptr);

  void showCurves(const DiffusionCurves& curves);
  /// 2πr·R(r), the share of the light that leaves per millimetre of radius, rather than R(r) itself.
  void setRadial(bool radial);
  void setLogarithmic(bool logarithmic);
  [[nodiscard]] bool radial() const { return m_radial; }
  [[nodiscard]] bool logarithmic() const { return m_logarithmic; }

  /// The number under a curve as it is drawn: at r in mm.
  [[nodiscard]] glm::dvec3 plotted(const DiffusionProfile& profile, double r) const;
  /// Where r lies, in widget coordinates; and back.
  [[nodiscard]] double xOf(double r) const;
  [[nodiscard]] double radiusAt(double x) const;
  [[nodiscard]] double longestRadius() const { return m_longest; }
  [[nodiscard]] QSize sizeHint() const override { return {360, 240}; }

 Q_SIGNALS:
  /// The radius under the pointer; negative when it has left.
  void hovered(double r);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  void refreshRange();
  [[nodiscard]] QRectF area() const;
  [[nodiscard]] double yOf(double value) const;
  void paintAxes(QPainter& painter) const;
  void paintPixel(QPainter& painter) const;
  void paintCurves(QPainter& painter, const DiffusionProfile& profile, bool dashed) const;

  DiffusionCurves m_curves;
  bool m_radial = true;
  bool m_logarithmic = false;
  double m_longest = 1.0;                  // mm at the right end
  double m_lowest = 0.0, m_highest = 1.0;  // values at the ends of the other axis
  double m_hover = -1.0;                   // mm
};

/// The colours of the channels on a ground of this lightness.
[[nodiscard]] std::array<QColor, 3> channelColours(const QPalette& palette);

}  // namespace dermis
