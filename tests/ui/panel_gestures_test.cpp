// Hands on the panels and on what is dropped, with the real picture: it follows, and each gesture is one step of undo.
#include <QAction>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include "ui/docks/slot_drag.h"
#include "ui/document/rig_edit.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"
#include "ui/viewport/pick_readout.h"

namespace dermis {
namespace {

class PanelGestures : public PictureEditor {
 protected:
  const QString face = QStringLiteral("face"), eye = QStringLiteral("eye");
  QTemporaryDir folder;

  QString image(const char* name, const QColor& colour) {
    const QString path = folder.filePath(QString::fromLatin1(name));
    QImage filled(16, 16, QImage::Format_RGB888);
    filled.fill(colour);
    EXPECT_TRUE(filled.save(path));
    return path;
  }
  static QString slotAt(const QPoint& at) { return window->viewTools()->readout().slotAt(QPointF(at)); }
  /// A point of the picture, not at its part's border, where this slot is seen.
  static std::optional<QPoint> pointOf(const QString& slot) {
    for (int y = 8; y < viewport()->height() - 8; y += 4)
      for (int x = 8; x < viewport()->width() - 8; x += 4)
        if (slotAt({x, y}) == slot && slotAt({x - 2, y - 2}) == slot && slotAt({x + 2, y + 2}) == slot)
          return QPoint(x, y);
    return std::nullopt;
  }
  const ResolvedMaterial& worn(const QString& slot) { return document().slotLook(slot)->worn; }
};

TEST_F(PanelGestures, TheWheelOverASliderIsSeenAndIsOneEntry) {
  document().setCurrentSlot(face);
  auto* slider = find<ValueSlider>(QStringLiteral("specular.perceptual_roughness.slider"));
  reveal(slider);
  slider->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return slider->hasFocus(); }, kPatienceMs));
  const QImage before = picture();
  const Material start = worn(face).material;
  for (int i = 0; i < 12; ++i) {
    const QPointF at = slider->rect().center();
    QWheelEvent wheel(at, slider->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(slider, &wheel);
    EXPECT_TRUE(wheel.isAccepted());
  }
  EXPECT_FALSE(worn(face).material == start);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(meanDifference(before, picture()), 0.02F);
  undo().undo();
  EXPECT_EQ(worn(face).material, start);
  EXPECT_LT(meanDifference(before, picture()), 0.01F);
}

TEST_F(PanelGestures, ASlotsLabelIsDraggedByTheMouseOntoAnotherSlot) {
  document().setCurrentSlot(face);
  auto* label = find<SlotHandle>(QStringLiteral("material.preset"));
  reveal(label);
  // From the front, where the eyes are seen.
  viewport()->showNamedView(QStringLiteral("front"));
  const QImage before = picture();
  const auto at = pointOf(eye);
  ASSERT_TRUE(at.has_value()) << "no eye is seen";
  ASSERT_NE(worn(eye).material, worn(face).material);
  // The drag has an event loop of its own: the hand goes on from there.
  const QPoint target = viewport()->mapTo(window.get(), *at);
  QTimer hand;
  int steps = 0;
  QObject::connect(&hand, &QTimer::timeout, &hand, [&] {
    const QPoint from = label->mapTo(window.get(), label->rect().center());
    ++steps;
    if (steps <= 6) {
      QTest::mouseMove(window->windowHandle(), from + (target - from) * steps / 6);
    } else {
      hand.stop();
      QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, target);
    }
  });
  const QPoint grip = label->rect().center();
  QTest::mousePress(label, Qt::LeftButton, {}, grip);
  hand.start(40);
  QTest::mouseMove(label, grip - QPoint(QApplication::startDragDistance() + 5, 0));
  EXPECT_EQ(steps, 7) << "there was no drag";
  EXPECT_EQ(worn(eye).material, worn(face).material);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(meanDifference(before, picture()), 0.01F);
  undo().undo();
  EXPECT_LT(meanDifference(before, picture()), 0.01F);
}

TEST_F(PanelGestures, AMapDroppedOnThePictureGoesToTheSlotSeenThere) {
  document().setCurrentSlot(eye);
  const QImage before = picture();
  const auto at = pointOf(face);
  ASSERT_TRUE(at.has_value());
  const TextureBinding bound = worn(face).material.texture(TextureSlot::Albedo);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(image("face_albedo.png", Qt::green))});
  const QPointF there(viewport()->mapTo(window.get(), *at));
  QDragEnterEvent enter(there.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(there, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &drop);
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(worn(face).material.texture(TextureSlot::Albedo).path.ends_with("face_albedo.png"));
  EXPECT_FALSE(worn(eye).material.texture(TextureSlot::Albedo).path.ends_with("face_albedo.png"));
  EXPECT_EQ(document().currentSlot(), face);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_GT(meanDifference(before, picture()), 1.0F);
  undo().undo();
  EXPECT_EQ(worn(face).material.texture(TextureSlot::Albedo), bound);
  EXPECT_LT(meanDifference(before, picture()), 0.01F);
}

