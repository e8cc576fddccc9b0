// The whole window elsewhere: on screens of other scale factors, and where a comma is the decimal sign.
#include <QLabel>
#include <QRegularExpression>
#include <QScreen>
#include <QStatusBar>

#include "core/scene/scene_io.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/dock_layout.h"
#include "ui/main_window/keep_on_screen.h"
#include "ui/own_process.h"

namespace dermis {
namespace {

// --- scale factors

class AtScale : public Editor {};

/// Also run by itself in a process of its own for each scale factor, see below.
TEST_F(AtScale, TheWindowFitsItsScreen) {
  window->findChild<DockLayout*>()->reset();
  QApplication::processEvents();
  const QSize screen = window->screen()->availableSize();
  const QSize least = window->minimumSizeHint();
  EXPECT_LE(least.width(), screen.width());
  EXPECT_LE(least.height(), screen.height());
  const QSize before = window->size();
  window->resize(screen);
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->size() == screen; }, 3000))
      << window->width() << " x " << window->height();
  // The picture keeps a place that is worth looking at.
  EXPECT_GE(window->viewport()->width(), 240);
  EXPECT_GE(window->viewport()->height(), 180);
  window->resize(before);
}

/// A window manager's frame comes on top of what was asked for: here a window that is itself too large stands for both.
TEST_F(AtScale, NoPartOfTheWindowStaysBeyondTheScreen) {
  const QRect screen = window->screen()->availableGeometry(), before = window->geometry();
  window->setGeometry(QRect(screen.x() + 40, screen.y() - 20, screen.width(), screen.height() + 60));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->height() > screen.height(); }, kPatienceMs));
  keepOnScreen(*window);
  EXPECT_TRUE(QTest::qWaitFor([&] { return screen.contains(window->frameGeometry()); }, kPatienceMs));
  EXPECT_EQ(window->size(), screen.size()) << "no smaller than it has to be";
  // What fits stays where it is.
  const QRect fits(screen.x() + 30, screen.y() + 20, screen.width() - 60, screen.height() - 40);
  window->setGeometry(fits);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->geometry() == fits; }, kPatienceMs));
  keepOnScreen(*window);
  QApplication::processEvents();
  EXPECT_EQ(window->geometry(), fits);
  window->setGeometry(before);
}

TEST_F(AtScale, TheThumbnailOfAMapHasAllItsPixels) {
  TextureBinding binding;
  binding.path = "map.png";
  document().setTexture(document().currentSlot(), TextureSlot::Roughness, binding,
                        std::make_shared<Image>(Image{64, 64, 4, PixelType::U8, std::vector<std::byte>(16384), "map"}));
  const double ratio = window->devicePixelRatioF();
  bool found = false;
  reveal(find(QStringLiteral("textures.folder")));
  for (const auto* label : find<QWidget>(QStringLiteral("texture.roughness"))->findChildren<QLabel*>()) {
    const QPixmap picture = label->pixmap();
    if (picture.isNull()) continue;
    found = true;
    EXPECT_EQ(picture.devicePixelRatio(), ratio);
    EXPECT_EQ(picture.width(), std::lround(48.0 * ratio));
  }
  EXPECT_TRUE(found);
}

TEST_F(AtScale, AScreenWithOtherPixelsIsToldOf) {
  QSignalSpy told(window->viewport(), &Viewport::pictureResized);
  QEvent change(QEvent::ScreenChangeInternal);
  QApplication::sendEvent(window->viewport(), &change);
  ASSERT_EQ(told.size(), 1);
  EXPECT_EQ(told[0][0].toSize(), (QSizeF(window->viewport()->size()) * window->devicePixelRatioF()).toSize());
}

TEST(ScaleFactors, GesturesAndDocksWorkAndTheWindowFits) {
  const QString filter = QStringLiteral(
      "AtScale.*:Gestures.TheMiddle*:Gestures.ADouble*:Gestures.Shift*:Docking.CtrlTabHides*:Docking.AnEdit*");
  for (const char* factor : {"1.25", "2"}) EXPECT_TRUE(test::passesAtScale(factor, filter, 9, 5 * kPatienceMs));
}

// --- a decimal comma

class Croatian : public Editor {
 protected:
  void SetUp() override {
    if (window) window->hide();
    QLocale::setDefault(QLocale(QLocale::Croatian, QLocale::Croatia));
    ASSERT_EQ(QLocale().decimalPoint(), QStringLiteral(","));
    other = std::make_unique<MainWindow>();
    other->resize(1100, 700);
    other->viewport()->setTargetSamples(1);
    other->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(other.get(), kPatienceMs));
    other->open({});
    ASSERT_TRUE(QTest::qWaitFor([this] { return other->document().isReady(); }, kPatienceMs));
    ASSERT_TRUE(QTest::qWaitFor([this] { return other->viewport()->isSettled(); }, kPatienceMs));
  }
  void TearDown() override {
    other.reset();
    QLocale::setDefault(before);
  }
  const QLocale before;
  std::unique_ptr<MainWindow> other;
};

TEST_F(Croatian, AllNumbersShownHaveAPoint) {
  static const QRegularExpression kComma(QStringLiteral("\\d,\\d"));
  int fractions = 0;
  for (const auto* field : other->findChildren<NumberField*>()) {
    EXPECT_FALSE(field->text().contains(kComma)) << field->objectName().toStdString();
    fractions += field->text().contains(QLatin1Char('.')) ? 1 : 0;
  }
  EXPECT_GT(fractions, 10);
  for (const auto* label : other->findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains(kComma)) << label->text().toStdString();
}

TEST_F(Croatian, TypingAndSavingMeanTheSameAsElsewhere) {
  auto* field = other->findChild<NumberField*>(QStringLiteral("subsurface.scale.number"));
  other->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(other.get(), kPatienceMs));
  for (const char* words : {"1,25", "1.25"}) {
    other->document().setParameter(other->document().currentSlot(), "subsurface.scale", 1.0F, newGesture());
    field->setFocus();
    QTest::qWait(0);
    field->selectAll();
    QTest::keyClicks(field, QLatin1String(words));
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_FLOAT_EQ(other->document().currentLook()->worn.material.parameters.subsurfaceScale, 1.25F) << words;
  }
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath(QStringLiteral("look.dermis")).toStdString();
  ASSERT_TRUE(saveScene(path, other->document().sceneForSaving()));
  std::ifstream file(path);
  const std::string saved{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(saved.find("1.25"), std::string::npos);
  EXPECT_EQ(saved.find("1,25"), std::string::npos);
  Warnings warnings;
  const auto again = loadScene(path, warnings);
  ASSERT_TRUE(again.has_value());
}

}  // namespace
}  // namespace dermis
