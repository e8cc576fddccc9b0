// Opening, saving, bad files, environments, maps and pictures through the window.
#include <QAbstractButton>
#include <QComboBox>
#include <QListWidget>
#include <QMessageBox>
#include <QTimer>

#include "core/material/preset_io.h"
#include "ui/editor_fixture.h"
#include "ui/jobs/time_left.h"

namespace dermis {
namespace {

class Files : public Editor {
 protected:
  QTemporaryDir folder;

  std::string model(const char* name, const std::string& slot, float size) {
    write(folder, "triangle.mtl", "newmtl " + slot + "\nKd 0.2 0.4 0.8\n");
    return write(folder, name, "mtllib triangle.mtl\n" + triangleObj(slot, size));
  }
  void open(const std::string& path) {
    window->openFile(QString::fromStdString(path));
    ASSERT_TRUE(waitIdle());
  }
};

TEST_F(Files, SwappingTheEnvironmentChangesThePictureAndCanBeUndone) {
  const QImage before = picture();
  auto* list = find<QListWidget>(QStringLiteral("environment.list"));
  reveal(list);
  ASSERT_GE(list->count(), 3);
  Q_EMIT list->itemClicked(list->item(2));
  ASSERT_TRUE(QTest::qWaitFor([this] { return undo().count() == 1; }, kPatienceMs));
  EXPECT_GT(meanDifference(before, picture()), 0.5F);
  undo().undo();
  EXPECT_LT(meanDifference(before, picture()), 0.1F);
}

TEST_F(Files, AnEnvironmentFileIsDecodedBesideTheEventLoop) {
  open(write(folder, "flat.hdr", flatHdr(200, 100, 50)));
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(document().scene().environment.path.ends_with("flat.hdr"));
  EXPECT_TRUE(document().scene().environment.builtin.empty());
}

TEST_F(Files, ALightRigIsAnEnvironmentThoughItEndsLikeAPreset) {
  open(write(folder, "mine.json",
             R"({"format": "dermis.rig", "version": 1, "width": 64, "elements": [{"type": "dome"}]})"));
  EXPECT_EQ(undo().count(), 1);
  EXPECT_TRUE(document().scene().environment.path.ends_with("mine.json"));
  EXPECT_EQ(document().environmentImages()->latLong->width, 64);
}

TEST_F(Files, OpeningAModelKeepsSlotsOfTheSameNameAndDressesTheOthers) {
  document().setParameter(QStringLiteral("face"), "subsurface.scale", 3.0F, newGesture());
  const float distance = glm::length(document().camera().position - document().camera().target);
  const float radius = document().model()->bounds.radius();
  open(model("head.obj", "face", 2.0F));
  ASSERT_EQ(document().slotNames(), QStringList{QStringLiteral("face")});
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 3.0F);
  // The camera comes along by the ratio of the bounds.
  const float ratio = document().model()->bounds.radius() / radius;
  EXPECT_NEAR(glm::length(document().camera().position - document().camera().target), ratio * distance,
              1e-3F * ratio * distance);

  open(model("other.obj", "plastic", 2.0F));
  ASSERT_EQ(document().slotNames(), QStringList{QStringLiteral("plastic")});
  EXPECT_EQ(document().currentLook()->worn.material.model, ShadingModel::MetallicRoughness);

  // And going back, also by another way than undo.
  open(folder.filePath(QStringLiteral("head.obj")).toStdString());
  undo().undo();
  undo().undo();
  EXPECT_EQ(document().slotNames(), QStringList{QStringLiteral("face")});
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 3.0F);
  undo().undo();
  EXPECT_EQ(document().slotNames().size(), 4);
}

TEST_F(Files, BadFilesLeaveEverythingAsItWasAndSaySo) {
  const Scene before = document().scene();
  const auto* model = document().model().get();
  const std::string files[] = {
      write(folder, "broken.glb", "glTF but not really"),
      write(folder, "empty.obj", ""),
      write(folder, "future.json", R"({"format": "dermis.material", "version": 99, "model": "skin"})"),
      write(folder, "broken.dermis", "{\"format\": \"dermis.scene\", \"version\": 1, \"lights\": 3}"),
      write(folder, "short.hdr", "#?RADIANCE\n\n-Y 4000 +X 8000\nab"),
      folder.filePath(QStringLiteral("missing.obj")).toStdString(),
      write(folder, "letter.txt", "Dear editor"),
  };
  for (const std::string& file : files) {
    window->messageBar()->hide();
    open(file);
    EXPECT_FALSE(window->messageBar()->message().isEmpty()) << file;
    EXPECT_TRUE(window->messageBar()->message().contains(
        QString::fromStdString(std::filesystem::path(file).filename().string())))
        << file << ": " << window->messageBar()->message().toStdString();
    EXPECT_EQ(document().scene(), before) << file;
    EXPECT_EQ(document().model().get(), model) << file;
    EXPECT_EQ(undo().count(), 0) << file;
  }
}