TEST_F(PanelGestures, AFolderOfMapsIsReachedByTheKeyboardAlone) {
  document().setCurrentSlot(face);
  const QImage before = picture();
  image("face_albedo.png", Qt::green);
  image("face_roughness.png", Qt::gray);
  // Menu and dialog have event loops of their own: each is answered by a hand of its own.
  bool typed = false;
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &hand, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    // The window system may take a moment to give it the keyboard.
    if (dialog == nullptr || !dialog->isVisible() || !dialog->isAncestorOf(QApplication::focusWidget())) return;
    hand.stop();
    auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    name->selectAll();
    QTest::keyClicks(name, folder.path());
    typed = true;
    QTest::keyClick(name, Qt::Key_Return);
    if (dialog->isVisible()) QTest::keyClick(name, Qt::Key_Return);
    EXPECT_FALSE(dialog->isVisible());
    if (dialog->isVisible()) dialog->reject();
  });
  QTest::keyClick(window.get(), Qt::Key_F, Qt::AltModifier);  // _F_ile
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  hand.start(100);
  QTest::keyClick(menu, Qt::Key_F);  // Choose a _f_older of maps
  ASSERT_TRUE(QTest::qWaitFor([&] { return typed; }, 10000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return undo().count() == 1; }, 10000));
  EXPECT_TRUE(worn(face).material.texture(TextureSlot::Albedo).present());
  EXPECT_TRUE(worn(face).material.texture(TextureSlot::Roughness).present());
  EXPECT_GT(meanDifference(before, picture()), 1.0F);
  undo().undo();
  EXPECT_LT(meanDifference(before, picture()), 0.01F);
}

TEST_F(PanelGestures, TurningAnEnvironmentReadsNoFileAndBakesNothing) {
  EnvironmentSource source;
  source.builtin.clear();
  source.path = write(folder, "sky.hdr", flatHdr(200, 100, 50));
  window->loading().setEnvironment(source);
  ASSERT_TRUE(waitIdle());
  picture();
  undo().clear();
  const RenderStatistics before = viewport()->statistics();
  const auto images = document().environmentImages();
  // Whoever reads it now says that it is missing.
  ASSERT_TRUE(QFile::remove(folder.filePath(QStringLiteral("sky.hdr"))));
  window->messageBar()->hide();
  drag(viewport(), viewport()->rect().center(), 100, Qt::ShiftModifier, Qt::RightButton);
  picture();
  EXPECT_NE(document().scene().environment.rotationDegrees, 0.0F);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(document().environmentImages(), images);
  EXPECT_FALSE(window->tasks().busy());
  EXPECT_FALSE(window->messageBar()->isVisible());
  const RenderStatistics after = viewport()->statistics();
  EXPECT_EQ(after.environmentsBaked, before.environmentsBaked);
  EXPECT_EQ(after.environmentsFromCache, before.environmentsFromCache);
  EXPECT_EQ(after.texturesUploaded, before.texturesUploaded);
  EXPECT_GT(after.frames, before.frames);
}

TEST_F(PanelGestures, ARigThatIsCancelledWhileItIsBakedIsBakedAgain) {
  EnvironmentSource source;
  source.builtin = "studio";
  window->loading().setEnvironment(source);
  ASSERT_TRUE(waitIdle());
  const QImage before = picture();
  undo().clear();
  RigEdit& edit = window->viewTools()->rig();
  ASSERT_NE(edit.rig(), nullptr);
  const auto images = document().environmentImages();
  RigElement next = edit.rig()->elements.at(0);
  next.enabled = false;
  edit.setElement(0, next, QStringLiteral("Switch a light"), newGesture());
  ASSERT_TRUE(window->tasks().busy(QStringLiteral("rig")));
  find<QToolButton>(QStringLiteral("status.cancel"))->click();
  EXPECT_EQ(document().environmentImages(), images);
  // What was cancelled was the work, not the change: the light follows the rig.
  EXPECT_EQ(undo().count(), 1);
  EXPECT_FALSE(edit.rig()->elements.at(0).enabled);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return document().environmentImages() != images && !document().environmentImages()->preview; },
      kPatienceMs));
  ASSERT_TRUE(waitIdle());
  EXPECT_GT(meanDifference(before, picture()), 0.5F);
  undo().undo();
  ASSERT_TRUE(waitIdle());
  EXPECT_LT(meanDifference(before, picture()), 0.01F);
}

}  // namespace
}  // namespace dermis
