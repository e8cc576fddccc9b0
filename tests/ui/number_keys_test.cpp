// Keys and the wheel on numbers: what Ctrl+Z takes back, and numbers past the range of their slider.
#include <QUndoStack>
#include <QWheelEvent>

#include "ui/editor_fixture.h"

namespace dermis {
namespace {

class NumberKeys : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    window->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window.get(), kPatienceMs));
  }
  NumberField* field() { return find<NumberField>(QStringLiteral("subsurface.scale.number")); }
  ValueSlider* slider() { return find<ValueSlider>(QStringLiteral("subsurface.scale.slider")); }
  float scale() { return document().currentLook()->worn.material.parameters.subsurfaceScale; }
  void type(const char* words) {
    reveal(field());
    field()->setFocus();
    QTest::qWait(0);  // the field selects all once it has the focus
    field()->selectAll();
    QTest::keyClicks(field(), QString::fromUtf8(words));
  }
  static void tick(QWidget* on, int delta) {
    const QPointF at = on->rect().center();
    QWheelEvent wheel(at, on->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(on, &wheel);
  }
};

TEST_F(NumberKeys, CtrlZAfterTypingTakesTheNumberBack) {
  const float start = scale();
  type("2.5");
  QTest::keyClick(field(), Qt::Key_Return);
  ASSERT_FLOAT_EQ(scale(), 2.5F);
  ASSERT_TRUE(field()->hasFocus());
  QTest::keyClick(field(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FLOAT_EQ(scale(), start);
  EXPECT_TRUE(undo().canRedo());
  QTest::keyClick(field(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FLOAT_EQ(scale(), 2.5F);
}

TEST_F(NumberKeys, CtrlZWhileTypingIsTheFieldsOwn) {
  document().setParameter(document().currentSlot(), "subsurface.scale", 1.5F, newGesture());
  type("3.25");
  QTest::keyClick(field(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FLOAT_EQ(scale(), 1.5F);
  EXPECT_EQ(undo().index(), 1);
  EXPECT_NE(field()->text(), QStringLiteral("3.25"));
  QTest::keyClick(field(), Qt::Key_Escape);
}

TEST_F(NumberKeys, PastTheSoftRangeAStepOutwardsStaysAndAStepInwardsIsOneStep) {
  document().setParameter(document().currentSlot(), "subsurface.scale", 50.0F, newGesture());  // soft range 0..4
  reveal(slider());
  slider()->setFocus();
  tick(slider(), 120);
  EXPECT_FLOAT_EQ(scale(), 50.0F);
  QTest::keyClick(slider(), Qt::Key_Right);
  EXPECT_FLOAT_EQ(scale(), 50.0F);
  drag(slider(), slider()->handleCentre(), 40);
  EXPECT_FLOAT_EQ(scale(), 50.0F);
  tick(slider(), -120);
  EXPECT_NEAR(scale(), 49.96F, 1e-3F);
  // A pull inwards takes hold of it.
  drag(slider(), slider()->handleCentre(), -30);
  EXPECT_LT(scale(), 4.0F);
}

}  // namespace
}  // namespace dermis
