// Split view, snapshots, readout, ruler, bookmarks, the camera's history, and how sharp the picture is while dragging.
#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QListWidget>
#include <QToolButton>
#include <cmath>

#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/snapshots/snapshots.h"
#include "ui/viewport/camera_history.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/pick_readout.h"

namespace dermis {
namespace {

class ViewToolsTest : public PictureEditor {
 protected:
  void SetUp() override {
    PictureEditor::SetUp();
    if (HasFatalFailure()) return;
    viewport()->compareWith(nullptr);
    viewport()->setSplit(0.5);
    viewport()->setReferences({});
  }
  void TearDown() override {
    viewport()->compareWith(nullptr);
    viewport()->setReferences({});
    viewport()->setPaceTarget(Pace::kTargetMs);
  }
  /// A machine that has to leave pixels out while something is dragged, whatever this one is.
  void beSlow() { viewport()->setPaceTarget(0.1); }
  ViewTools& tools() { return *window->viewTools(); }
  QPoint middle() { return viewport()->rect().center(); }
  void exposure(float stops) {
    EnvironmentSource next = document().scene().environment;
    next.exposureStops = stops;
    document().setEnvironmentSettings(next, QStringLiteral("Environment exposure"), newGesture());
  }
  /// Mean of the grey values in a share of the picture's columns.
  static double brightness(const QImage& picture, double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < picture.height(); y += 2)
      for (int x = static_cast<int>(from * picture.width()); x < static_cast<int>(to * picture.width()); x += 2) {
        sum += qGray(picture.pixel(x, y));
        ++count;
      }
    return sum / std::max(count, 1);
  }
};

// --- sharp and coarse

TEST_F(ViewToolsTest, DraggingDrawsFewerPixelsAndLettingGoAllOfThem) {
  const QImage still = picture();
  const glm::ivec2 whole(still.width(), still.height());
  EXPECT_EQ(viewport()->statistics().pictureSize, whole);
  beSlow();
  const QPointF at(middle());
  send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
  glm::ivec2 smallest = whole;
  for (int i = 1; i <= 12; ++i) {
    send(QEvent::MouseMove, at + QPointF(6.0 * i, 0.0), Qt::NoButton, Qt::LeftButton);
    QSignalSpy shown(viewport(), &GlWidget::frameShown);
    ASSERT_TRUE(shown.wait(kPatienceMs));
    smallest = glm::min(smallest, viewport()->statistics().pictureSize);
  }
  EXPECT_LT(smallest.x, whole.x);
  // The first picture after letting go is whole.
  const auto frames = viewport()->statistics().frames;
  send(QEvent::MouseButtonRelease, at + QPointF(72.0, 0.0), Qt::LeftButton, Qt::NoButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport()->statistics().frames > frames; }, kPatienceMs));
  EXPECT_EQ(viewport()->statistics().pictureSize, whole);
  picture();
  EXPECT_EQ(viewport()->statistics().pictureSize, whole);
}

TEST_F(ViewToolsTest, ACoarsePictureIsAsBrightAsTheSharpOne) {
  picture();
  beSlow();
  const QPointF at(middle());
  send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
  for (int i = 1; i <= 4; ++i) {
    send(QEvent::MouseMove, at + QPointF(5.0 * i, 0.0), Qt::NoButton, Qt::LeftButton);
    QSignalSpy shown(viewport(), &GlWidget::frameShown);
    ASSERT_TRUE(shown.wait(kPatienceMs));
  }
  const glm::ivec2 size = viewport()->statistics().pictureSize;
  const QImage coarse = viewport()->grabFrame();
  send(QEvent::MouseButtonRelease, at + QPointF(20.0, 0.0), Qt::LeftButton, Qt::NoButton);
  const QImage sharp = picture();
  EXPECT_LT(size.x, sharp.width());
  EXPECT_NEAR(brightness(coarse, 0.0, 1.0), brightness(sharp, 0.0, 1.0), 1.0);
  EXPECT_LT(meanDifference(coarse, sharp), 4.0F);
}

// --- split view and snapshots

TEST_F(ViewToolsTest, ASnapshotStaysAsItWasOnTheRightOfTheSplit) {
  picture();
  tools().takeSnapshot();
  ASSERT_EQ(tools().snapshots().all().size(), 1U);
  QApplication::processEvents();
  const QImage before = picture();  // the strip that has appeared takes some of the viewport's place
  EXPECT_FALSE(tools().snapshots().all()[0].thumbnail.isNull());
  exposure(-3.0F);
  tools().compareWithSnapshot(0);
  const QImage split = picture();
  EXPECT_LT(brightness(split, 0.05, 0.45), 0.7 * brightness(before, 0.05, 0.45));
  EXPECT_NEAR(brightness(split, 0.55, 0.95), brightness(before, 0.55, 0.95), 1.5);
  // Both halves have one camera.
  viewport()->setSplit(0.0);
  EXPECT_LT(meanDifference(picture(), before), 1.5F);
  viewport()->setSplit(0.5);
  viewport()->compareWith(nullptr);
  EXPECT_LT(brightness(picture(), 0.55, 0.95), 0.7 * brightness(before, 0.55, 0.95));
  tools().snapshots().remove(0);
}

