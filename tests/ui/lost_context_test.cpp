// The picture goes and comes back: a context made anew, a driver that was reset, a driver that offers too little.
#include <QLabel>
#include <QLayout>
#include <QOpenGLContext>
#include <QProcess>
#include <algorithm>

#include "ui/driver_reset.h"
#include "ui/editor_fixture.h"
#include "ui/own_process.h"

namespace dermis {
namespace {

class LostContext : public Editor {
 protected:
  static constexpr const char* kRoughness = "specular.perceptual_roughness";

  static Viewport* viewport() { return window->viewport(); }
  QLabel* problem() { return find<QLabel>(QStringLiteral("viewport.problem")); }

  /// A scene with work in it: an edit, another slot, another view.
  void work() {
    document().setCurrentSlot(QStringLiteral("face"));
    change(0.61F);
    change(0.23F);
    document().setEditedSlots({QStringLiteral("face"), QStringLiteral("eye")});
    viewport()->setAov(Aov::Specular);
  }
  void change(float roughness) {
    document().setParameter(document().currentSlot(), kRoughness, ParameterValue(roughness), newGesture());
  }
  void TearDown() override { viewport()->setAov(Aov::Beauty); }

  /// All of the editor but the picture: what `happens` to the context is no business of theirs.
  template <class Happens>
  void expectAllElseKept(Happens happens) {
    const Scene scene = document().scene();
    const Camera camera = document().camera();
    const QString slot = document().currentSlot();
    const QStringList edited = document().editedSlots();
    const int steps = undo().count(), at = undo().index();
    const Aov view = viewport()->aov();
    happens();
    EXPECT_EQ(document().scene(), scene);
    EXPECT_EQ(document().camera(), camera);
    EXPECT_EQ(document().currentSlot(), slot);
    EXPECT_EQ(document().editedSlots(), edited);
    EXPECT_EQ(undo().count(), steps);
    EXPECT_EQ(undo().index(), at);
    EXPECT_EQ(viewport()->aov(), view);
  }
  static int resetsTold(const QSignalSpy& messages) {
    return static_cast<int>(std::count_if(messages.begin(), messages.end(), [](const QList<QVariant>& each) {
      return each.at(1).toString().contains(QStringLiteral("driver was reset"));
    }));
  }
  /// Waits until the reset has been told, and shuts the bar that tells it: it takes room from the picture.
  bool toldOf(const QSignalSpy& messages) {
    const bool told = QTest::qWaitFor([&] { return resetsTold(messages) > 0; }, kPatienceMs);
    EXPECT_TRUE(window->messageBar()->isVisible());
    window->messageBar()->hide();
    QTest::qWait(50);
    return told;
  }
  /// A window of its own and back. Where OpenGL composes windows, the widget gets another context each time.
  void moveAway() {
    const QSize size = viewport()->size();
    QLayout* column = viewport()->parentWidget()->layout();
    auto* row = qobject_cast<QBoxLayout*>(column->itemAt(column->count() - 1)->layout());
    ASSERT_NE(row, nullptr);
    viewport()->setParent(nullptr);
    viewport()->resize(size);
    viewport()->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(viewport(), kPatienceMs));
    if (viewport()->hosting() == Hosting::Copied) viewport()->renewContext();
    row->insertWidget(0, viewport(), 1);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatienceMs));
    ASSERT_TRUE(QTest::qWaitFor([&] { return viewport()->size() == size; }, kPatienceMs));
  }
};

TEST_F(LostContext, ANewContextKeepsTheWorkAndTheView) {
  work();
  const QImage before = picture();
  expectAllElseKept([this] { moveAway(); });
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  undo().undo();
  EXPECT_GT(meanDifference(before, picture()), 0.05F) << "what was done before can be undone, and is seen";
}

TEST_F(LostContext, AResetIsToldOnceAndThePictureComesBack) {
  work();
  const QImage before = picture();
  QSignalSpy messages(viewport(), &Viewport::message);
  const int told = test::contextsTold();
  expectAllElseKept([&] {
    test::resetDriver();
    viewport()->requestFrame();
    ASSERT_TRUE(toldOf(messages));
  });
  EXPECT_EQ(test::contextsTold(), told + 1);
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  EXPECT_TRUE(problem()->isHidden());
  undo().undo();
  const QImage undone = picture();
  EXPECT_GT(meanDifference(before, undone), 0.05F);
  undo().redo();
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  EXPECT_EQ(resetsTold(messages), 1);
}

TEST_F(LostContext, AQuestionThatFindsItLostIsNotAnswered) {
  const QImage before = picture();
  QSignalSpy messages(viewport(), &Viewport::message);
  test::resetDriver();
  EXPECT_FALSE(viewport()->readPixel(QRectF(viewport()->rect()).center()).has_value());
  EXPECT_FALSE(viewport()->pickPosition(QRectF(viewport()->rect()).center()).has_value());
  viewport()->cancelJobs();
  EXPECT_TRUE(viewport()->picture().isNull());
  EXPECT_FALSE(viewport()->glInfo().has_value());
  ASSERT_TRUE(toldOf(messages));
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  EXPECT_TRUE(viewport()->readPixel(QRectF(viewport()->rect()).center()).has_value());
  EXPECT_EQ(resetsTold(messages), 1);
}

