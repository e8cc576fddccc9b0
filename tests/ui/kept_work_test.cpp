// Nothing is lost: unsaved work when a window goes, files that are there already, edits made while something loads.
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <new>

#include "core/builtin/default_look.h"
#include "core/scene/scene_io.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/dialogs/screenshot_dialog.h"
#include "ui/document/autosave.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

class KeptWork : public Editor {
 protected:
  QTemporaryDir folder;
  QString in(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
  static std::string contentOf(const QString& path) {
    std::ifstream file(path.toStdString(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Answers one dialog after another: `steps` says whether it has answered the one that is up.
  void answer(std::vector<std::function<bool(QWidget*)>> steps) {
    auto* hand = new QTimer(window.get());
    QObject::connect(hand, &QTimer::timeout, [hand, left = std::move(steps), next = std::size_t{0}]() mutable {
      QWidget* dialog = QApplication::activeModalWidget();
      if (dialog == nullptr || !dialog->isVisible() || next >= left.size()) return;
      const auto step = left[next++];
      if (next == left.size()) hand->deleteLater();
      if (!step(dialog)) --next;
    });
    hand->start(30);
  }
  static std::function<bool(QWidget*)> choosing(const QString& path) {
    return [path](QWidget* up) {
      auto* dialog = qobject_cast<QFileDialog*>(up);
      if (dialog == nullptr) return false;
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(path);
      QMetaObject::invokeMethod(dialog, "accept");
      return true;
    };
  }
  static std::function<bool(QWidget*)> pressing(QMessageBox::StandardButton button) {
    return [button](QWidget* up) {
      auto* box = qobject_cast<QMessageBox*>(up);
      if (box == nullptr) return false;
      box->button(button)->click();
      return true;
    };
  }
};

TEST(AutosaveTeardown, ADocumentThatGoesLeavesItsUnsavedWorkOnDisk) {
  const QTemporaryDir folder;
  auto document = std::make_unique<Document>();
  Autosave autosave(*document, folder.path().toStdString());
  autosave.setIntervalMs(5);
  QSignalSpy written(&autosave, &Autosave::written);
  document->addLight(Light{});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !written.isEmpty(); }, kPatienceMs));
  const fs::path file = autosave.file();
  document.reset();
  EXPECT_TRUE(fs::exists(file));
}

TEST(TaskRunnerThrows, WhatIsThrownBecomesASentence) {
  TaskRunner tasks;
  QSignalSpy told(&tasks, &TaskRunner::problem);
  bool done = false, broken = false;
  tasks.run(
      QStringLiteral("a"), QStringLiteral("Opening head.glb"), [](std::stop_token) -> int { throw std::bad_alloc(); },
      [&](int) { done = true; }, [&] { broken = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !told.isEmpty(); }, kPatienceMs));
  EXPECT_TRUE(told[0][0].toString().contains(QStringLiteral("head.glb")));
  EXPECT_TRUE(told[0][0].toString().contains(QStringLiteral("memory")));
  EXPECT_FALSE(done);
  EXPECT_TRUE(broken);
  EXPECT_FALSE(tasks.busy());
}

TEST(StartCancelled, ThereIsALookAllTheSame) {
  Document document;
  TaskRunner tasks;
  Loading loading(document, tasks);
  loading.openAtStart({});
  loading.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return document.isReady(); }, kPatienceMs));
  // And where what replaced the start cannot be opened.
  Document second;
  Loading other(second, tasks);
  other.openAtStart({});
  other.openScene("/nowhere/look.dermis");
  EXPECT_TRUE(QTest::qWaitFor([&] { return second.isReady(); }, kPatienceMs));
}

TEST_F(KeptWork, APresetThatCannotEvenBeLookedForIsWrittenIntoTheScene) {
  // The name is longer than a file system takes: asking about it is an error of its own.
  const std::string path = in((std::string(300, 'x') + ".json").c_str()).toStdString();
  document().applyMaterial({QStringLiteral("face")}, document().slotLook(QStringLiteral("face"))->worn, path);
  EXPECT_TRUE(document().sceneForSaving().materials.at("face").edited);
}

TEST_F(KeptWork, ANameThatGetsItsEndingLaterIsAskedAboutWithIt) {
  write(folder, "head.dermis", "precious");
  answer({choosing(in("head")), pressing(QMessageBox::Cancel), choosing(in("look 1.5"))});
  EXPECT_TRUE(window->fileActions()->saveAs());
  EXPECT_EQ(contentOf(in("head.dermis")), "precious");
  EXPECT_EQ(document().path(), fs::path(in("look 1.5.dermis").toStdString()));
  Warnings warnings;
  EXPECT_TRUE(loadScene(document().path(), warnings).has_value());
  EXPECT_EQ(withEnding(QStringLiteral("a.JSON"), {QStringLiteral("json")}), QStringLiteral("a.JSON"));
}

