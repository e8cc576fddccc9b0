// Values, groups and whole materials to the clipboard and back, and one edit on several slots.
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QTimer>

#include "core/material/preset_io.h"
#include "core/material/values_text.h"
#include "ui/docks/material_clipboard.h"
#include "ui/docks/material_panel.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

class CopyPaste : public Editor {
 protected:
  const QString face = QStringLiteral("face"), eye = QStringLiteral("eye");
  void SetUp() override {
    Editor::SetUp();
    document().setCurrentSlot(face);
    QApplication::clipboard()->clear();
  }
  const MaterialParameters& of(const QString& slot) { return document().slotLook(slot)->worn.material.parameters; }
  PropertyRow* row(const char* id) { return find<PropertyRow>(QString::fromLatin1(id)); }
  MaterialClipboard* clipboard() { return window->findChild<MaterialPanel*>()->clipboard(); }
  static void put(const char* text) { QApplication::clipboard()->setText(QString::fromUtf8(text)); }
};

TEST_F(CopyPaste, AValueGoesByTheKeysFromOneRowToAnother) {
  document().setParameter(face, "specular.lobe_mix", 0.05F, newGesture());
  document().setParameter(face, "subsurface.weight", 0.9F, newGesture());
  const QImage before = picture();
  auto* from = find<ValueSlider>(QStringLiteral("specular.lobe_mix.slider"));
  auto* to = find<ValueSlider>(QStringLiteral("subsurface.weight.slider"));
  reveal(from);
  QTest::keyClick(from, Qt::Key_C, Qt::ControlModifier);
  reveal(to);
  QTest::keyClick(to, Qt::Key_V, Qt::ControlModifier);
  EXPECT_FLOAT_EQ(of(face).subsurfaceWeight, 0.05F);
  EXPECT_EQ(undo().count(), 3);
  EXPECT_GT(meanDifference(before, picture()), 0.02F);
}

TEST_F(CopyPaste, AValueFromAnotherProgramIsTakenAsItIsTyped) {
  put(" 0,5 cm");
  row("subsurface.radius_mm")->paste();  // three numbers are wanted
  EXPECT_EQ(undo().count(), 0);
  EXPECT_FALSE(window->messageBar()->message().isEmpty());
  row("transmission.thickness_max_mm")->paste();
  EXPECT_FLOAT_EQ(of(face).transmissionThicknessMaxMm, 5.0F);
  put("0.2,0.1,0.05");
  row("base.albedo")->paste();
  EXPECT_EQ(of(face).baseAlbedo, (Colour{{0.2F, 0.1F, 0.05F}}));
  put(R"({"format": "dermis.values", "version": 1, "values": {"subsurface.profile": "gaussians"}})");
  row("subsurface.profile")->paste();
  EXPECT_EQ(of(face).subsurfaceProfile, DiffusionFamily::Gaussians);
  EXPECT_EQ(undo().count(), 3);
}

TEST_F(CopyPaste, JunkSaysOneSentenceAndChangesNothing) {
  const Scene before = document().scene();
  const char* const kJunk[] = {"Dear editor,\nhow are you?",
                               "{",
                               R"({"format": "dermis.values", "version": 7, "values": {"specular.ior": 1.5}})",
                               R"({"format": "dermis.values", "version": 1, "values": {"specular.ior": "wet"}})",
                               R"({"format": "dermis.values", "version": 1, "values": {"no.such": "wet"}})",
                               R"({"format": "else", "values": {}})",
                               "[1, 2, 3]"};
  for (const char* junk : kJunk) {
    put(junk);
    window->messageBar()->hide();
    row("specular.ior")->paste();
    EXPECT_TRUE(window->messageBar()->isVisible()) << junk;
    window->messageBar()->hide();
    clipboard()->paste();
    EXPECT_TRUE(window->messageBar()->isVisible()) << junk;
    EXPECT_FALSE(window->messageBar()->message().contains(QLatin1Char('\n'))) << junk;
  }
  EXPECT_EQ(document().scene(), before);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CopyPaste, AGroupGoesToAnotherSlotAsOneEntry) {
  document().setParameter(face, "specular.ior", 1.6F, newGesture());
  document().setParameter(face, "specular.lobe_mix", 0.25F, newGesture());
  const MaterialParameters eyeBefore = of(eye);
  clipboard()->copyGroup(QStringLiteral("Specular"));
  document().setCurrentSlot(eye);
  const int entries = undo().count();
  clipboard()->paste();
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_FLOAT_EQ(of(eye).specularLobeMix, 0.25F);
  EXPECT_EQ(of(eye).eyeIrisColor, eyeBefore.eyeIrisColor);
  EXPECT_EQ(of(eye).subsurfaceScale, eyeBefore.subsurfaceScale);
  undo().undo();
  EXPECT_EQ(of(eye), eyeBefore);
}

