// The preset and environment browsers: what is found, applied, kept, thrown away; and their thumbnails.
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>

#include "core/material/preset_io.h"
#include "core/material/preset_tags.h"
#include "ui/browse/environment_list.h"
#include "ui/browse/preset_list.h"
#include "ui/docks/presets_panel.h"
#include "ui/editor_fixture.h"
#include "ui/preferences/preferences.h"

namespace dermis {
namespace {

class Browse : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    panel = window->findChild<PresetsPanel*>();
    list = find<QListWidget>(QStringLiteral("presets.list"));
    search()->clear();
    reveal(list);
  }
  void TearDown() override {
    search()->clear();
    for (const QString& name : QDir(userPresetFolder()).entryList(QDir::Files))
      QFile::remove(userPresetFolder() + QLatin1Char('/') + name);
    window->preferences().set(PreferenceValues{});
    panel->library().refresh();
    ASSERT_TRUE(QTest::qWaitFor([this] { return !panel->library().isReading(); }, kPatienceMs));
  }
  QLineEdit* search() { return find<QLineEdit>(QStringLiteral("presets.search")); }

  static QString save(const QString& folder, const char* name, float scale) {
    Material material;
    material.name = name;
    material.parameters.subsurfaceScale = scale;
    QString path = folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".json");
    EXPECT_TRUE(savePreset(path.toStdString(), material));
    return path;
  }
  QListWidgetItem* item(const QString& name) {
    for (int i = 0; i < list->count(); ++i)
      if (list->item(i)->data(PresetList::kNameRole).toString() == name) return list->item(i);
    return nullptr;
  }
  bool waitFor(const QString& name, bool there = true) {
    return QTest::qWaitFor([&] { return (item(name) != nullptr) == there; }, kPatienceMs);
  }
  int visible() {
    int count = 0;
    for (int i = 0; i < list->count(); ++i) count += list->item(i)->isHidden() ? 0 : 1;
    return count;
  }
  float scaleOf(const char* slot) {
    return document().slotLook(QLatin1String(slot))->worn.material.parameters.subsurfaceScale;
  }

  PresetsPanel* panel = nullptr;
  QListWidget* list = nullptr;
};

TEST_F(Browse, FilesOfWatchedFoldersComeAndGo) {
  const QTemporaryDir other;
  PreferenceValues values = window->preferences().values();
  values.presetFolders = {other.path()};
  window->preferences().set(values);
  save(userPresetFolder(), "Own", 1.5F);
  const QString path = save(other.path(), "Elsewhere", 1.25F);
  ASSERT_TRUE(waitFor(QStringLiteral("Own")));
  ASSERT_TRUE(waitFor(QStringLiteral("Elsewhere")));
  // A file that changes is another preset, also when only what stands in it is new.
  const QString before = item(QStringLiteral("Elsewhere"))->data(PresetList::kKeyRole).toString();
  save(other.path(), "Elsewhere", 1.75F);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const QListWidgetItem* now = item(QStringLiteral("Elsewhere"));
        return now != nullptr && now->data(PresetList::kKeyRole).toString() != before;
      },
      kPatienceMs));
  QFile::remove(path);
  EXPECT_TRUE(waitFor(QStringLiteral("Elsewhere"), false));
}

TEST_F(Browse, SearchLooksIntoNamesAndTags) {
  const int all = visible();
  ASSERT_GT(all, 20);
  search()->setText(QStringLiteral("tone iv"));
  EXPECT_GE(visible(), 1);
  EXPECT_LT(visible(), 6);
  const QString path = save(userPresetFolder(), "Tagged", 1.0F);
  search()->clear();
  ASSERT_TRUE(waitFor(QStringLiteral("Tagged")));
  list->setCurrentItem(item(QStringLiteral("Tagged")));
  panel->setTagsOfSelected({QStringLiteral("freckles"), QStringLiteral(" north ")});
  Warnings warnings;
  EXPECT_EQ(presetTags(*loadPreset(path.toStdString(), warnings)), (std::vector<std::string>{"freckles", "north"}));
  search()->setText(QStringLiteral("north"));
  EXPECT_EQ(visible(), 1);
  search()->clear();
  auto* tag = find<QComboBox>(QStringLiteral("presets.tag"));
  tag->setCurrentText(QStringLiteral("mine"));
  Q_EMIT tag->activated(tag->currentIndex());
  EXPECT_EQ(visible(), 1);
  tag->setCurrentIndex(0);
  Q_EMIT tag->activated(0);
  EXPECT_EQ(visible(), all + 1);
}

TEST_F(Browse, EnterPutsAPresetOnTheSlotAsOneEntry) {
  const QImage before = picture();
  list->setCurrentItem(item(QStringLiteral("Skin tone VI")));
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Return);
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(document().currentLook()->binding->presetPath, "builtin:skin_tone_vi");
  EXPECT_TRUE(item(QStringLiteral("Skin tone VI"))->font().bold());
  EXPECT_GT(meanDifference(before, picture()), 1.0F);
}

