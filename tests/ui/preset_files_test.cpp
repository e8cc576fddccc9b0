// Presets whose files are written, renamed, thrown away or gone: what slots, undo entries and scenes say of them.
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QTimer>

#include "core/material/preset_io.h"
#include "core/material/preset_tags.h"
#include "core/scene/scene_io.h"
#include "ui/browse/preset_list.h"
#include "ui/docks/presets_panel.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

class PresetFiles : public Editor {
 protected:
  const QString face = QStringLiteral("face"), eye = QStringLiteral("eye");
  void SetUp() override {
    Editor::SetUp();
    if (HasFatalFailure()) return;
    panel = window->findChild<PresetsPanel*>();
    document().setCurrentSlot(face);
    fair = save("Fair", 1.5F);
  }
  void TearDown() override {
    for (const QString& name : QDir(userPresetFolder()).entryList(QDir::Files))
      QFile::remove(userPresetFolder() + QLatin1Char('/') + name);
    readAgain();
  }
  void readAgain() {
    panel->library().refresh();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !panel->library().isReading(); }, kPatienceMs));
  }
  QString save(const char* name, float scale) {
    Material material;
    material.name = name;
    material.parameters.subsurfaceScale = scale;
    const QString path = userPresetFolder() + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".json");
    EXPECT_TRUE(savePreset(path.toStdString(), material));
    readAgain();
    return path;
  }
  void wear(const QString& path, const QStringList& slots_) {
    panel->apply(path, slots_);
    ASSERT_TRUE(waitIdle());
  }
  void select(const QString& path) {
    auto* list = find<QListWidget>(QStringLiteral("presets.list"));
    for (int i = 0; i < list->count(); ++i)
      if (list->item(i)->data(PresetList::kPathRole).toString() == path) list->setCurrentRow(i);
  }
  float scaleOf(const QString& slot) { return document().slotLook(slot)->worn.material.parameters.subsurfaceScale; }
  const MaterialBinding& bindingOf(const QString& slot) { return *document().slotLook(slot)->binding; }

  PresetsPanel* panel = nullptr;
  QString fair;
};

TEST_F(PresetFiles, AnUpdatedPresetIsAnotherOneForUndoEntriesAndOtherSlots) {
  wear(fair, {face});
  wear(fair, {eye});
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("look.dermis")).toStdString();
  ASSERT_TRUE(window->loading().saveScene(file));
  document().setParameter(face, "subsurface.scale", 3.0F, newGesture());
  ASSERT_TRUE(window->loading().savePreset(face, fair.toStdString()));
  EXPECT_FALSE(bindingOf(face).edited);
  EXPECT_TRUE(bindingOf(eye).edited);
  undo().undo();
  EXPECT_TRUE(bindingOf(face).edited);
  // The stack is where it was saved, but the file shows another look by now.
  EXPECT_TRUE(document().isModified());
  ASSERT_TRUE(window->loading().saveScene(file));
  window->openFile(QString::fromStdString(file.string()));
  ASSERT_TRUE(waitIdle());
  EXPECT_FLOAT_EQ(scaleOf(face), 1.5F);
  EXPECT_FLOAT_EQ(scaleOf(eye), 1.5F);
}

TEST_F(PresetFiles, SlotsAndUndoEntriesFollowARenamedPreset) {
  wear(fair, {face});
  document().setParameter(face, "subsurface.scale", 2.0F, newGesture());
  select(fair);
  panel->renameSelected(QStringLiteral("Pale"));
  const std::string pale = (userPresetFolder() + QStringLiteral("/Pale.json")).toStdString();
  EXPECT_EQ(bindingOf(face).presetPath, pale);
  undo().undo();
  EXPECT_EQ(bindingOf(face).presetPath, pale);
  EXPECT_FALSE(bindingOf(face).edited);
  EXPECT_EQ(document().slotLook(face)->worn.material.name, "Pale");
  EXPECT_EQ(document().sceneForSaving().materials.at("face").presetPath, pale);
  undo().redo();
  window->fileActions()->savePreset();  // "Update preset"
  EXPECT_EQ(QDir(userPresetFolder()).entryList(QDir::Files), QStringList{QStringLiteral("Pale.json")});
  Warnings warnings;
  EXPECT_FLOAT_EQ(loadPreset(pale, warnings)->parameters.subsurfaceScale, 2.0F);
  // There and back again, and to the name it has.
  select(QString::fromStdString(pale));
  panel->renameSelected(QStringLiteral("Fair"));
  EXPECT_EQ(bindingOf(face).presetPath, fair.toStdString());
  select(fair);
  panel->renameSelected(QStringLiteral("Fair"));
  EXPECT_EQ(QDir(userPresetFolder()).entryList(QDir::Files), QStringList{QStringLiteral("Fair.json")});
  EXPECT_FALSE(bindingOf(face).edited);
}

