// Maps: dropped, matched by name, changed on disk while the editor is open, missing and found again.
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDesktopServices>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>

#include "core/material/preset_io.h"
#include "ui/docks/texture_row.h"
#include "ui/docks/textures_panel.h"
#include "ui/editor_fixture.h"

namespace dermis {
namespace {

/// What the desktop is asked to open, instead of opening it.
class Desktop : public QObject {
  Q_OBJECT
 public:
  QStringList opened;
 public Q_SLOTS:
  void open(const QUrl& url) { opened << url.toLocalFile(); }
};

class TextureRows : public Editor {
 protected:
  QTemporaryDir folder;

  void SetUp() override {
    Editor::SetUp();
    window->loading().openModel(ModelSource{{}, "sphere", {}, std::nullopt});
    ASSERT_TRUE(waitIdle());
    undo().clear();
    reveal(find(QStringLiteral("textures.folder")));
  }
  /// A sphere has one slot.
  QString slot() { return document().currentSlot(); }
  TextureRow* row(const char* id) { return find<TextureRow>(QStringLiteral("texture.") + QLatin1String(id)); }
  QString image(const char* name, const QColor& colour, int side = 16) {
    QString path = folder.filePath(QString::fromLatin1(name));
    QDir().mkpath(QFileInfo(path).path());
    QImage picture(side, side, QImage::Format_RGB888);
    picture.fill(colour);
    EXPECT_TRUE(picture.save(path));
    return path;
  }
  static void drop(QWidget* target, const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    const QPoint at = target->rect().center();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(target, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(at), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(target, &event);
  }
  const ResolvedMaterial& worn() { return document().currentLook()->worn; }
  const Image* picture(TextureSlot texture) { return worn().images.at(static_cast<std::size_t>(texture)).get(); }
  int red(TextureSlot texture) {
    const Image* shown = picture(texture);
    return shown == nullptr ? -1 : std::to_integer<int>(shown->pixels[0]);
  }
  bool waitRed(TextureSlot texture, int wanted) {
    return QTest::qWaitFor([&] { return red(texture) == wanted; }, 5000);
  }
  using Editor::picture;
};

TEST_F(TextureRows, RowsThatNobodySeesFollowWhenTheyAreSeen) {
  auto* clear = find<QToolButton>(QStringLiteral("texture.roughness.clear"));
  ASSERT_TRUE(clear->isHidden());
  QWidget* dock = row("roughness");
  while (qobject_cast<QDockWidget*>(dock) == nullptr) dock = dock->parentWidget();
  dock->hide();
  window->loading().assignTexture({slot()}, TextureSlot::Roughness, image("late.png", Qt::red).toStdString());
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(clear->isHidden());
  reveal(row("roughness"));
  EXPECT_TRUE(clear->isVisible()) << "the row of a map that is there";
}

TEST_F(TextureRows, AFileDroppedOnARowIsBoundAndSeen) {
  const QImage before = picture();
  reveal(row("albedo"));
  drop(row("albedo"), {image("any name.png", Qt::red)});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(red(TextureSlot::Albedo), 255);
  EXPECT_GT(meanDifference(before, picture()), 1.0F);
  undo().undo();
  EXPECT_LT(meanDifference(before, picture()), 0.05F);
}

TEST_F(TextureRows, AFolderFindsItsMapsByNameAsOneEntry) {
  image("set/sphere_BaseColor_2k.png", Qt::green);
  image("set/sphere-normal-dx.png", QColor(128, 128, 255));
  image("set/Sphere Roughness.png", Qt::gray);
  image("set/holiday.png", Qt::blue);
  auto* panel = window->findChild<TexturesPanel*>();
  reveal(row("albedo"));
  drop(panel, {folder.filePath(QStringLiteral("set"))});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NE(picture(TextureSlot::Albedo), nullptr);
  EXPECT_NE(picture(TextureSlot::Roughness), nullptr);
  EXPECT_TRUE(worn().material.texture(TextureSlot::Normal).flipGreen);
  const QString report = find<QLabel>(QStringLiteral("textures.report"))->text();
  EXPECT_TRUE(report.contains(QStringLiteral("sphere_BaseColor_2k.png"))) << report.toStdString();
  EXPECT_TRUE(report.contains(QStringLiteral("holiday.png"))) << report.toStdString();
  undo().undo();
  EXPECT_EQ(picture(TextureSlot::Albedo), nullptr);
}

TEST_F(TextureRows, AFolderWithoutMapsSaysSo) {
  image("none/holiday.png", Qt::blue);
  drop(row("albedo"), {folder.filePath(QStringLiteral("none"))});
  EXPECT_FALSE(window->messageBar()->message().isEmpty());
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(TextureRows, AChangedFileIsReadAgainHoweverItWasSaved) {
  const QString path = image("albedo.png", QColor(255, 0, 0));
  drop(row("albedo"), {path});
  ASSERT_TRUE(waitIdle());
  const QImage redBall = picture();
  image("albedo.png", QColor(10, 0, 0));  // in place
  ASSERT_TRUE(waitRed(TextureSlot::Albedo, 10));
  EXPECT_GT(meanDifference(redBall, picture()), 1.0F);
  // Beside it and renamed over it, twice: the watch must follow the name.
  for (const int value : {60, 120}) {
    const QString other = image("albedo.tmp.png", QColor(value, 0, 0));
    ASSERT_EQ(std::rename(other.toLocal8Bit().constData(), path.toLocal8Bit().constData()), 0);
    ASSERT_TRUE(waitRed(TextureSlot::Albedo, value));
  }
  // No undo entry of its own; and undoing doesn't bring back what the file no longer holds.
  EXPECT_EQ(undo().count(), 1);
  document().setParameter(slot(), "specular.lobe_mix", 0.1F, newGesture());
  image("albedo.png", QColor(33, 0, 0));
  ASSERT_TRUE(waitRed(TextureSlot::Albedo, 33));
  undo().undo();
  EXPECT_EQ(red(TextureSlot::Albedo), 33);
}

TEST_F(TextureRows, AHalfWrittenFileKeepsTheLastGoodPicture) {
  const QString path = image("albedo.png", QColor(200, 0, 0), 256);
  drop(row("albedo"), {path});
  ASSERT_TRUE(waitIdle());
  ASSERT_EQ(red(TextureSlot::Albedo), 200);
  image("next.png", QColor(90, 0, 0), 256);
  QFile next(folder.filePath(QStringLiteral("next.png")));
  ASSERT_TRUE(next.open(QIODevice::ReadOnly));
  const QByteArray bytes = next.readAll();
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
  file.write(bytes.left(bytes.size() / 3));
  file.flush();
  QTest::qWait(600);
  EXPECT_EQ(red(TextureSlot::Albedo), 200);
  file.write(bytes.mid(bytes.size() / 3));
  file.close();
  ASSERT_TRUE(waitRed(TextureSlot::Albedo, 90));
}

TEST_F(TextureRows, AMissingMapOpensWithTheSceneAndIsLocatedWithItsSiblings) {
  Material material;
  material.texture(TextureSlot::Albedo).path = image("old/a.png", QColor(70, 0, 0)).toStdString();
  material.texture(TextureSlot::Roughness).path = image("old/sub/r.png", QColor(80, 0, 0)).toStdString();
  const std::string preset = folder.filePath(QStringLiteral("lost.json")).toStdString();
  ASSERT_TRUE(savePreset(preset, material));
  ASSERT_TRUE(QDir().rename(folder.filePath(QStringLiteral("old")), folder.filePath(QStringLiteral("new"))));
  window->openFile(QString::fromStdString(preset));
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(window->messageBar()->message().contains(QStringLiteral("a.png")) ||
              window->messageBar()->message().contains(QStringLiteral("r.png")));
  EXPECT_TRUE(worn().material.texture(TextureSlot::Albedo).present());
  EXPECT_EQ(picture(TextureSlot::Albedo), nullptr);
  reveal(row("albedo"));
  auto* locate = find<QPushButton>(QStringLiteral("texture.albedo.locate"));
  EXPECT_FALSE(locate->isHidden());
  const int entries = undo().count();
  window->findChild<TexturesPanel*>()->locate(TextureSlot::Albedo, folder.filePath(QStringLiteral("new/a.png")));
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), entries + 1);
  EXPECT_EQ(red(TextureSlot::Albedo), 70);
  EXPECT_EQ(red(TextureSlot::Roughness), 80);
  EXPECT_TRUE(locate->isHidden());
}

TEST_F(TextureRows, ADeletedFileIsShownAsMissingAndComesBack) {
  const QString path = image("albedo.png", QColor(40, 0, 0));
  drop(row("albedo"), {path});
  ASSERT_TRUE(waitIdle());
  reveal(row("albedo"));
  auto* locate = find<QPushButton>(QStringLiteral("texture.albedo.locate"));
  EXPECT_TRUE(locate->isHidden());
  ASSERT_TRUE(QFile::remove(path));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !locate->isHidden(); }, 5000));
  EXPECT_EQ(red(TextureSlot::Albedo), 40);
  QTest::qWait(50);  // what it says now is laid out
  const auto* area = window->findChild<TexturesPanel*>()->findChild<QScrollArea*>();
  ASSERT_NE(area, nullptr);
  EXPECT_LE(row("albedo")->mapTo(area, QPoint(row("albedo")->width(), 0)).x(), area->width()) << "cut off";
  image("albedo.png", QColor(41, 0, 0));
  EXPECT_TRUE(waitRed(TextureSlot::Albedo, 41));
  EXPECT_TRUE(QTest::qWaitFor([&] { return locate->isHidden(); }, 5000));
}