TEST_F(Browse, AnEditedSlotShowsAStarAndCanBeRevertedOrUpdateItsPreset) {
  const QString path = save(userPresetFolder(), "Fair", 1.5F);
  ASSERT_TRUE(waitFor(QStringLiteral("Fair")));
  panel->apply(path, {QStringLiteral("face")});
  ASSERT_TRUE(waitIdle());
  document().setCurrentSlot(QStringLiteral("face"));
  auto* revert = find<QToolButton>(QStringLiteral("presets.revert"));
  auto* worn = find<QLabel>(QStringLiteral("presets.worn"));
  EXPECT_FALSE(revert->isEnabled());
  document().setParameter(QStringLiteral("face"), "subsurface.scale", 3.0F, newGesture());
  EXPECT_EQ(item(QStringLiteral("Fair"))->text(), QStringLiteral("Fair *"));
  EXPECT_TRUE(worn->text().endsWith(QStringLiteral("Fair *"))) << worn->text().toStdString();
  revert->click();
  ASSERT_TRUE(waitIdle());
  EXPECT_FLOAT_EQ(scaleOf("face"), 1.5F);
  EXPECT_EQ(item(QStringLiteral("Fair"))->text(), QStringLiteral("Fair"));
  undo().undo();
  EXPECT_FLOAT_EQ(scaleOf("face"), 3.0F);
  find<QToolButton>(QStringLiteral("presets.save"))->click();
  Warnings warnings;
  EXPECT_FLOAT_EQ(loadPreset(path.toStdString(), warnings)->parameters.subsurfaceScale, 3.0F);
  EXPECT_EQ(item(QStringLiteral("Fair"))->text(), QStringLiteral("Fair"));
}

TEST_F(Browse, PresetsAreDuplicatedRenamedAndThrownAway) {
  list->setCurrentItem(item(QStringLiteral("Marble")));
  panel->trashSelected();  // what the program carries stays
  ASSERT_NE(item(QStringLiteral("Marble")), nullptr);
  panel->duplicateSelected();
  ASSERT_NE(item(QStringLiteral("Marble copy")), nullptr);
  EXPECT_EQ(list->currentItem(), item(QStringLiteral("Marble copy")));
  panel->renameSelected(QStringLiteral("Carrara/1"));
  ASSERT_NE(item(QStringLiteral("Carrara/1")), nullptr);
  EXPECT_EQ(item(QStringLiteral("Marble copy")), nullptr);
  const QStringList files = QDir(userPresetFolder()).entryList(QDir::Files);
  EXPECT_EQ(files, QStringList{QStringLiteral("Carrara_1.json")});
  // A slot that wears it keeps its look when the file goes, and so does a scene saved then.
  list->setCurrentItem(item(QStringLiteral("Carrara/1")));
  panel->apply(userPresetFolder() + QStringLiteral("/Carrara_1.json"), {QStringLiteral("face")});
  ASSERT_TRUE(waitIdle());
  panel->trashSelected();
  EXPECT_EQ(item(QStringLiteral("Carrara/1")), nullptr) << window->messageBar()->message().toStdString();
  EXPECT_TRUE(document().sceneForSaving().materials.at("face").edited);
}

TEST_F(Browse, APresetDroppedOnTheWindowIsApplied) {
  auto* data = new QMimeData();
  data->setData(QStringLiteral("application/x-dermis-preset"), "builtin:jade");
  const QPointF at(window->viewport()->mapTo(window.get(), window->viewport()->rect().center()));
  QDragEnterEvent enter(at.toPoint(), Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window.get(), &drop);
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().slotLook(QStringLiteral("face"))->binding->presetPath, "builtin:jade");
  EXPECT_EQ(undo().count(), 1);
  delete data;
}

TEST_F(Browse, APresetDroppedOnTheBoxOfSlotsGoesToThatSlot) {
  document().setCurrentSlot(QStringLiteral("eye"));
  QMimeData data;
  data.setData(QStringLiteral("application/x-dermis-preset"), "builtin:jade");
  auto* box = find<QComboBox>(QStringLiteral("material.slot"));
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(box, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5.0, 5.0), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(box, &drop);
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(document().slotLook(QStringLiteral("eye"))->binding->presetPath, "builtin:jade");
  EXPECT_NE(document().slotLook(QStringLiteral("face"))->binding->presetPath, "builtin:jade");
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(Browse, AThumbnailIsDrawnByTheProgramAndKept) {
  const PresetEntry* entry = panel->library().find(QStringLiteral("builtin:lab_very_specular"));
  ASSERT_NE(entry, nullptr);
  ThumbnailMaker maker;
  ASSERT_TRUE(maker.find(*entry).isNull());
  QSignalSpy made(&maker, &ThumbnailMaker::made);
  maker.hold(true);  // as while the editor loads
  maker.want({*entry});
  EXPECT_EQ(maker.waiting(), 1);
  auto& process = *maker.findChild<QProcess*>();
  QTest::qWait(ThumbnailMaker::kWaitMs + 200);
  EXPECT_EQ(process.state(), QProcess::NotRunning);
  maker.hold(false);
  // While somebody edits it stands still, and goes on afterwards.
  ASSERT_TRUE(QTest::qWaitFor([&] { return process.state() == QProcess::Running; }, kPatienceMs));
  const auto state = [&] {
    QFile stat(QStringLiteral("/proc/%1/stat").arg(process.processId()));
    return stat.open(QIODevice::ReadOnly) ? stat.readAll().split(')').last().trimmed().left(1) : QByteArray();
  };
  maker.yield();
  EXPECT_TRUE(QTest::qWaitFor([&] { return state() == "T"; }, ThumbnailMaker::kYieldMs / 2));
  EXPECT_TRUE(made.isEmpty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !made.isEmpty(); }, kPatienceMs));
  const QImage drawn = maker.find(*entry);
  ASSERT_EQ(drawn.size(), QSize(ThumbnailMaker::kSide, ThumbnailMaker::kSide));
  EXPECT_GT(std::abs(qGray(drawn.pixel(64, 64)) - qGray(drawn.pixel(2, 2))), 4);
  maker.want({*entry});  // it is there: nothing is drawn again
  EXPECT_EQ(maker.waiting(), 0);
}

