// The elements of a light rig, moved by hand in the picture and by the fields of the dock.
#include <QComboBox>
#include <QLabel>

#include "core/builtin/environments.h"
#include "core/light_rig/rig_gestures.h"
#include "core/light_rig/rig_io.h"
#include "core/scene/scene_io.h"
#include "ui/document/rig_edit.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/rows/number_field.h"
#include "ui/viewport/rig_gizmos.h"

namespace dermis {
namespace {

class RigGestures : public PictureEditor {
 protected:
  QTemporaryDir folder;

  void SetUp() override {
    PictureEditor::SetUp();
    if (HasFatalFailure()) return;
    window->loading().openModel(ModelSource{{}, "sphere", {}, std::nullopt});
    ASSERT_TRUE(waitIdle());
    light({}, "studio");
    gizmos().setEnabled(true);
    undo().clear();
    wake();
  }
  void light(const std::string& path, const std::string& builtin) {
    EnvironmentSource source;
    source.path = path;
    source.builtin = builtin;
    window->loading().setEnvironment(source);
    ASSERT_TRUE(waitIdle());
  }
  RigGizmos& gizmos() { return window->viewTools()->rigGizmos(); }
  RigEdit& edit() { return window->viewTools()->rig(); }
  const RigElement& element(std::size_t i) { return edit().rig()->elements.at(i); }
  /// The light of the rig as it is now, whole.
  bool lightArrives() {
    return QTest::qWaitFor(
        [&] {
          const auto& images = document().environmentImages();
          return images->latLong && images->latLong->width == edit().rig()->width && !images->preview;
        },
        8000);
  }
};

TEST_F(RigGestures, ADragMovesASoftboxAsOneEntryAndThePictureFollows) {
  const QImage before = picture();
  wake();
  const RigElement start = element(0);
  const QPointF from = gizmos().handle(0), to = from + QPointF(90.0, 60.0);
  press(from);
  pull(from, to);
  EXPECT_TRUE(document().scene().environment.rig);
  EXPECT_TRUE(document().scene().environment.builtin.empty());
  // While the hand holds it, a coarse light comes.
  EXPECT_TRUE(QTest::qWaitFor([&] { return document().environmentImages()->preview; }, kPatienceMs));
  letGo(to);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_LT((gizmos().handle(0) - to).manhattanLength(), 1.5);
  EXPECT_NE(element(0).azimuthDegrees, start.azimuthDegrees);
  EXPECT_EQ(element(0).sizeM, start.sizeM);
  ASSERT_TRUE(lightArrives());
  ASSERT_TRUE(waitIdle());
  EXPECT_GT(meanDifference(before, picture()), 0.5F);
  // What the program carries stays as it is.
  EXPECT_EQ(builtinRig("studio")->elements[0], start);
  undo().undo();
  EXPECT_EQ(document().scene().environment.builtin, "studio");
  EXPECT_EQ(element(0), start);
  ASSERT_TRUE(waitIdle());
  EXPECT_LT(meanDifference(before, picture()), 0.05F);
  undo().redo();
  EXPECT_NE(element(0), start);
  EXPECT_TRUE(lightArrives());
}

TEST_F(RigGestures, EscAndAWayBackLeaveNoEntry) {
  const RigElement start = element(0);
  const QPointF from = gizmos().handle(0);
  press(from);
  pull(from, from + QPointF(60.0, 0.0));
  EXPECT_NE(element(0), start);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_EQ(element(0), start);
  EXPECT_EQ(undo().count(), 0);
  EXPECT_EQ(document().scene().environment.builtin, "studio");
  EXPECT_FALSE(edit().isOwn());
}

TEST_F(RigGestures, TheWheelAndTheSizeHandleChangeBrightnessAndSize) {
  const RigElement start = element(0);
  const QPointF at = gizmos().handle(0);
  const auto wheel = [&](Qt::KeyboardModifiers keys) {
    QWheelEvent event(at, viewport()->mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, keys, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(viewport(), &event);
  };
  wheel({});
  wheel({});
  EXPECT_GT(amountOf(element(0)), amountOf(start));
  EXPECT_EQ(undo().count(), 1);
  wheel(Qt::ControlModifier);
  EXPECT_GT(sizeOf(element(0))->size.x, sizeOf(start)->size.x);
  const float height = sizeOf(element(0))->size.y;
  wake();
  const QPointF grip = gizmos().sizeHandles().at(0);
  press(grip);
  pull(grip, grip + QPointF(20.0, 0.0));
  letGo(grip + QPointF(20.0, 0.0));
  EXPECT_GT(sizeOf(element(0))->size.x, 1.2F * sizeOf(start)->size.x);
  EXPECT_EQ(sizeOf(element(0))->size.y, height);
}

TEST_F(RigGestures, TheDockShowsTheChosenElementAndChangesIt) {
  press(gizmos().handle(1));
  letGo(gizmos().handle(1));
  EXPECT_EQ(find<QComboBox>(QStringLiteral("rig.element"))->currentIndex(), 1);
  EXPECT_EQ(undo().count(), 0);
  auto* field = window->findChild<NumberField*>(QStringLiteral("rig.azimuth_degrees.number"));
  ASSERT_NE(field, nullptr);
  reveal(field);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("12.5"));
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_FLOAT_EQ(element(1).azimuthDegrees, 12.5F);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(find<QLabel>(QStringLiteral("rig.state"))->text().contains(QStringLiteral("kept in the scene")));
}

TEST_F(RigGestures, AFileOfOnesOwnIsNotOverwrittenAndTheSceneKeepsTheChange) {
  const std::filesystem::path file = folder.filePath(QStringLiteral("mine.json")).toStdString();
  ASSERT_TRUE(saveRig(file, *builtinRig("rim")));
  light(file.string(), {});
  RigElement moved = element(0);
  moved.azimuthDegrees += 40.0F;
  edit().setElement(0, moved, QStringLiteral("Azimuth"), 0);
  ASSERT_TRUE(lightArrives());
  Warnings warnings;
  EXPECT_EQ(*loadRig(file, warnings), *builtinRig("rim"));
  const std::filesystem::path scene = folder.filePath(QStringLiteral("look.dermis")).toStdString();
  ASSERT_TRUE(window->loading().saveScene(scene));
  const auto read = loadScene(scene, warnings);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->environment.rig->elements[0], moved);
  // Save as: what the dock writes opens again as the same rig.
  const std::filesystem::path copy = folder.filePath(QStringLiteral("copy.json")).toStdString();
  ASSERT_TRUE(window->loading().saveRig(*edit().rig(), copy));
  EXPECT_EQ(*loadRig(copy, warnings), *edit().rig());
}

}  // namespace
}  // namespace dermis