TEST_F(LostContext, AComparisonIsMadeAnewAfterAReset) {
  auto other = std::make_shared<ResolvedScene>(*document().snapshot());
  other->scene.view.exposureStops = -3.0F;
  viewport()->compareWith(other);
  const QImage before = picture();
  QSignalSpy messages(viewport(), &Viewport::message);
  test::resetDriver();
  viewport()->requestFrame();
  ASSERT_TRUE(toldOf(messages));
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  EXPECT_EQ(viewport()->compared(), other.get());
  viewport()->compareWith(nullptr);
}

TEST_F(LostContext, ADriverThatStaysBrokenIsNotAskedForever) {
  const QImage before = picture();
  QSignalSpy messages(viewport(), &Viewport::message);
  const int told = test::contextsTold();
  test::breakDriver();
  viewport()->requestFrame();
  ASSERT_TRUE(QTest::qWaitFor([this] { return problem()->isVisible(); }, kPatienceMs));
  EXPECT_TRUE(problem()->text().contains(QStringLiteral("save the scene")));
  QTest::qWait(500);
  viewport()->requestFrame();
  QTest::qWait(500);
  EXPECT_LE(test::contextsTold(), told + 2);
  EXPECT_TRUE(problem()->isVisible());
  EXPECT_EQ(resetsTold(messages), 0) << "there is no picture again yet";
  // The editor goes on without a picture.
  change(0.87F);
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  test::mendDriver();
  moveAway();
  ASSERT_TRUE(toldOf(messages));
  EXPECT_LT(meanDifference(before, picture()), 0.5F);
  EXPECT_TRUE(QTest::qWaitFor([this] { return problem()->isHidden(); }, kPatienceMs));
  EXPECT_EQ(resetsTold(messages), 1);
}

TEST_F(LostContext, AViewportMayGoWhileItsContextIsLost) {
  for (const bool settled : {true, false}) {
    Viewport second(document());
    second.setTargetSamples(1);
    second.resize(240, 180);
    second.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&second, kPatienceMs));
    if (settled) {
      ASSERT_TRUE(QTest::qWaitFor([&] { return second.isSettled(); }, kPatienceMs));
    }
    QSignalSpy messages(&second, &Viewport::message);
    test::breakDriver();
    second.requestFrame();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !second.glInfo().has_value(); }, kPatienceMs));
  }
  test::mendDriver();
}

/// By itself in processes of its own, with drivers that offer too little: there `DERMIS_TEST_PROBLEM` is what the
/// viewport has to say.
TEST_F(LostContext, WithThisDriverAllButThePictureWorks) {
  const QString expected = qEnvironmentVariable("DERMIS_TEST_PROBLEM");
  if (expected.isEmpty()) {
    picture();
    EXPECT_TRUE(problem()->isHidden());
  } else {
    ASSERT_TRUE(QTest::qWaitFor([&] { return problem()->text().contains(expected); }, kPatienceMs))
        << problem()->text().toStdString();
    EXPECT_TRUE(problem()->isVisible());
    EXPECT_EQ(problem()->text().count(QStringLiteral(". ")), 0) << "one sentence";
    EXPECT_FALSE(viewport()->glInfo().has_value());
    EXPECT_TRUE(viewport()->picture().isNull());
    EXPECT_FALSE(viewport()->readPixel({10.0, 10.0}).has_value());
    viewport()->cancelJobs();
  }
  // Hands on the picture, and on everything else.
  drag(viewport(), viewport()->rect().center(), 60);
  QTest::keyClick(viewport(), Qt::Key_B);
  viewport()->setAov(Aov::Beauty);
  work();
  EXPECT_EQ(undo().count(), 2);
  undo().undo();
  EXPECT_EQ(undo().index(), 1);
  const QTemporaryDir folder;
  const std::filesystem::path file = folder.filePath(QStringLiteral("kept.dermis")).toStdString();
  ASSERT_TRUE(window->loading().saveScene(file));
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::filesystem::exists(file) && !document().isModified(); }, kPatienceMs));
  window->resize(window->size() - QSize(40, 30));
  QTest::qWait(200);
  window->resize(window->size() + QSize(40, 30));
}

TEST(NoPicture, TheViewportSaysWhyAndAllElseWorks) {
  const QString filter = QStringLiteral("LostContext.WithThisDriverAllButThePictureWorks");
  EXPECT_TRUE(test::passesWith({{"MESA_GL_VERSION_OVERRIDE", QStringLiteral("4.1")},
                                {"DERMIS_TEST_PROBLEM", QStringLiteral("OpenGL 4.5 is needed")}},
                               filter, 1, 2 * kPatienceMs));
}

/// Qt has no window at all to give where it can make no context: it ends in its own code.
TEST(NoPicture, WithoutAnyOpenGlTheProgramSaysSo) {
  QProcess program;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("QT_XCB_GL_INTEGRATION"), QStringLiteral("none"));
  program.setProcessEnvironment(environment);
  program.setProcessChannelMode(QProcess::MergedChannels);
  program.start(QCoreApplication::applicationDirPath() + QStringLiteral("/dermis"));
  QByteArray said;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        said += program.readAll();
        return said.contains("dermis: OpenGL can't be used");
      },
      kPatienceMs))
      << said.constData();
  // It waits for whoever has started it with the mouse to read the same.
  QTest::qWait(300);
  EXPECT_EQ(program.state(), QProcess::Running) << said.constData();
  program.kill();
  program.waitForFinished(kPatienceMs);
}

}  // namespace
}  // namespace dermis
