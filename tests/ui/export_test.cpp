// Pictures out of the editor, and back in.
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QGuiApplication>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

#include "core/base/json_text.h"
#include "core/io/png_writer.h"
#include "core/scene/scene_io.h"
#include "ui/dialogs/screenshot_dialog.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/picture_scenes.h"

namespace dermis {
namespace {

class Exporting : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    if (HasFatalFailure()) return;
    document().setCurrentSlot(QStringLiteral("face"));
  }
  PictureRequest small(const char* name) {
    PictureRequest request;
    if (*name != '\0') request.path = folder.filePath(QString::fromUtf8(name)).toStdString();
    request.size = {64, 48};
    request.samples = 1;
    return request;
  }
  QImage drawn(const PictureRequest& request) {
    window->savePicture(request);
    EXPECT_TRUE(waitIdle());
    return QImage(QString::fromStdString(request.path.string()));
  }
  QTemporaryDir folder;
};

TEST_F(Exporting, ATurntableIsNumberedFramesThatDiffer) {
  PictureRequest request = small("turn.png");
  request.kind = PictureKind::Turntable;
  request.frames = 3;
  window->savePicture(request);
  ASSERT_TRUE(waitIdle());
  const QStringList files = QDir(folder.path()).entryList({QStringLiteral("*.png")});
  EXPECT_EQ(files, QStringList({QStringLiteral("turn_0001.png"), QStringLiteral("turn_0002.png"),
                                QStringLiteral("turn_0003.png")}));
  const QImage first(folder.filePath(QStringLiteral("turn_0001.png")));
  const QImage second(folder.filePath(QStringLiteral("turn_0002.png")));
  EXPECT_EQ(first.size(), QSize(64, 48));
  EXPECT_GT(meanDifference(first, second), 2.0F);
}

TEST_F(Exporting, ASheetHoldsTheReadyMadeViewsAndTheBookmarks) {
  CameraBookmark bookmark{"Mine", document().camera(), {}};
  document().setBookmarks({bookmark}, QStringLiteral("Add bookmark"));
  PictureRequest request = small("sheet.png");
  request.kind = PictureKind::Sheet;
  const QImage sheet = drawn(request);
  // Four views and a bookmark: three columns, two rows, a band of text under each.
  EXPECT_EQ(sheet.width(), 3 * 64);
  EXPECT_GT(sheet.height(), 2 * 48);
  EXPECT_LT(sheet.height(), 2 * 48 + 40);
}

TEST_F(Exporting, APictureGoesToTheClipboard) {
  QGuiApplication::clipboard()->clear();
  window->savePicture(small(""));
  ASSERT_TRUE(waitIdle());
  const QImage copied = QGuiApplication::clipboard()->image();
  EXPECT_EQ(copied.size(), QSize(64, 48));
  EXPECT_GT(contrast(copied), 3.0F);
}

TEST_F(Exporting, TheViewTransformAndTheBallsAreTheRequests) {
  PictureRequest request = small("a.png");
  const QImage plain = drawn(request);
  request.path = folder.filePath(QStringLiteral("b.png")).toStdString();
  request.view = "Raw";
  EXPECT_GT(meanDifference(plain, drawn(request)), 3.0F);
  request.path = folder.filePath(QStringLiteral("c.png")).toStdString();
  request.view.clear();
  request.references.balls = true;
  const QImage balls = drawn(request);
  EXPECT_GT(meanDifference(plain, balls), 0.2F);
  const QRect top(0, 0, 64, 24);
  EXPECT_LT(meanDifference(plain.copy(top), balls.copy(top)), 0.5F);
}

TEST_F(Exporting, TheDialogAsksForWhatTheRequestSays) {
  ReferenceObjects shown;
  shown.chart = true;
  ScreenshotDialog dialog({640, 480}, QStringLiteral("ACES"), shown, window.get());
  const auto child = [&]<class T>(const char* name, T*) { return dialog.findChild<T*>(QLatin1String(name)); };
  child("screenshot.kind", static_cast<QComboBox*>(nullptr))->setCurrentIndex(1);
  child("screenshot.frames", static_cast<QSpinBox*>(nullptr))->setValue(12);
  child("screenshot.references", static_cast<QCheckBox*>(nullptr))->setChecked(true);
  auto* view = child("screenshot.view", static_cast<QComboBox*>(nullptr));
  view->setCurrentIndex(view->findText(QStringLiteral("Raw")));
  EXPECT_FALSE(child("screenshot.copy", static_cast<QPushButton*>(nullptr))->isEnabled());
  const PictureRequest turntable = dialog.request();
  EXPECT_EQ(turntable.kind, PictureKind::Turntable);
  EXPECT_EQ(turntable.frames, 12);
  EXPECT_EQ(turntable.view, "Raw");
  EXPECT_TRUE(turntable.references.chart);
  EXPECT_EQ(turntable.size, glm::ivec2(640, 480));
  child("screenshot.kind", static_cast<QComboBox*>(nullptr))->setCurrentIndex(0);
  child("screenshot.copy", static_cast<QPushButton*>(nullptr))->click();
  EXPECT_TRUE(dialog.request().path.empty());
}

TEST_F(Exporting, APictureDroppedOnTheWindowOffersItsScene) {
  // What the program's own pictures carry.
  Scene scene = document().sceneForSaving();
  scene.environment.builtin = "overcast";
  scene.view.exposureStops = 1.5F;
  Json json;
  json["program"] = "dermis";
  json["scene"] = Json::parse(writeScene(scene, {}));
  Image image;
  image.width = image.height = 4;
  image.channels = 4;
  image.pixels.resize(64);
  const std::string path = folder.filePath(QStringLiteral("remembers.png")).toStdString();
  ASSERT_TRUE(writePng(path, image, {{"dermis", json.dump()}}).has_value());
  EXPECT_FALSE(sceneTextOfPicture(path).empty());

  // The question has an event loop of its own: who answers must not wait in one that it interrupts.
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, &answer, [&answer] {
    const QWidget* question = QApplication::activeModalWidget();
    if (question == nullptr) return;
    auto* open = question->findChild<QPushButton*>(QStringLiteral("pictureScene.open"));
    ASSERT_NE(open, nullptr);
    answer.stop();
    open->click();
  });
  answer.start(20);
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(QString::fromStdString(path))});
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);
  QDropEvent drop(QPointF(100.0, 100.0), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &drop);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().scene().view.exposureStops == 1.5F; }, kPatienceMs))
      << window->messageBar()->message().toStdString();
  EXPECT_EQ(document().scene().environment.builtin, "overcast");
  EXPECT_TRUE(document().path().empty());

  const std::string plain = folder.filePath(QStringLiteral("plain.png")).toStdString();
  ASSERT_TRUE(writePng(plain, image, {}).has_value());
  EXPECT_TRUE(sceneTextOfPicture(plain).empty());
}

}  // namespace
}  // namespace dermis
