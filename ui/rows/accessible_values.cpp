#include "ui/rows/accessible_values.h"

#include <QAccessibleWidget>

#include "ui/dialogs/colour_areas.h"
#include "ui/rows/value_slider.h"

namespace dermis {
namespace {

/// QSlider would tell of its 10000 steps.
class AccessibleSlider : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit AccessibleSlider(ValueSlider* slider) : QAccessibleWidget(slider, QAccessible::Slider), m_slider(slider) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
  }
  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    if (kind != QAccessible::Value) return QAccessibleWidget::text(kind);
    const QString number = QString::number(m_slider->number(), 'g', 6);
    return m_slider->range().unit.isEmpty() ? number : number + QLatin1Char(' ') + m_slider->range().unit;
  }
  [[nodiscard]] QVariant currentValue() const override { return m_slider->number(); }
  void setCurrentValue(const QVariant& value) override { m_slider->setNumber(value.toDouble()); }
  [[nodiscard]] QVariant maximumValue() const override { return m_slider->range().hardMax; }
  [[nodiscard]] QVariant minimumValue() const override { return m_slider->range().hardMin; }
  [[nodiscard]] QVariant minimumStepSize() const override { return m_slider->range().step(); }

 private:
  ValueSlider* m_slider;
};

QAccessibleInterface* makeInterface(const QString&, QObject* object) {
  if (auto* slider = qobject_cast<ValueSlider*>(object)) return new AccessibleSlider(slider);
  if (auto* square = qobject_cast<SaturationSquare*>(object))
    return new QAccessibleWidget(square, QAccessible::ColorChooser);
  if (auto* strip = qobject_cast<HueStrip*>(object)) return new QAccessibleWidget(strip, QAccessible::ColorChooser);
  return nullptr;
}

}  // namespace

void installAccessibleValues() {
  static const bool s_installed = [] {
    QAccessible::installFactory(makeInterface);
    return true;
  }();
  static_cast<void>(s_installed);
}

}  // namespace dermis