TEST_F(Browse, ThumbnailsThatAreSeenAreDrawnFirstAndABrokenOneKeepsNoneBack) {
  std::vector<PresetEntry> entries;
  for (const char* id : {"wax", "lab_rougher", "lab_mirror_sphere", "lab_very_rough", "lab_very_rough_gold",
                         "lab_very_rough_silver", "lab_very_specular_gold", "hair_black", "hair_blond", "hair_grey"}) {
    const PresetEntry* entry = panel->library().find(QStringLiteral("builtin:") + QLatin1String(id));
    ASSERT_NE(entry, nullptr) << id;
    entries.push_back(*entry);
  }
  PresetEntry& gone = entries[1];
  gone.path = userPresetFolder() + QStringLiteral("/gone.json");
  gone.key = QStringLiteral("gone");
  ThumbnailMaker maker;
  maker.preferShown([&] { return QSet<QString>{entries[9].key}; });
  std::vector<QString> order;
  QObject::connect(&maker, &ThumbnailMaker::made, &maker, [&](const QString& key) { order.push_back(key); });
  maker.want(entries);
  EXPECT_EQ(maker.waiting(), 10);
  ASSERT_TRUE(QTest::qWaitFor([&] { return maker.waiting() == 0; }, kPatienceMs));
  ASSERT_EQ(order.size(), 9U);
  EXPECT_EQ(order.front(), entries[9].key);
  EXPECT_EQ(order[1], entries[0].key);
  EXPECT_EQ(order.back(), entries[8].key);
  for (const PresetEntry& entry : entries) EXPECT_EQ(maker.find(entry).isNull(), entry.key == gone.key);
  maker.want(entries);  // what failed is not tried again
  EXPECT_EQ(maker.waiting(), 0);
}

TEST_F(Browse, EnvironmentsOfAWatchedFolderShowTheirPanoramas) {
  auto* environments = find<QListWidget>(QStringLiteral("environment.list"));
  auto* words = find<QLineEdit>(QStringLiteral("environment.search"));
  const auto itemOf = [&](const QString& name) -> QListWidgetItem* {
    for (QListWidgetItem* found : environments->findItems(name, Qt::MatchExactly)) return found;
    return nullptr;
  };
  const QTemporaryDir folder;
  write(folder, "orange.hdr", flatHdr(200, 100, 50));
  PreferenceValues values = window->preferences().values();
  values.environmentFolders = {folder.path()};
  window->preferences().set(values);
  ASSERT_NE(itemOf(QStringLiteral("orange")), nullptr);
  // Its panorama follows, and is orange.
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const QColor c = itemOf(QStringLiteral("orange"))->icon().pixmap(128, 64).toImage().pixelColor(60, 30);
        return c.red() > c.green() + 20 && c.green() > c.blue() + 20;
      },
      kPatienceMs));
  write(folder, "later.hdr", flatHdr(10, 20, 200));
  ASSERT_TRUE(QTest::qWaitFor([&] { return itemOf(QStringLiteral("later")) != nullptr; }, kPatienceMs));
  words->setText(QStringLiteral("orange"));
  EXPECT_TRUE(itemOf(QStringLiteral("later"))->isHidden());
  EXPECT_FALSE(itemOf(QStringLiteral("orange"))->isHidden());
  words->clear();
  Q_EMIT environments->itemClicked(itemOf(QStringLiteral("orange")));
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(document().scene().environment.path.ends_with("orange.hdr"));
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(environments->currentItem(), itemOf(QStringLiteral("orange")));
  QFile::remove(folder.filePath(QStringLiteral("later.hdr")));
  EXPECT_TRUE(QTest::qWaitFor([&] { return itemOf(QStringLiteral("later")) == nullptr; }, kPatienceMs));
}

}  // namespace
}  // namespace dermis