TEST_F(CopyPaste, AMaterialGoesToAnotherSlotWithItsMaps) {
  document().setParameter(face, "subsurface.scale", 2.25F, newGesture());
  clipboard()->copyMaterial();
  Warnings warnings;
  ASSERT_TRUE(readPreset(QApplication::clipboard()->text().toStdString(), "text", {}, warnings));
  document().setCurrentSlot(eye);
  const QImage before = picture();
  const int entries = undo().count();
  clipboard()->paste();
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_EQ(document().slotLook(eye)->worn.material.model, ShadingModel::Skin);
  EXPECT_FLOAT_EQ(of(eye).subsurfaceScale, 2.25F);
  EXPECT_EQ(document().slotLook(eye)->worn.images, document().slotLook(face)->worn.images);
  EXPECT_GT(meanDifference(before, picture()), 0.01F);
}

TEST_F(CopyPaste, AnEditOfSeveralSlotsIsOneEntry) {
  document().setEditedSlots({face, eye});
  auto* slider = find<ValueSlider>(QStringLiteral("specular.perceptual_roughness.slider"));
  reveal(slider);
  // They differ: the row says so.
  EXPECT_EQ(find<NumberField>(QStringLiteral("specular.perceptual_roughness.number"))->text(), QStringLiteral("—"));
  const QImage before = picture();
  drag(slider, slider->handleCentre(), -40);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_FLOAT_EQ(of(face).specularPerceptualRoughness, of(eye).specularPerceptualRoughness);
  EXPECT_NE(find<NumberField>(QStringLiteral("specular.perceptual_roughness.number"))->text(), QStringLiteral("—"));
  EXPECT_GT(meanDifference(before, picture()), 0.05F);
  undo().undo();
  EXPECT_NE(of(face).specularPerceptualRoughness, of(eye).specularPerceptualRoughness);
}

TEST_F(CopyPaste, OneComponentOfSeveralSlotsLeavesTheOthers) {
  document().setParameter(eye, "specular.lobe_scale", glm::vec2(0.5F, 2.0F), newGesture());
  document().setParameter(face, "specular.lobe_scale", glm::vec2(0.75F, 1.3F), newGesture());
  document().setEditedSlots({face, eye});
  auto* field = find<NumberField>(QStringLiteral("specular.lobe_scale.1.number"));
  ASSERT_NE(field, nullptr);
  reveal(field);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("0.9"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(of(face).specularLobeScale, glm::vec2(0.9F, 1.3F));
  EXPECT_EQ(of(eye).specularLobeScale, glm::vec2(0.9F, 2.0F));
}

TEST_F(CopyPaste, DraggingPastTheEndSetsTheOtherSlotsToo) {
  auto* slider = find<ValueSlider>(QStringLiteral("specular.perceptual_roughness.slider"));
  reveal(slider);
  const auto end = static_cast<float>(slider->range().softMax);
  // At the end of the slider, and where a typed number lies past it.
  for (const float there : {end, 1.0F}) {
    document().setCurrentSlot(face);
    document().setParameter(face, "specular.perceptual_roughness", there, newGesture());
    document().setParameter(eye, "specular.perceptual_roughness", 0.3F, newGesture());
    document().setEditedSlots({face, eye});
    const int entries = undo().count();
    // A press on the handle wants nothing yet, nor does a hand that goes up or down.
    const QPoint grip = slider->handleCentre();
    QTest::mousePress(slider, Qt::LeftButton, {}, grip);
    QTest::mouseMove(slider, grip + QPoint(0, 6));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, grip + QPoint(0, 6));
    EXPECT_EQ(undo().count(), entries);
    EXPECT_FLOAT_EQ(of(eye).specularPerceptualRoughness, 0.3F);
    drag(slider, grip, 60);
    EXPECT_EQ(undo().count(), entries + 1);
    EXPECT_FLOAT_EQ(of(face).specularPerceptualRoughness, there);
    EXPECT_FLOAT_EQ(of(eye).specularPerceptualRoughness, there);
    undo().undo();
    EXPECT_FLOAT_EQ(of(eye).specularPerceptualRoughness, 0.3F);
    // So does the key that goes there.
    QTest::keyClick(slider, Qt::Key_End);
    EXPECT_FLOAT_EQ(of(face).specularPerceptualRoughness, end);
    EXPECT_FLOAT_EQ(of(eye).specularPerceptualRoughness, end);
  }
}

