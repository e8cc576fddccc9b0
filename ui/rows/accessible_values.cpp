#include "ui/rows/accessible_values.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QToolButton>

#include "ui/dialogs/colour_areas.h"
#include "ui/dialogs/colour_picker.h"
#include "ui/rows/accessible_choice.h"
#include "ui/rows/colour_editor.h"
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

/// A button of a class that Qt doesn't know as one.
class AccessibleButton : public QAccessibleWidget {
 public:
  explicit AccessibleButton(QAbstractButton* button) : QAccessibleWidget(button, QAccessible::Button) {}

  [[nodiscard]] QStringList actionNames() const override { return {pressAction(), setFocusAction()}; }
  void doAction(const QString& action) override {
    if (action == pressAction())
      button()->click();
    else
      QAccessibleWidget::doAction(action);
  }

 protected:
  [[nodiscard]] QAbstractButton* button() const { return static_cast<QAbstractButton*>(widget()); }
};

/// Qt gives the buttons inside a line edit no name; the field's own says what they are for.
class AccessibleFieldButton : public AccessibleButton {
 public:
  using AccessibleButton::AccessibleButton;

  [[nodiscard]] QString text(QAccessible::Text kind) const override {
    const QString own = QAccessibleWidget::text(kind);
    if (kind != QAccessible::Name || !own.isEmpty()) return own;
    const QString field = button()->parentWidget()->accessibleName();
    const auto* tool = qobject_cast<QToolButton*>(button());
    const bool clears = tool != nullptr && tool->defaultAction() != nullptr &&
                        tool->defaultAction()->objectName().contains(QLatin1String("clear"), Qt::CaseInsensitive);
    return clears ? QCoreApplication::translate("dermis::SearchField", "%1: empty the field").arg(field) : field;
  }
};

/// Popups are no children of anything in Qt's tree: the picker hangs below the swatch that opened it.
class AccessibleSwatch : public AccessibleButton {
 public:
  using AccessibleButton::AccessibleButton;

  [[nodiscard]] QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.hasPopup = true;
    return state;
  }
  [[nodiscard]] int childCount() const override { return openPicker() != nullptr ? 1 : 0; }
  [[nodiscard]] QAccessibleInterface* child(int index) const override {
    return index == 0 && openPicker() != nullptr ? QAccessible::queryAccessibleInterface(openPicker()) : nullptr;
  }
  [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override {
    return child != nullptr && child->object() == openPicker() ? 0 : -1;
  }

 private:
  [[nodiscard]] QWidget* openPicker() const {
    QWidget* picker = static_cast<Swatch*>(widget())->picker();
    return picker != nullptr && picker->isVisible() ? picker : nullptr;
  }
};

class AccessiblePicker : public QAccessibleWidget {
 public:
  explicit AccessiblePicker(ColourPicker* picker) : QAccessibleWidget(picker, QAccessible::Dialog) {}
  [[nodiscard]] QAccessibleInterface* parent() const override {
    return QAccessible::queryAccessibleInterface(static_cast<ColourPicker*>(widget())->anchor());
  }
};

QAccessibleInterface* makeInterface(const QString& className, QObject* object) {
  if (className == QLatin1String("QLineEditIconButton"))
    if (auto* button = qobject_cast<QAbstractButton*>(object)) return new AccessibleFieldButton(button);
  // What is drawn, or pressed, is no mere box.
  if (className == QLatin1String("dermis::Viewport"))
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::Canvas);
  if (className == QLatin1String("dermis::MessageBar"))  // read out when it comes up
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::AlertMessage);
  if (className == QLatin1String("QKeySequenceEdit"))
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::HotkeyField);
  if (auto* picker = qobject_cast<ColourPicker*>(object)) return new AccessiblePicker(picker);
  if (auto* swatch = qobject_cast<Swatch*>(object)) return new AccessibleSwatch(swatch);
  if (auto* box = qobject_cast<QComboBox*>(object)) return new AccessibleChoice(box);
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
