// How tall an opened model is, and the unit that makes it so.
#include <QLabel>
#include <QToolButton>

#include "ui/editor_fixture.h"

namespace dermis {
namespace {

class ModelUnit : public Editor {
 protected:
  QTemporaryDir folder;
  QWidget* bar() { return find<QWidget>(QStringLiteral("modelUnit")); }
  QString words() { return find<QLabel>(QStringLiteral("modelUnit.text"))->text(); }
  void openModel(const char* name, float size) {
    window->openFile(QString::fromStdString(write(folder, name, triangleObj("face", size))));
    ASSERT_TRUE(waitIdle());
  }
};

TEST_F(ModelUnit, OpeningAModelSaysItsHeightAndAUnitCanBeChosen) {
  EXPECT_TRUE(bar()->isHidden());
  openModel("head.obj", 0.25F);
  EXPECT_FALSE(bar()->isHidden());
  EXPECT_TRUE(words().contains(QStringLiteral("head.obj"))) << words().toStdString();
  EXPECT_FALSE(find<QLabel>(QStringLiteral("modelUnit.why"))->toolTip().isEmpty()) << "an OBJ doesn't say its unit";
  const int entries = undo().count();
  find<QToolButton>(QStringLiteral("modelUnit.m"))->click();
  EXPECT_TRUE(words().contains(QStringLiteral("250 mm"))) << words().toStdString();
  EXPECT_FLOAT_EQ(document().millimetresPerUnit(), 1000.0F);
  find<QToolButton>(QStringLiteral("modelUnit.cm"))->click();
  EXPECT_TRUE(words().contains(QStringLiteral("2.5 mm"))) << words().toStdString();
  EXPECT_FLOAT_EQ(*document().scene().model.millimetresPerUnit, 10.0F);
  const int chosen = undo().count();
  EXPECT_GT(chosen, entries);
  undo().undo();
  EXPECT_FLOAT_EQ(document().millimetresPerUnit(), 1000.0F);
  EXPECT_TRUE(words().contains(QStringLiteral("250 mm")));
}

TEST_F(ModelUnit, ANumberOfMillimetresIsTypedAndSkinsReachChangesWithIt) {
  window->loading().openModel(ModelSource{{}, "sphere", {}, std::nullopt});
  ASSERT_TRUE(waitIdle());
  undo().clear();
  Light lamp;
  lamp.type = LightType::Sphere;
  lamp.position = {0.0F, 0.0F, 3.0F};
  lamp.radiusMm = 20.0F;
  document().addLight(lamp);
  const QImage before = picture();
  const float millimetres = document().millimetresPerUnit();
  auto* field = find<NumberField>(QStringLiteral("modelUnit.number"));
  for (QAction* action : window->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Model &unit…")) action->trigger();
  ASSERT_TRUE(field->isVisible());
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("1 cm"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FLOAT_EQ(document().millimetresPerUnit(), 10.0F);
  // A lamp keeps its size beside the model.
  EXPECT_NEAR(document().scene().lights[0].radiusMm, 20.0F * 10.0F / millimetres, 1e-3F);
  EXPECT_EQ(undo().count(), 2);
  EXPECT_GT(meanDifference(before, picture()), 0.2F);
}

/// On another model the built-in look has lost the head's maps; what an artist changed is still marked, and reverting
/// takes back that and no more.
TEST_F(ModelUnit, WhatWasEditedIsStillEditedOnAnotherModel) {
  document().setCurrentSlot(QStringLiteral("face"));
  auto* preset = find<QLabel>(QStringLiteral("material.preset"));
  ASSERT_FALSE(preset->text().endsWith(QLatin1Char('*'))) << preset->text().toStdString();
  openModel("face.obj", 250.0F);
  EXPECT_FALSE(preset->text().endsWith(QLatin1Char('*'))) << "nobody has changed anything";
  undo().undo();
  document().setParameter(QStringLiteral("face"), "subsurface.scale", 2.5F, newGesture());
  ASSERT_TRUE(preset->text().endsWith(QLatin1Char('*')));
  openModel("face.obj", 250.0F);
  EXPECT_TRUE(preset->text().endsWith(QLatin1Char('*'))) << preset->text().toStdString();
  const Material worn = document().currentLook()->worn.material;
  EXPECT_FLOAT_EQ(worn.parameters.subsurfaceScale, 2.5F);
  find<QToolButton>(QStringLiteral("material.revert"))->click();
  ASSERT_TRUE(waitIdle());
  const Material& reverted = document().currentLook()->worn.material;
  EXPECT_FLOAT_EQ(reverted.parameters.subsurfaceScale, 1.0F);
  EXPECT_EQ(reverted.textures, worn.textures) << "the head's maps don't come back";
  EXPECT_FALSE(preset->text().endsWith(QLatin1Char('*')));
}

}  // namespace
}  // namespace dermis