TEST_F(KeptWork, ThePictureBeforeIsNotWrittenOver) {
  QSettings().setValue(QStringLiteral("folders/pictures"), folder.path());
  write(folder, "dermis.png", "precious");
  ScreenshotDialog dialog({64, 48}, QStringLiteral("ACES"), {}, window.get());
  auto* path = dialog.findChild<QLineEdit*>(QStringLiteral("screenshot.path"));
  EXPECT_EQ(path->text(), in("dermis 2.png"));
  path->setText(in("dermis.png"));
  answer({pressing(QMessageBox::Cancel)});
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  answer({[](QWidget* up) {
    auto* replace = up->findChild<QPushButton*>(QStringLiteral("writeOver.replace"));
    if (replace != nullptr) replace->click();
    return replace != nullptr;
  }});
  dialog.accept();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  path->setText(in("free.png"));
  dialog.setResult(QDialog::Rejected);
  dialog.accept();  // nobody is asked
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(KeptWork, WhatIsEditedWhileASceneLoadsIsAskedAbout) {
  ASSERT_TRUE(saveScene(in("other.dermis").toStdString(), defaultLook()));
  window->openFile(in("other.dermis"));
  document().addLight(Light{});
  const std::size_t lights = document().scene().lights.size();
  answer({pressing(QMessageBox::Cancel)});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().scene().lights.size(), lights);
  EXPECT_TRUE(document().path().empty());
  answer({pressing(QMessageBox::Discard), pressing(QMessageBox::Discard)});
  window->openFile(in("other.dermis"));
  document().addLight(Light{});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().path(), fs::path(in("other.dermis").toStdString()));
}

TEST_F(KeptWork, TurningTheEnvironmentWhileAnotherLoadsIsKept) {
  window->openFile(QString::fromStdString(write(folder, "flat.hdr", flatHdr(200, 100, 50))));
  EnvironmentSource turned = document().scene().environment;
  turned.rotationDegrees = 42.0F;
  turned.exposureStops = 1.5F;
  document().setEnvironmentSettings(turned, QStringLiteral("Rotate"), newGesture());
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(document().scene().environment.path.ends_with("flat.hdr"));
  EXPECT_FLOAT_EQ(document().scene().environment.rotationDegrees, 42.0F);
  EXPECT_FLOAT_EQ(document().scene().environment.exposureStops, 1.5F);
}

TEST_F(KeptWork, AMapSettingChangedWhileTheMapLoadsIsKept) {
  const QString face = QStringLiteral("face");
  QImage(8, 8, QImage::Format_RGB888).save(in("skin.png"));
  window->loading().assignTexture({face}, TextureSlot::Normal, in("skin.png").toStdString());
  TextureBinding flipped = document().slotLook(face)->worn.material.texture(TextureSlot::Normal);
  flipped.flipGreen = !flipped.flipGreen;
  document().setTexture(face, TextureSlot::Normal, flipped, nullptr, newGesture());
  ASSERT_TRUE(waitIdle());
  const TextureBinding& now = document().slotLook(face)->worn.material.texture(TextureSlot::Normal);
  EXPECT_TRUE(now.path.ends_with("skin.png"));
  EXPECT_EQ(now.flipGreen, flipped.flipGreen);
}

TEST_F(KeptWork, TwoPicturesAreDrawnOneAfterTheOther) {
  for (const char* name : {"first.png", "second.png", "third.png"}) {
    PictureRequest request;
    request.path = in(name).toStdString();
    request.size = {32, 24};
    request.samples = 1;
    window->savePicture(request);
  }
  ASSERT_TRUE(waitIdle());
  for (const char* name : {"first.png", "second.png", "third.png"}) EXPECT_EQ(QImage(in(name)).width(), 32) << name;
}

TEST_F(KeptWork, CancelForgetsThePicturesThatWait) {
  PictureRequest request;
  request.size = {32, 24};
  request.samples = 1;
  for (const char* name : {"first.png", "second.png"}) {
    request.path = in(name).toStdString();
    window->savePicture(request);
  }
  find<QAbstractButton>(QStringLiteral("status.cancel"))->click();
  ASSERT_TRUE(waitIdle());
  QTest::qWait(50);
  EXPECT_FALSE(window->tasks().busy());
  EXPECT_FALSE(QFile::exists(in("second.png")));
  request.path = in("third.png").toStdString();
  window->savePicture(request);
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(QFile::exists(in("third.png")));
}

TEST_F(KeptWork, APicturesSceneAndARecoveredOneKeepTheirCameras) {
  Scene scene = document().sceneForSaving();
  scene.camera->position = {0.3F, 0.2F, 1.7F};
  scene.camera->target = {0.1F, 0.0F, 0.2F};
  window->loading().openPictureScene(in("a.png").toStdString(), writeScene(scene, {}));
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().camera().position, scene.camera->position);
  EXPECT_EQ(document().camera().target, scene.camera->target);
  scene.camera->position = {0.0F, 0.5F, 2.0F};
  window->loading().openUnsaved(scene, {}, [] {});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().camera().position, scene.camera->position);
}

}  // namespace
}  // namespace dermis
