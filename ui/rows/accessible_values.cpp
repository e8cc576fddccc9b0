#include "ui/rows/accessible_values.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QAction>
#include <QCoreApplication>
#include <QToolButton>

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

/// Qt gives the buttons inside a line edit no name; the field's own says what they are for.
class AccessibleFieldButton : public QAccessibleWidget {
 public:
  explicit AccessibleFieldButton(QAbstractButton* button)
      : QAccessibleWidget(button, QAccessible::Button), m_button(button) {}

  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    const QString own = QAccessibleWidget::text(kind);
    if (kind != QAccessible::Name || !own.isEmpty()) return own;
    const QString field = m_button->parentWidget()->accessibleName();
    const bool clears = qobject_cast<QToolButton*>(m_button) != nullptr &&
                        static_cast<QToolButton*>(m_button)->defaultAction() != nullptr &&
                        static_cast<QToolButton*>(m_button)->defaultAction()->objectName().contains(
                            QLatin1String("clear"), Qt::CaseInsensitive);
    return clears ? QCoreApplication::translate("dermis::SearchField", "%1: empty the field").arg(field) : field;
  }
  [[nodiscard]] QStringList actionNames() const override { return {pressAction()}; }
  void doAction(const QString& action) override {
    if (action == pressAction()) m_button->click();
  }

 private:
  QAbstractButton* m_button;
};

QAccessibleInterface* makeInterface(const QString& className, QObject* object) {
  if (className == QLatin1String("QLineEditIconButton"))
    if (auto* button = qobject_cast<QAbstractButton*>(object)) return new AccessibleFieldButton(button);
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