TEST_F(Files, ASceneSavedAndOpenedIsTheSameScene) {
  document().setParameter(document().currentSlot(), "subsurface.scale", 2.0F, newGesture());
  document().addLight(Light{});
  EXPECT_TRUE(document().isModified());
  const std::string path = folder.filePath(QStringLiteral("look.dermis")).toStdString();
  ASSERT_TRUE(window->loading().saveScene(path));
  EXPECT_FALSE(document().isModified());
  EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("look.dermis")));
  const Scene saved = document().sceneForSaving();
  open(path);
  const Scene opened = document().sceneForSaving();
  EXPECT_EQ(opened.lights, saved.lights);
  EXPECT_EQ(writePreset(opened.materials.at("face").material, {}),
            writePreset(saved.materials.at("face").material, {}));
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(Files, SavingWhereNothingCanBeWrittenSaysSo) {
  document().addLight(Light{});
  EXPECT_FALSE(window->loading().saveScene("/proc/nowhere/look.dermis"));
  EXPECT_FALSE(window->messageBar()->message().isEmpty());
  EXPECT_TRUE(document().isModified());
}

TEST_F(Files, APresetIsAppliedAsOneEntryAndKnowsThatItWasEdited) {
  Material material;
  material.name = "Test skin";
  material.parameters.subsurfaceScale = 1.75F;
  const std::string path = folder.filePath(QStringLiteral("test.json")).toStdString();
  ASSERT_TRUE(savePreset(path, material));
  open(path);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 1.75F);
  EXPECT_FALSE(document().currentLook()->binding->edited);
  document().setParameter(document().currentSlot(), "specular.lobe_mix", 0.2F, newGesture());
  EXPECT_TRUE(document().currentLook()->binding->edited);
  undo().undo();
  EXPECT_FALSE(document().currentLook()->binding->edited);
  undo().undo();
  EXPECT_EQ(document().scene().materials.at("face").presetPath, "");
}

TEST_F(Files, AMapOnAnUntouchedValueSetsItToOneInTheSameStep) {
  // The default look wears maps already.
  window->loading().openModel(ModelSource{{}, "sphere", {}, std::nullopt});
  ASSERT_TRUE(waitIdle());
  undo().clear();
  QImage(8, 8, QImage::Format_RGB888).save(folder.filePath(QStringLiteral("albedo.png")));
  const Colour before = document().currentLook()->worn.material.parameters.baseAlbedo;
  document().setParameter(document().currentSlot(), "base.albedo", MaterialParameters{}.baseAlbedo, newGesture());
  const int entries = undo().count();
  window->loading().assignTexture({document().currentSlot()}, TextureSlot::Albedo,
                                  folder.filePath(QStringLiteral("albedo.png")).toStdString());
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_EQ(document().currentLook()->worn.material.parameters.baseAlbedo, Colour{glm::vec3(1.0F)});
  EXPECT_NE(document().currentLook()->worn.images[0], nullptr);
  undo().undo();
  EXPECT_EQ(document().currentLook()->worn.images[0], nullptr);
  while (undo().canUndo()) undo().undo();
  EXPECT_EQ(document().currentLook()->worn.material.parameters.baseAlbedo, before);
}

TEST_F(Files, ClosingWithUnsavedChangesAsks) {
  document().addLight(Light{});
  const auto answer = [](QMessageBox::StandardButton button) {
    QTimer::singleShot(200, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      box->button(button)->click();
    });
  };
  answer(QMessageBox::Cancel);
  EXPECT_FALSE(window->close());
  answer(QMessageBox::Discard);
  EXPECT_TRUE(window->close());
}

TEST_F(Files, APictureIsDrawnBesideTheEditor) {
  PictureRequest request;
  request.path = folder.filePath(QStringLiteral("picture.png")).toStdString();
  request.size = {96, 64};
  request.samples = 2;
  request.transparent = true;
  window->savePicture(request);
  ASSERT_TRUE(waitIdle());
  const QImage saved(QString::fromStdString(request.path.string()));
  ASSERT_EQ(saved.size(), QSize(96, 64)) << window->messageBar()->message().toStdString();
  EXPECT_EQ(qAlpha(saved.pixel(2, 2)), 0);
  EXPECT_EQ(qAlpha(saved.pixel(48, 32)), 255);
}

TEST(TimeLeftText, IsGuessedFromWhatWasSeenAndStartsAnewWithOtherWork) {
  TimeLeft left;
  EXPECT_TRUE(left.text().isEmpty());
  left.update(QStringLiteral("bake"), 0.2, 100.0);
  EXPECT_TRUE(left.text().isEmpty());
  left.update(QStringLiteral("bake"), 0.3, 104.0);  // a tenth in 4 s: 28 s for the rest
  EXPECT_TRUE(left.text().contains(QStringLiteral("30 s"))) << left.text().toStdString();
  left.update(QStringLiteral("bake"), 0.9, 128.0);
  EXPECT_TRUE(left.text().contains(QStringLiteral("4 s"))) << left.text().toStdString();
  left.update(QStringLiteral("picture"), 0.1, 129.0);
  EXPECT_TRUE(left.text().isEmpty());
  left.update(QStringLiteral("picture"), 0.15, 139.0);
  EXPECT_TRUE(left.text().contains(QStringLiteral("3 min"))) << left.text().toStdString();
  left.clear();
  EXPECT_TRUE(left.text().isEmpty());
}

}  // namespace
}  // namespace dermis