TEST_F(PresetFiles, TagsGivenToAPresetAreKeptWhenItIsUpdated) {
  wear(fair, {face});
  select(fair);
  panel->setTagsOfSelected({QStringLiteral("north")});
  EXPECT_FALSE(bindingOf(face).edited);
  document().setParameter(face, "subsurface.scale", 2.0F, newGesture());
  window->fileActions()->savePreset();
  Warnings warnings;
  const auto saved = loadPreset(fair.toStdString(), warnings);
  ASSERT_TRUE(saved.has_value());
  EXPECT_FLOAT_EQ(saved->parameters.subsurfaceScale, 2.0F);
  EXPECT_EQ(presetTags(*saved), std::vector<std::string>{"north"});
  undo().undo();
  EXPECT_TRUE(bindingOf(face).edited);
  undo().redo();
  EXPECT_FALSE(bindingOf(face).edited);
}

TEST_F(PresetFiles, AThrownAwayPresetDoesNotComeBackUnasked) {
  wear(fair, {face});
  QFile::remove(fair);
  bool asked = false;
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &hand, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    asked = true;
    hand.stop();
    dialog->reject();
  });
  hand.start(30);
  window->fileActions()->savePreset();
  EXPECT_TRUE(asked);
  EXPECT_FALSE(QFile::exists(fair));
}

TEST_F(PresetFiles, ASceneWhosePresetIsGoneOpensAndKeepsItsPath) {
  wear(fair, {face});
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("look.dermis")).toStdString();
  ASSERT_TRUE(window->loading().saveScene(file));
  const QString away = folder.filePath(QStringLiteral("away.json"));
  ASSERT_TRUE(QFile::rename(fair, away));
  window->messageBar()->hide();
  window->openFile(QString::fromStdString(file.string()));
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().path(), file);
  EXPECT_TRUE(window->messageBar()->message().contains(QStringLiteral("Fair.json")));
  EXPECT_FLOAT_EQ(scaleOf(face), MaterialParameters{}.subsurfaceScale);
  const MaterialBinding saved = document().sceneForSaving().materials.at("face");
  EXPECT_EQ(saved.presetPath, fair.toStdString());
  EXPECT_FALSE(saved.edited);
  // Once it is back, reverting fetches it.
  ASSERT_TRUE(QFile::rename(away, fair));
  window->loading().revertToPreset({face});
  ASSERT_TRUE(waitIdle());
  EXPECT_FLOAT_EQ(scaleOf(face), 1.5F);
  EXPECT_FALSE(bindingOf(face).missing);
}

TEST_F(PresetFiles, SavedUnderAnotherNameItIsCalledSo) {
  wear(fair, {face});
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, &hand, [&] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) return;
    hand.stop();
    dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))
        ->setText(userPresetFolder() + QStringLiteral("/Ruddy"));
    QMetaObject::invokeMethod(dialog, "accept");
  });
  hand.start(30);
  window->fileActions()->savePresetAs();
  Warnings warnings;
  const auto saved = loadPreset((userPresetFolder() + QStringLiteral("/Ruddy.json")).toStdString(), warnings);
  ASSERT_TRUE(saved.has_value());
  EXPECT_EQ(saved->name, "Ruddy");
  EXPECT_EQ(document().slotLook(face)->worn.material.name, "Ruddy");
  EXPECT_FALSE(bindingOf(face).edited);
}

TEST_F(PresetFiles, SlotsEditedTogetherAreDressedAndRevertedTogether) {
  document().setEditedSlots({face, eye});
  select(fair);
  find<QAbstractButton>(QStringLiteral("presets.apply"))->click();
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_FLOAT_EQ(scaleOf(face), 1.5F);
  EXPECT_FLOAT_EQ(scaleOf(eye), 1.5F);
  document().setParameter(face, "subsurface.scale", 2.0F, newGesture());
  document().setParameter(eye, "subsurface.scale", 3.0F, newGesture());
  find<QAction>(QStringLiteral("edit.revert"))->trigger();
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 4);
  EXPECT_FLOAT_EQ(scaleOf(face), 1.5F);
  EXPECT_FLOAT_EQ(scaleOf(eye), 1.5F);
}