TEST_F(TextureRows, ATileStandsForItsUdimSetAndEachSquareShowsItsOwn) {
  window->loading().openModel(ModelSource{{}, "plane", {}, std::nullopt});
  ASSERT_TRUE(waitIdle());
  image("skin.1001.png", Qt::red);
  image("skin.1002.png", Qt::green);
  image("skin.1012.png", Qt::blue, 32);
  undo().clear();
  drop(row("albedo"), {folder.filePath(QStringLiteral("skin.1002.png"))});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  TextureBinding binding = worn().material.texture(TextureSlot::Albedo);
  EXPECT_TRUE(binding.path.ends_with("skin.<UDIM>.png")) << binding.path;
  EXPECT_EQ(picture(TextureSlot::Albedo)->tiles.size(), 3U);
  QStringList words;
  for (const QLabel* label : row("albedo")->findChildren<QLabel*>()) words << label->text();
  EXPECT_TRUE(words.contains(QStringLiteral("UDIM, 3 tiles, 32 × 32 each"))) << words.join(u'\n').toStdString();
  // The plane's texture coordinates go to 1: twice of them are four squares.
  binding.uvScale = {2.0F, 2.0F};
  document().setTexture(slot(), TextureSlot::Albedo, binding, worn().images[0]);
  const QImage shown = picture();
  const auto at = [&](double x, double y) {
    return QColor(shown.pixel(static_cast<int>(x * shown.width()), static_cast<int>(y * shown.height())));
  };
  const QColor lowerLeft = at(0.45, 0.6), lowerRight = at(0.55, 0.6), upperRight = at(0.55, 0.4);
  EXPECT_GT(lowerLeft.red(), lowerLeft.green() + 20);
  EXPECT_GT(lowerRight.green(), lowerRight.red() + 20);
  EXPECT_GT(upperRight.blue(), upperRight.red() + 20);
  // One tile that changes is read again, and one that comes.
  image("skin.1002.png", QColor(9, 0, 0));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const Image& set = *picture(TextureSlot::Albedo);
        return std::to_integer<int>(set.pixels[set.rowBytes() * 32]) == 9;
      },
      5000));
  image("skin.1011.png", Qt::yellow);
  EXPECT_TRUE(QTest::qWaitFor([&] { return picture(TextureSlot::Albedo)->tiles.size() == 4; }, 5000));
}