TEST_F(CopyPaste, OneComponentPastItsEndAndAResetGoToAllSlots) {
  document().setParameter(eye, "specular.lobe_scale", glm::vec2(0.5F, 2.0F), newGesture());
  document().setParameter(face, "specular.lobe_scale", glm::vec2(0.75F, 1.3F), newGesture());
  auto* slider = find<ValueSlider>(QStringLiteral("specular.lobe_scale.1.slider"));
  reveal(slider);
  const auto end = static_cast<float>(slider->range().softMax);
  document().setParameter(face, "specular.lobe_scale", glm::vec2(end, 1.3F), newGesture());
  document().setEditedSlots({face, eye});
  drag(slider, slider->handleCentre(), 40);
  EXPECT_EQ(of(face).specularLobeScale, glm::vec2(end, 1.3F));
  EXPECT_EQ(of(eye).specularLobeScale, glm::vec2(end, 2.0F));
  // The slot that is shown has the default already in one of them.
  const glm::vec2 start = MaterialParameters{}.specularLobeScale;
  document().setParameter(face, "specular.lobe_scale", glm::vec2(start.x, 1.4F), newGesture());
  find<PropertyRow>(QStringLiteral("specular.lobe_scale"))->reset();
  EXPECT_EQ(of(face).specularLobeScale, start);
  EXPECT_EQ(of(eye).specularLobeScale, start);
}

TEST_F(CopyPaste, SlotsAreTickedInTheListBesideTheCombo) {
  auto* list = find<QListWidget>(QStringLiteral("material.together.list"));
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->count(), document().slotNames().size());
  for (int i = 0; i < list->count(); ++i)
    if (list->item(i)->text() == eye) list->item(i)->setCheckState(Qt::Checked);
  EXPECT_EQ(document().editedSlots(), (QStringList{face, eye}));
  find<QAction>(QStringLiteral("material.together.one"))->trigger();
  EXPECT_EQ(document().editedSlots(), QStringList{face});
  find<QAction>(QStringLiteral("material.together.all"))->trigger();
  EXPECT_EQ(document().editedSlots(), document().slotNames());
  document().setCurrentSlot(eye);
  EXPECT_EQ(document().editedSlots(), QStringList{eye});
}

TEST_F(CopyPaste, TheMenuOfARowResetsCopiesAndPastes) {
  document().setParameter(face, "specular.lobe_mix", 0.1F, newGesture());
  PropertyRow* lobes = row("specular.lobe_mix");
  reveal(lobes);
  QStringList seen;
  QTimer::singleShot(300, window.get(), [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (menu == nullptr) return;
    for (QAction* action : menu->actions()) seen << action->objectName();
    for (QAction* action : menu->actions())
      if (action->objectName() == QLatin1String("row.reset")) menu->setActiveAction(action);
    QTest::keyClick(menu, Qt::Key_Return);
  });
  const QPoint at = lobes->rect().center();
  QContextMenuEvent event(QContextMenuEvent::Keyboard, at, lobes->mapToGlobal(at));
  QApplication::sendEvent(lobes, &event);
  for (const char* id : {"row.reset", "row.copy", "row.paste", "material.copyGroup", "material.copy", "material.paste"})
    EXPECT_TRUE(seen.contains(QLatin1String(id))) << id;
  EXPECT_FLOAT_EQ(of(face).specularLobeMix, MaterialParameters{}.specularLobeMix);
  EXPECT_EQ(undo().count(), 2);
}

TEST_F(CopyPaste, TheDotTellsAPresetsChangesFromTheDefaults) {
  Material material;
  material.name = "Dots";
  material.parameters.specularLobeMix = 0.4F;
  document().applyMaterial({face}, ResolvedMaterial{material, {}}, "/presets/dots.json");
  PropertyRow* lobes = row("specular.lobe_mix");
  EXPECT_TRUE(lobes->isModified());
  EXPECT_FALSE(lobes->differsFromPreset());
  document().setParameter(face, "specular.lobe_mix", 0.5F, newGesture());
  EXPECT_TRUE(lobes->differsFromPreset());
  lobes->resetToPreset();
  EXPECT_FLOAT_EQ(of(face).specularLobeMix, 0.4F);
  EXPECT_FALSE(lobes->differsFromPreset());
  EXPECT_EQ(undo().count(), 3);
}

}  // namespace
}  // namespace dermis