TEST_F(ViewToolsTest, TheHandleOfTheSplitIsDraggedAndMovesNoCamera) {
  tools().takeSnapshot();
  exposure(-2.0F);
  tools().compareWithSnapshot(0);
  picture();
  const Camera camera = document().camera();
  const QPointF from(0.5 * viewport()->width(), 200.0);
  send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  send(QEvent::MouseMove, from - QPointF(100.0, 0.0), Qt::NoButton, Qt::LeftButton);
  EXPECT_NEAR(viewport()->split(), 0.5 - 100.0 / viewport()->width(), 0.01);
  QTest::keyClick(viewport(), Qt::Key_Escape);
  EXPECT_NEAR(viewport()->split(), 0.5, 1e-9);
  send(QEvent::MouseButtonRelease, from, Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(document().camera(), camera);
  tools().snapshots().remove(0);
}

TEST_F(ViewToolsTest, RestoringASnapshotIsOneEntryAndKeepsTheCamera) {
  const Scene start = document().scene();
  tools().takeSnapshot();
  exposure(1.0F);
  document().addLight(Light{});
  drag(viewport(), middle(), 60);
  const Camera camera = document().camera();
  const int entries = undo().count();
  const Scene changed = document().scene();
  tools().snapshots().restore(0);
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_EQ(document().scene(), start);
  EXPECT_EQ(document().camera(), camera);
  undo().undo();
  EXPECT_EQ(document().scene(), changed);
  EXPECT_EQ(document().camera(), camera);
  tools().snapshots().remove(0);
}

TEST_F(ViewToolsTest, APresetIsComparedWithWhatTheSlotWears) {
  const QImage before = picture();
  document().setCurrentSlot(QStringLiteral("face"));
  tools().compareWithPreset("builtin:jade");
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport()->compared() != nullptr; }, kPatienceMs));
  viewport()->setSplit(0.5);
  const QImage split = picture();
  EXPECT_EQ(undo().count(), 0);
  // Where the face is, however wide the other tests' panels have left the picture.
  const int middle = split.width() / 2, width = split.height() / 12, top = split.height() / 3;
  const QRect left(middle - 4 - width, top, width, top), right(middle + 4, top, width, top);
  EXPECT_LT(meanDifference(split.copy(left), before.copy(left)), 1.0F);
  EXPECT_GT(meanDifference(split.copy(right), before.copy(right)), 8.0F);
}

// --- reading out

TEST_F(ViewToolsTest, TheReadoutSaysWhatThePixelHolds) {
  const QImage shown = picture();
  const QPointF at(middle());
  const auto pixel = viewport()->readPixel(at);
  ASSERT_TRUE(pixel.has_value());
  EXPECT_GT(pixel->radiance.r, 0.0F);
  const QColor code = shown.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
  EXPECT_NEAR(pixel->display.r * 255.0F, static_cast<float>(code.red()), 4.0F);
  EXPECT_NEAR(pixel->display.g * 255.0F, static_cast<float>(code.green()), 4.0F);
  const QString words = tools().readout().textAt(at);
  for (const char* word : {"Radiance", "Display", "Slot face", "Normal", "Depth"})
    EXPECT_TRUE(words.contains(QLatin1String(word))) << word << " in " << words.toStdString();
  send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
  auto* label = find<OverlayLabel>(QStringLiteral("viewport.readout"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !label->isHidden(); }, kPatienceMs));
  EXPECT_EQ(label->text(), words);
  QTest::keyClick(viewport(), Qt::Key_I);
  EXPECT_EQ(tools().readout().pinCount(), 1);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), words);
  tools().readout().clearPins();
}

TEST_F(ViewToolsTest, TheReadoutFollowsThePictureUnderAPointerThatRests) {
  picture();
  const QPointF at(middle() + QPoint(30, 0));
  send(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
  auto* label = find<OverlayLabel>(QStringLiteral("viewport.readout"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !label->isHidden(); }, kPatienceMs));
  const QString before = label->text();
  auto darker = std::make_shared<ResolvedScene>(*document().snapshot());
  darker->scene.environment.exposureStops = -3.0F;
  viewport()->compareWith(darker);
  ASSERT_TRUE(QTest::qWaitFor([&] { return label->text() != before; }, kPatienceMs)) << "it stands right of the split";
  picture();
  ASSERT_TRUE(QTest::qWaitFor([&] { return label->text() == tools().readout().textAt(at); }, kPatienceMs));
  viewport()->compareWith(nullptr);
  ASSERT_TRUE(QTest::qWaitFor([&] { return label->text() == before; }, kPatienceMs)) << label->text().toStdString();
}

