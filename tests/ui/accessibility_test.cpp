// What a screen reader and a keyboard find: a name on every control, real numbers, an order that follows the eye.
#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <set>

#include "core/material/parameter_table.h"
#include "ui/docks/material_panel.h"
#include "ui/editor_fixture.h"
#include "ui/rows/colour_editor.h"

namespace dermis {
namespace {

class Accessibility : public Editor {
 protected:
  using Visit = std::function<void(QAccessibleInterface&)>;
  static void walk(QAccessibleInterface* at, std::set<QObject*>& seen, const Visit& visit) {
    if (at == nullptr || !at->isValid()) return;
    if (at->object() != nullptr && !seen.insert(at->object()).second) return;
    visit(*at);
    for (int i = 0; i < at->childCount(); ++i) walk(at->child(i), seen, visit);
  }
  void walkWindow(const Visit& visit) {
    std::set<QObject*> seen;
    walk(QAccessible::queryAccessibleInterface(window.get()), seen, visit);
  }
  QAccessibleInterface* named(const QString& name, QAccessible::Role role) {
    QAccessibleInterface* found = nullptr;
    walkWindow([&](QAccessibleInterface& at) {
      if (found == nullptr && at.role() == role && at.text(QAccessible::Name) == name) found = &at;
    });
    return found;
  }
};

TEST_F(Accessibility, NoControlIsWithoutAName) {
  static const std::set<QAccessible::Role> kControls = {
      QAccessible::Button,       QAccessible::ButtonDropDown, QAccessible::ButtonMenu, QAccessible::CheckBox,
      QAccessible::ColorChooser, QAccessible::ComboBox,       QAccessible::Dial,       QAccessible::EditableText,
      QAccessible::List,         QAccessible::MenuItem,       QAccessible::PageTab,    QAccessible::RadioButton,
      QAccessible::Slider,       QAccessible::SpinBox,        QAccessible::Table,      QAccessible::Tree};
  int controls = 0;
  walkWindow([&](QAccessibleInterface& at) {
    if (!kControls.contains(at.role())) return;
    QObject* object = at.object();
    // A combo box's own list has the name of its box.
    for (QObject* parent = object; parent != nullptr; parent = parent->parent())
      if (qobject_cast<QComboBox*>(parent) != nullptr && parent != object) return;
    ++controls;
    QString where;
    for (QObject* parent = object; parent != nullptr; parent = parent->parent())
      where +=
          QLatin1Char(' ') + QLatin1String(parent->metaObject()->className()) + QLatin1Char('#') + parent->objectName();
    EXPECT_FALSE(at.text(QAccessible::Name).isEmpty()) << "role " << at.role() << where.toStdString();
  });
  EXPECT_GT(controls, 250);
}

TEST_F(Accessibility, ASliderHasTheParametersNumbersAndSetsThem) {
  reveal(find<PropertyRow>(QStringLiteral("subsurface.scale")));
  QAccessibleInterface* slider = named(QStringLiteral("Subsurface › Scale"), QAccessible::Slider);
  ASSERT_NE(slider, nullptr);
  QAccessibleValueInterface* value = slider->valueInterface();
  ASSERT_NE(value, nullptr);
  EXPECT_DOUBLE_EQ(value->maximumValue().toDouble(), 100.0);
  const QImage before = picture();
  value->setCurrentValue(2.5);
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 2.5F);
  EXPECT_DOUBLE_EQ(value->currentValue().toDouble(), 2.5);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(meanDifference(before, picture()), 0.02F);

  QAccessibleInterface* field = named(QStringLiteral("Subsurface › Scale"), QAccessible::SpinBox);
  ASSERT_NE(field, nullptr);
  ASSERT_NE(field->valueInterface(), nullptr);
  field->valueInterface()->setCurrentValue(1.25);
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 1.25F);
}

