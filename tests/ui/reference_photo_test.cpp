// A photograph over the picture and beside it.
#include "ui/viewport/reference_photo.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/view_tools.h"

namespace dermis {
namespace {

class Reference : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    if (HasFatalFailure()) return;
    QImage red(40, 40, QImage::Format_RGB32);
    red.fill(QColor(200, 30, 30));
    m_path = folder.filePath(QStringLiteral("red.png"));
    ASSERT_TRUE(red.save(m_path));
  }
  void TearDown() override { photo().set({}); }
  ReferencePhoto& photo() { return window->viewTools()->reference(); }
  void show(ReferencePhoto::Settings settings) {
    settings.path = m_path;
    photo().set(settings);
    ASSERT_TRUE(waitIdle());
    ASSERT_FALSE(photo().image().isNull());
    QApplication::processEvents();
  }
  /// What lies over the picture at a point.
  QColor over(QPointF at) {
    auto* canvas = find<QWidget>(QStringLiteral("viewport.canvas"));
    QImage image(canvas->size(), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    canvas->render(&image, QPoint(), QRegion(), QWidget::RenderFlags());
    return image.pixelColor(at.toPoint());
  }
  QTemporaryDir folder;
  QString m_path;
};

TEST_F(Reference, LiesOverThePictureAsFarAsTheWipeAndAsThickAsItsOpacity) {
  Viewport* viewport = window->viewport();
  const QPointF middle(viewport->rect().center());
  EXPECT_EQ(over(middle).alpha(), 0);
  ReferencePhoto::Settings settings;
  settings.place = ReferencePhoto::Place::Over;
  settings.opacity = 1.0;
  show(settings);
  EXPECT_EQ(over(middle).red(), 200);
  EXPECT_EQ(over(middle).alpha(), 255);
  settings.opacity = 0.25;
  show(settings);
  EXPECT_NEAR(over(middle).alpha(), 64, 2);
  settings.wipe = 0.4;
  show(settings);
  EXPECT_EQ(over(middle).alpha(), 0);
  // It is no part of the document.
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(Reference, TheWipesLineIsDragged) {
  Viewport* viewport = window->viewport();
  ReferencePhoto::Settings settings;
  settings.place = ReferencePhoto::Place::Over;
  settings.wipe = 0.5;
  show(settings);
  const Camera camera = document().camera();
  drag(viewport, QPoint(viewport->width() / 2, 50), 100);
  EXPECT_NEAR(photo().settings().wipe, 0.5 + 100.0 / viewport->width(), 0.01);
  EXPECT_EQ(document().camera(), camera);
}

TEST_F(Reference, BesideThePictureItHasAPlaceOfItsOwn) {
  Viewport* viewport = window->viewport();
  const int wide = viewport->width();
  ReferencePhoto::Settings settings;
  settings.place = ReferencePhoto::Place::Beside;
  show(settings);
  auto* view = find<QWidget>(QStringLiteral("referenceView"));
  EXPECT_FALSE(view->isHidden());
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport->width() < wide; }, kPatienceMs));
  EXPECT_EQ(view->grab().toImage().pixelColor(view->rect().center()).red(), 200);
  photo().set({});
  EXPECT_TRUE(view->isHidden());
}

TEST_F(Reference, RowsThatWouldChangeNothingAreNotAskedFor) {
  const auto asked = [this](const char* name) {
    return !find<PropertyRow>(QStringLiteral("reference.") + QLatin1String(name))->isHidden();
  };
  ReferencePhoto::Settings settings;
  for (const char* name : {"opacity", "wipe", "scale", "x", "y"}) EXPECT_FALSE(asked(name)) << name;
  settings.place = ReferencePhoto::Place::Beside;
  show(settings);
  for (const char* name : {"scale", "x", "y"}) EXPECT_TRUE(asked(name)) << name;
  for (const char* name : {"opacity", "wipe"}) EXPECT_FALSE(asked(name)) << name;
  settings.place = ReferencePhoto::Place::Over;
  show(settings);
  for (const char* name : {"opacity", "wipe", "scale", "x", "y"}) EXPECT_TRUE(asked(name)) << name;
}

TEST_F(Reference, WhatIsNoPictureIsSaidInASentence) {
  m_path = QString::fromStdString(write(folder, "broken.png", "no picture"));
  ReferencePhoto::Settings settings;
  settings.path = m_path;
  settings.place = ReferencePhoto::Place::Over;
  QSignalSpy problem(&photo(), &ReferencePhoto::problem);
  photo().set(settings);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !problem.isEmpty(); }, kPatienceMs));
  EXPECT_TRUE(problem.front().front().toString().contains(QStringLiteral("broken.png")));
}

}  // namespace
}  // namespace dermis
