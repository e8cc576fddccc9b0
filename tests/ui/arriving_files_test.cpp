// What arrives from outside: files of the command line, dropped files, values pasted into the docks; and the lights'
// list.
#include <QAccessible>
#include <QClipboard>
#include <QListWidget>
#include <QMimeData>

#include "ui/editor_fixture.h"
#include "ui/main_window/dropped_files.h"
#include "ui/main_window/view_tools.h"
#include "ui/viewport/camera_history.h"

namespace dermis {
namespace {

class Arriving : public Editor {
 protected:
  QTemporaryDir folder;
  QString in(const char* name) const { return folder.filePath(QString::fromUtf8(name)); }
  void map(const char* name) const { QImage(8, 8, QImage::Format_RGB888).save(in(name)); }
  void drop(const QStringList& paths) {
    QMimeData mime;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    mime.setUrls(urls);
    const QPointF beside(3.0, 3.0);
    QDragEnterEvent enter(beside.toPoint(), Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(beside, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.get(), &event);
    ASSERT_TRUE(waitIdle());
  }
  void paste(const char* id, const char* text) {
    QApplication::clipboard()->setText(QString::fromUtf8(text));
    find<PropertyRow>(QString::fromLatin1(id))->paste();
  }
};

TEST_F(Arriving, AModelOfTheCommandLineIsAskedAboutAndRemembered) {
  const std::string path = write(folder, "triangle.obj", triangleObj("face", 2.0F));
  QSignalSpy opened(&window->loading(), &Loading::modelOpened);
  QSignalSpy used(&window->loading(), &Loading::fileUsed);
  window->open({path});
  ASSERT_TRUE(waitIdle());
  ASSERT_EQ(opened.size(), 1);
  EXPECT_EQ(opened[0][0].toString(), QStringLiteral("triangle.obj"));
  ASSERT_EQ(used.size(), 1);
  EXPECT_EQ(used[0][0].toString().toStdString(), path);
  EXPECT_TRUE(find<QWidget>(QStringLiteral("modelUnit"))->isVisible());
}

TEST_F(Arriving, BookmarksAndTheWayBackComeAlongToAnotherModel) {
  CameraHistory& history = window->viewTools()->cameraHistory();
  history.note();
  const Camera first = document().camera();
  document().setBookmarks({CameraBookmark{"Mine", first, {}}}, QStringLiteral("Add bookmark"));
  Camera second = first;
  second.position.x += 0.1F;
  document().setCamera(second);
  history.note();
  const Bounds before = document().model()->bounds;
  window->openFile(QString::fromStdString(write(folder, "big.obj", triangleObj("face", 50.0F))));
  ASSERT_TRUE(waitIdle());
  const Bounds after = document().model()->bounds;
  const float s = after.radius() / before.radius();
  const glm::vec3 expected = after.centre() + s * (first.position - before.centre());
  ASSERT_EQ(document().scene().bookmarks.size(), 1U);
  EXPECT_NEAR(glm::distance(document().scene().bookmarks[0].camera.position, expected), 0.0F, 1e-4F * s);
  history.back();
  EXPECT_NEAR(glm::distance(document().camera().position, expected), 0.0F, 1e-4F * s);
  undo().undo();
  EXPECT_EQ(document().scene().bookmarks[0].camera, first);
  history.forward();
  history.back();
  EXPECT_NEAR(glm::distance(document().camera().position, first.position), 0.0F, 1e-4F);
}

TEST_F(Arriving, DroppedMapsAreBoundByTheirNames) {
  for (const char* name : {"face_albedo.png", "face_normal.png", "panorama.png", "street.png"}) map(name);
  const std::vector<std::string> slots = {"face", "eye"};
  DropPlan plan =
      planDrop({in("face_albedo.png"), in("face_normal.png"), in("panorama.png"), in("street.png")}, "face", slots);
  EXPECT_EQ(plan.maps.size(), 2U);
  EXPECT_EQ(plan.pictures, QStringList{in("panorama.png")});
  EXPECT_EQ(plan.leftOut, QStringList{in("street.png")});
  plan = planDrop({in("a.dermis"), in("face_albedo.png"), in("b.obj"), in("c.hdr"), in("d.dermis")}, "face", slots);
  EXPECT_EQ(plan.open, QStringList{in("a.dermis")});
  EXPECT_TRUE(plan.maps.empty());
  EXPECT_EQ(plan.leftOut.size(), 4);
  plan = planDrop({in("b.obj"), in("c.hdr")}, "face", slots);
  EXPECT_EQ(plan.open, (QStringList{in("b.obj"), in("c.hdr")}));

  const std::string environment = document().scene().environment.builtin;
  document().setCurrentSlot(QStringLiteral("face"));
  drop({in("face_albedo.png"), in("face_normal.png")});
  EXPECT_EQ(document().scene().environment.builtin, environment);
  const Material& face = document().slotLook(QStringLiteral("face"))->worn.material;
  EXPECT_TRUE(face.texture(TextureSlot::Albedo).path.ends_with("face_albedo.png"));
  EXPECT_TRUE(face.texture(TextureSlot::Normal).path.ends_with("face_normal.png"));
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(Arriving, AFolderAModelAndAPanoramaAreDroppedOnTheWindow) {
  const QTemporaryDir maps;
  QImage(8, 8, QImage::Format_RGB888).save(maps.filePath(QStringLiteral("face_roughness.png")));
  document().setCurrentSlot(QStringLiteral("face"));
  drop({maps.path()});
  const Material& face = document().slotLook(QStringLiteral("face"))->worn.material;
  EXPECT_TRUE(face.texture(TextureSlot::Roughness).path.ends_with("face_roughness.png"));
  const std::string model = write(folder, "triangle.obj", triangleObj("face", 2.0F));
  const std::string panorama = write(folder, "flat.hdr", flatHdr(200, 100, 50));
  drop({QString::fromStdString(model), QString::fromStdString(panorama)});
  EXPECT_EQ(document().scene().model.path, model);
  EXPECT_EQ(document().scene().environment.path, panorama);
  EXPECT_EQ(document().slotNames(), QStringList{QStringLiteral("face")});
}

TEST_F(Arriving, WhatIsPastedIntoADockStaysInItsRange) {
  paste("camera.vertical_fov_degrees", "200");
  EXPECT_FLOAT_EQ(document().camera().verticalFovDegrees, 150.0F);
  paste("camera.vertical_fov_degrees", "0");
  EXPECT_FLOAT_EQ(document().camera().verticalFovDegrees, 1.0F);
  paste("camera.vertical_fov_degrees", "0.5 rad");
  EXPECT_NEAR(document().camera().verticalFovDegrees, 28.648F, 1e-2F);
  paste("environment.exposure_stops", "99");
  EXPECT_FLOAT_EQ(document().scene().environment.exposureStops, 20.0F);
  document().addLight(Light{});
  paste("light.radius_mm", "1.2 cm");
  EXPECT_FLOAT_EQ(document().scene().lights[0].radiusMm, 12.0F);
  paste("light.intensity", "-3");
  EXPECT_FLOAT_EQ(document().scene().lights[0].intensity, 0.0F);
  paste("light.position", "1, 2, 1e9");
  EXPECT_EQ(document().scene().lights[0].position, glm::vec3(1.0F, 2.0F, 1e6F));
  const int entries = undo().count();
  window->messageBar()->hide();
  paste("light.radius_mm", "wet");
  EXPECT_TRUE(window->messageBar()->isVisible());
  EXPECT_EQ(undo().count(), entries);
  // A choice is copied from one light to another.
  Light sphere;
  sphere.type = LightType::Sphere;
  document().setLight(0, sphere, QStringLiteral("Type"), newGesture());
  find<PropertyRow>(QStringLiteral("light.type"))->copy();
  document().setLight(0, Light{}, QStringLiteral("Type"), newGesture());
  find<PropertyRow>(QStringLiteral("light.type"))->paste();
  EXPECT_EQ(document().scene().lights[0].type, LightType::Sphere);
}

TEST_F(Arriving, LightsAreRenamedAndDuplicatedInTheirList) {
  document().addLight(Light{});
  auto* list = find<QListWidget>(QStringLiteral("lights.list"));
  reveal(list);
  list->setCurrentRow(0);
  list->item(0)->setText(QStringLiteral("  Key "));
  EXPECT_EQ(document().scene().lights[0].name, "Key");
  EXPECT_EQ(list->item(0)->text(), QStringLiteral("Key"));
  EXPECT_EQ(undo().count(), 2);
  find<QAbstractButton>(QStringLiteral("lights.duplicate"))->click();
  ASSERT_EQ(document().scene().lights.size(), 2U);
  EXPECT_EQ(document().scene().lights[1].name, "Key copy");
  EXPECT_EQ(list->currentRow(), 1);
  EXPECT_EQ(undo().count(), 3);
  // Without a name it is called by its kind and number again.
  list->item(1)->setText(QString());
  EXPECT_TRUE(document().scene().lights[1].name.empty());
  EXPECT_FALSE(list->item(1)->text().isEmpty());
}

TEST_F(Arriving, AnErrorIsAnAlertForAssistiveTechnology) {
  const QString sentence = QStringLiteral("head.glb cannot be read");
  Q_EMIT window->loading().message(MessageKind::Error, sentence);
  QAccessibleInterface* bar = QAccessible::queryAccessibleInterface(window->messageBar());
  ASSERT_NE(bar, nullptr);
  EXPECT_EQ(bar->role(), QAccessible::AlertMessage);
  EXPECT_EQ(bar->text(QAccessible::Name), sentence);
  EXPECT_FALSE(bar->state().invisible);
}

}  // namespace
}  // namespace dermis