TEST_F(PresetFiles, APresetOrAnotherSlotsMaterialIsDroppedOnTheSlotsOfTheList) {
  auto* box = find<QComboBox>(QStringLiteral("material.slot"));
  auto* drop = find<QListWidget>(QStringLiteral("material.drop"));
  reveal(box);
  const auto dropOn = [&](const QMimeData& data, const QString& slot) {
    QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(box, &enter);
    EXPECT_TRUE(enter.isAccepted());
    EXPECT_TRUE(drop->isVisible());
    const QList<QListWidgetItem*> items = drop->findItems(slot, Qt::MatchExactly);
    ASSERT_EQ(items.size(), 1);
    QApplication::processEvents();
    const QPointF at = drop->visualItemRect(items.first()).center();
    ASSERT_EQ(drop->itemAt(at.toPoint()), items.first()) << at.x() << ' ' << at.y() << ' ' << drop->height();
    // As the mouse comes there: a drop goes to what was entered last.
    QDragEnterEvent come(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(drop->viewport(), &come);
    EXPECT_TRUE(come.isAccepted());
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(drop->viewport(), &event);
    EXPECT_FALSE(drop->isVisible());
    ASSERT_TRUE(waitIdle());
  };
  QMimeData preset;
  preset.setData(QStringLiteral("application/x-dermis-preset"), fair.toUtf8());
  dropOn(preset, face);
  EXPECT_EQ(bindingOf(face).presetPath, fair.toStdString());
  EXPECT_EQ(undo().count(), 1);
  QMimeData slot;
  slot.setData(QStringLiteral("application/x-dermis-slot"), face.toUtf8());
  dropOn(slot, eye);
  EXPECT_EQ(undo().count(), 2);
  EXPECT_EQ(bindingOf(eye).presetPath, fair.toStdString());
  EXPECT_EQ(document().slotLook(eye)->worn.material, document().slotLook(face)->worn.material);
  undo().undo();
  EXPECT_NE(bindingOf(eye).presetPath, fair.toStdString());
}

TEST_F(PresetFiles, TwoPresetsAreComparedWithEachOther) {
  const QImage now = picture();
  panel->compareRequested(QStringLiteral("builtin:jade"), true);
  ASSERT_TRUE(waitIdle());
  panel->compareRequested(QStringLiteral("builtin:marble"), false);
  ASSERT_TRUE(waitIdle());
  const auto nameAt = [&](const ResolvedScene* scene) {
    return scene->slots.at(static_cast<std::size_t>(document().slotNames().indexOf(face))).material.name;
  };
  ASSERT_NE(window->viewport()->compared(), nullptr);
  ASSERT_NE(window->viewport()->comparedLeft(), nullptr);
  EXPECT_NE(nameAt(window->viewport()->compared()), nameAt(window->viewport()->comparedLeft()));
  const QImage both = picture();
  const QRect left(0, 0, now.width() / 2 - 10, now.height());
  EXPECT_GT(meanDifference(now.copy(left), both.copy(left)), 0.5F);
  find<QAction>(QStringLiteral("view.compareEnd"))->trigger();
  EXPECT_LT(meanDifference(now, picture()), 0.2F);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(PresetFiles, AFolderOfManyIsReadBesideTheEventLoop) {
  constexpr int kMany = 500;
  const QTemporaryDir folder;
  Material material;
  for (int i = 0; i < kMany; ++i) {
    material.name = "Many " + std::to_string(i);
    material.parameters.subsurfaceScale = 0.001F * static_cast<float>(i);
    ASSERT_TRUE(savePreset(folder.filePath(QStringLiteral("many%1.json").arg(i)).toStdString(), material));
  }
  PresetLibrary library;
  const std::size_t builtins = library.entries().size();
  ASSERT_GT(builtins, 20U) << "what the program carries is there at once";
  QSignalSpy changed(&library, &PresetLibrary::changed);
  QElapsedTimer clock;
  clock.start();
  library.setFolders({folder.path()});
  const qint64 returned = clock.elapsed();
  EXPECT_TRUE(library.isReading());
  EXPECT_EQ(library.entries().size(), builtins);
  // The event loop goes on meanwhile.
  int turns = 0;
  while (library.isReading() && clock.elapsed() < kPatienceMs) {
    QApplication::processEvents();
    QTest::qSleep(1);
    ++turns;
  }
  EXPECT_EQ(library.entries().size(), builtins + kMany + 1) << "and the one of this test's folder";
  EXPECT_EQ(changed.size(), 1);
  EXPECT_NE(library.find(folder.filePath(QStringLiteral("many499.json"))), nullptr);
  EXPECT_LT(returned, 30);
  EXPECT_GT(turns, 3);
  // Asked twice, the first answer is dropped; where nothing has changed, nobody is told.
  library.refresh();
  ASSERT_TRUE(QFile::remove(folder.filePath(QStringLiteral("many0.json"))));
  library.refresh();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !library.isReading(); }, kPatienceMs));
  EXPECT_EQ(library.entries().size(), builtins + kMany);
  EXPECT_EQ(changed.size(), 2);
  library.refresh();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !library.isReading(); }, kPatienceMs));
  EXPECT_EQ(changed.size(), 2);
}

TEST_F(PresetFiles, ALibraryMayGoWhileItReads) {
  auto library = std::make_unique<PresetLibrary>();
  library->setFolders({});
  EXPECT_TRUE(library->isReading());
  library.reset();
  QApplication::processEvents();
}

}  // namespace
}  // namespace dermis