TEST_F(ViewToolsTest, AltAndAClickChooseTheSlotADragDoesNot) {
  document().setCurrentSlot(QStringLiteral("eye"));
  ASSERT_EQ(document().currentSlot(), QStringLiteral("eye"));
  const QPointF at(middle());
  send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, Qt::AltModifier);
  send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, Qt::AltModifier);
  EXPECT_EQ(document().currentSlot(), QStringLiteral("face"));
  document().setCurrentSlot(QStringLiteral("eye"));
  drag(viewport(), middle(), 60, Qt::AltModifier);
  EXPECT_EQ(document().currentSlot(), QStringLiteral("eye"));
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(ViewToolsTest, TheRulerMeasuresInMillimetres) {
  picture();
  tools().ruler().setEnabled(true);
  const Camera camera = document().camera();
  drag(viewport(), middle() - QPoint(20, 0), 40);
  const auto length = tools().ruler().millimetres();
  ASSERT_TRUE(length.has_value());
  // Across the middle of the face the surface is nearly square to the view.
  const Projection view = viewport()->projection();
  const double flat = 40.0 * static_cast<double>(view.unitsPerPixel(document().model()->bounds.centre()) *
                                                 document().millimetresPerUnit());
  EXPECT_GT(*length, 0.6 * flat);
  EXPECT_LT(*length, 2.5 * flat);
  EXPECT_EQ(document().camera(), camera);
  EXPECT_TRUE(tools().ruler().words().endsWith(QStringLiteral(" mm")));
  PreferenceValues values = window->preferences().values();
  values.unit = LengthUnit::Inches;
  window->preferences().set(values);
  EXPECT_TRUE(tools().ruler().words().endsWith(QStringLiteral(" in"))) << tools().ruler().words().toStdString();
  window->preferences().set(PreferenceValues{});
  tools().ruler().setEnabled(false);
  EXPECT_FALSE(tools().ruler().millimetres().has_value());
}

// --- cameras

TEST_F(ViewToolsTest, ABookmarkIsOneEntryIsSavedAndBringsTheCameraBack) {
  const Camera start = document().camera();
  auto* add = find<QToolButton>(QStringLiteral("bookmarks.add"));
  reveal(add);
  QTest::mouseClick(add, Qt::LeftButton);
  ASSERT_EQ(document().scene().bookmarks.size(), 1U);
  EXPECT_EQ(undo().count(), 1);
  drag(viewport(), middle(), 90);
  EXPECT_NE(document().camera(), start);
  auto* list = find<QListWidget>(QStringLiteral("bookmarks.list"));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_EQ(document().camera(), start);
  list->item(0)->setText(QStringLiteral("Left ear"));
  EXPECT_EQ(undo().count(), 2);
  QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "look.dermis";
  ASSERT_TRUE(window->loading().saveScene(file));
  QSignalSpy opened(&window->loading(), &Loading::finished);
  window->loading().openScene(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !opened.isEmpty(); }, kPatienceMs));
  ASSERT_EQ(document().scene().bookmarks.size(), 1U);
  EXPECT_EQ(document().scene().bookmarks[0].name, "Left ear");
  EXPECT_EQ(document().scene().bookmarks[0].camera, start);
}

TEST_F(ViewToolsTest, AltLeftGoesBackThroughTheViewsAndIsNoUndoEntry) {
  window->viewTools()->cameraHistory().note();
  const Camera first = document().camera();
  drag(viewport(), middle(), 80);
  window->viewTools()->cameraHistory().note();
  const Camera second = document().camera();
  QTest::keyClick(viewport(), Qt::Key_3);
  const Camera third = document().camera();
  QTest::keyClick(viewport(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(document().camera(), second);
  QTest::keyClick(viewport(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(document().camera(), first);
  QTest::keyClick(viewport(), Qt::Key_Right, Qt::AltModifier);
  QTest::keyClick(viewport(), Qt::Key_Right, Qt::AltModifier);
  EXPECT_EQ(document().camera(), third);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(ViewToolsTest, BallsAndChartAreDrawnWhenAskedFor) {
  const QImage before = picture();
  find<QAction>(QStringLiteral("view.balls"))->trigger();
  const QImage balls = picture();
  const QRect corner(0, balls.height() / 2, balls.width() / 2, balls.height() / 2);
  EXPECT_GT(meanDifference(balls.copy(corner), before.copy(corner)), 0.5F);
  const QRect above(0, 0, balls.width(), balls.height() / 2);
  EXPECT_LT(meanDifference(balls.copy(above), before.copy(above)), 0.5F);
  find<QAction>(QStringLiteral("view.chart"))->trigger();
  const QImage chart = picture();
  EXPECT_GT(meanDifference(chart.copy(corner), balls.copy(corner)), 0.5F);
  find<QAction>(QStringLiteral("view.chart"))->trigger();
  find<QAction>(QStringLiteral("view.balls"))->trigger();
  EXPECT_LT(meanDifference(picture(), before), 0.5F);
}

}  // namespace
}  // namespace dermis