TEST_F(TextureRows, APackedMapGoesToItsChannelsAndTheReportSaysWhyNot) {
  for (const char* name :
       {"set/sphere_ORM.png", "set/sphere_opacity.png", "set/sphere_emissive.png", "set/holiday.png"})
    image(name, Qt::gray);
  drop(row("albedo"), {folder.filePath(QStringLiteral("set"))});
  ASSERT_TRUE(waitIdle());
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(worn().material.texture(TextureSlot::Occlusion).channel, TextureChannel::R);
  EXPECT_EQ(worn().material.texture(TextureSlot::Roughness).channel, TextureChannel::G);
  EXPECT_EQ(worn().material.texture(TextureSlot::Metallic).channel, TextureChannel::B);
  EXPECT_EQ(picture(TextureSlot::Roughness), picture(TextureSlot::Metallic));
  const QString report = find<QLabel>(QStringLiteral("textures.report"))->text();
  for (const char* words :
       {"Roughness: sphere_ORM.png, channel G", "sphere_opacity.png (the model Skin has no opacity)",
        "sphere_emissive.png (the model Skin has no emissive map)", "holiday.png (no map's name)"})
    EXPECT_TRUE(report.contains(QLatin1String(words))) << words << "\n" << report.toStdString();
}

TEST_F(TextureRows, AFolderOfTilesIsMatchedByName) {
  for (const char* name :
       {"set/face_albedo.1001.png", "set/face_albedo.1002.png", "set/face_rough.1001.png", "set/face_rough.1002.png"})
    image(name, Qt::gray);
  drop(row("albedo"), {folder.filePath(QStringLiteral("set"))});
  ASSERT_TRUE(waitIdle());
  EXPECT_TRUE(worn().material.texture(TextureSlot::Roughness).path.ends_with("face_rough.<UDIM>.png"));
  EXPECT_EQ(picture(TextureSlot::Albedo)->tiles.size(), 2U);
  const QString report = find<QLabel>(QStringLiteral("textures.report"))->text();
  EXPECT_FALSE(report.contains(QStringLiteral("Not used"))) << report.toStdString();
}

TEST_F(TextureRows, TheMenuRevealsAndCopiesThePath) {
  const QString path = image("albedo.png", Qt::red);
  drop(row("albedo"), {path});
  ASSERT_TRUE(waitIdle());
  Desktop desktop;
  QDesktopServices::setUrlHandler(QStringLiteral("file"), &desktop, "open");
  const auto choose = [&](const char* id) {
    QTimer::singleShot(200, window.get(), [id] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_NE(menu, nullptr);
      for (QAction* action : menu->actions())
        if (action->objectName() == QLatin1String(id)) menu->setActiveAction(action);
      QTest::keyClick(menu, Qt::Key_Return);
    });
    QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, row("albedo")->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(row("albedo"), &event);
  };
  reveal(row("albedo"));
  choose("texture.reveal");
  EXPECT_EQ(desktop.opened, QStringList{folder.path()});
  QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
  choose("texture.copyPath");
  EXPECT_EQ(QApplication::clipboard()->text(), path);
  choose("texture.clear");
  EXPECT_EQ(picture(TextureSlot::Albedo), nullptr);
  EXPECT_EQ(undo().count(), 2);
}

}  // namespace
}  // namespace dermis

#include "texture_rows_test.moc"
