// What the colours of a view of numbers mean: a ramp with ticks, painted over the picture.
#pragma once

#include <QWidget>
#include <vector>

#include "colour/false_colour.h"

namespace dermis {

class Legend : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent);
  /// `title` is the view's name. Sizes itself.
  void showRange(const QString& title, const ValueRange& range);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Round numbers from end to end, in the unit shown.
  [[nodiscard]] std::vector<double> ticks() const;

  QString m_title;
  QString m_unit;
  ValueRange m_range;
  double m_shownPerValue = 1.0;
};

/// 1, 2 or 5 × 10ⁿ: the smallest that divides `span` into at most `most` steps.
[[nodiscard]] double roundStep(double span, int most);

}  // namespace dermis