TEST_F(Accessibility, AChoiceIsCalledWhatItChoosesAndItsEntriesCanBePressed) {
  QAccessibleInterface* choice = named(QStringLiteral("Subsurface › Radius reading"), QAccessible::ComboBox);
  ASSERT_NE(choice, nullptr);
  ASSERT_EQ(choice->childCount(), 3);
  EXPECT_EQ(choice->text(QAccessible::Value), QStringLiteral("Diffuse mean free path"));
  QAccessibleInterface* entry = choice->child(2);
  EXPECT_EQ(entry->text(QAccessible::Name), QStringLiteral("Burley d"));
  EXPECT_FALSE(entry->state().selected);
  entry->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_EQ(document().currentLook()->worn.material.parameters.subsurfaceRadiusReading, RadiusReading::BurleyD);
  EXPECT_EQ(choice->text(QAccessible::Value), QStringLiteral("Burley d"));
  EXPECT_TRUE(entry->state().selected);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(Accessibility, TextThatIsPutIntoAFieldCountsAtOnce) {
  QAccessibleInterface* field = named(QStringLiteral("Transmission › Thickness max"), QAccessible::SpinBox);
  ASSERT_NE(field, nullptr);
  QAccessibleEditableTextInterface* words = field->editableTextInterface();
  ASSERT_NE(words, nullptr);
  words->replaceText(0, field->textInterface()->characterCount(), QStringLiteral("1,25 cm"));
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.transmissionThicknessMaxMm, 12.5F);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(Accessibility, EveryControlTakesTheFocusFromTheKeyboard) {
  for (QWidget* control : window->findChildren<QWidget*>()) {
    const bool takes = qobject_cast<ValueSlider*>(control) != nullptr ||
                       qobject_cast<NumberField*>(control) != nullptr || qobject_cast<QComboBox*>(control) != nullptr ||
                       qobject_cast<QAbstractButton*>(control) != nullptr;
    // What Qt itself puts into title bars, tab bars and fields has its own ways.
    bool own = true;
    for (QObject* parent = control; parent != nullptr; parent = parent->parent()) {
      if (parent->objectName().startsWith(QLatin1String("qt_"))) own = false;
      if (parent != control && (parent->inherits("QTabBar") || parent->inherits("QLineEdit"))) own = false;
    }
    if (!takes || !own || control->focusPolicy() == Qt::StrongFocus || control->focusPolicy() == Qt::WheelFocus)
      continue;
    EXPECT_TRUE((control->focusPolicy() & Qt::TabFocus) != 0)
        << control->metaObject()->className() << " " << control->objectName().toStdString() << " "
        << control->accessibleName().toStdString();
  }
}

TEST_F(Accessibility, TheTabKeyGoesDownTheMaterialRows) {
  auto* panel = window->findChild<MaterialPanel*>();
  reveal(find<QComboBox>(QStringLiteral("material.slot")));
  panel->findChild<QScrollArea*>()->verticalScrollBar()->setValue(0);  // wherever the tests before left it
  QWidget* first = find<QComboBox>(QStringLiteral("material.slot"));
  int steps = 0, last = -10000;
  for (QWidget* at = first->nextInFocusChain(); at != first; at = at->nextInFocusChain()) {
    if (!panel->isAncestorOf(at) || !at->isVisibleTo(panel) || !(at->focusPolicy() & Qt::TabFocus)) continue;
    if (at->focusProxy() != nullptr) continue;
    const int y = at->mapTo(panel, QPoint(0, at->height() / 2)).y();
    EXPECT_GE(y, last - 12) << at->objectName().toStdString() << " " << at->accessibleName().toStdString();
    last = std::max(last, y);
    ++steps;
  }
  EXPECT_GT(steps, 40);
}

TEST_F(Accessibility, ArrowKeysMoveASliderFinelyAndCoarsely) {
  auto* slider = find<ValueSlider>(QStringLiteral("specular.lobe_mix.slider"));
  reveal(slider);
  document().setParameter(document().currentSlot(), "specular.lobe_mix", 0.5F, newGesture());
  const auto mix = [this] { return document().currentLook()->worn.material.parameters.specularLobeMix; };
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_NEAR(mix(), 0.51F, 1e-4F);
  QTest::keyClick(slider, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(mix(), 0.511F, 1e-4F);
  QTest::keyClick(slider, Qt::Key_Left, Qt::ControlModifier);
  EXPECT_NEAR(mix() * 20.0F, std::round(mix() * 20.0F), 1e-3F);
  QTest::keyClick(slider, Qt::Key_Delete);
  EXPECT_FLOAT_EQ(mix(), MaterialParameters{}.specularLobeMix);
}

}  // namespace
}  // namespace dermis
