// Unsaved work survives: kill -9 at any moment, several editors at once, folders that can't be written.
#include <signal.h>
#include <sys/resource.h>

#include <QDateTime>
#include <QListWidget>
#include <QProcess>
#include <QPushButton>
#include <QRandomGenerator>
#include <QTimer>

#include "core/scene/scene_io.h"
#include "ui/dialogs/recovery_dialog.h"
#include "ui/edit_until_killed.h"
#include "ui/editor_fixture.h"
#include "ui/main_window/safety_net.h"

namespace dermis {
namespace {

namespace fs = std::filesystem;

class Recovering : public Editor {
 protected:
  void SetUp() override {
    Editor::SetUp();
    autosave().setIntervalMs(20);
  }
  void TearDown() override {
    autosave().setIntervalMs(Autosave::kDefaultIntervalMs);
    window->loading().newScene();  // nothing unsaved is left behind
    EXPECT_TRUE(waitIdle());
    Warnings warnings;
    for (const LostWork& work : findLostWork(recoveryFolder(), warnings)) discardLostWork(work);
  }
  static Autosave& autosave() { return window->safetyNet()->autosave(); }

  /// Adds a lamp of that name and waits until the work is safe.
  void edit(const char* name) {
    Light light;
    light.name = name;
    document().addLight(light);
    // What was on its way before may be written once more first.
    const auto isSafe = [&] {
      Warnings warnings;
      const Result<Recovery> kept = loadRecovery(autosave().file(), warnings);
      return kept && !kept->scene.lights.empty() && kept->scene.lights.back().name == name;
    };
    ASSERT_TRUE(QTest::qWaitFor(isSafe, kPatienceMs));
  }
  /// What another editor would leave after a crash.
  static void leaveBehind(const char* lamp, const fs::path& scenePath, std::int64_t when) {
    Recovery recovery;
    recovery.scene.model.builtin = "plane";
    recovery.scene.lights.emplace_back().name = lamp;
    recovery.scenePath = scenePath;
    recovery.savedAtMilliseconds = when;
    fs::create_directories(recoveryFolder());
    ASSERT_TRUE(saveRecovery(recoveryFolder() / (std::string(lamp) + ".dermis"), recovery));
  }
  /// Presses one button after another, each on the question that is there next.
  static void answer(const QStringList& buttons) {
    auto* hand = new QTimer(window.get());
    QObject::connect(hand, &QTimer::timeout, [hand, left = buttons]() mutable {
      auto* dialog = qobject_cast<RecoveryDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      auto* button = dialog->findChild<QPushButton*>(QStringLiteral("recovery.") + left.takeFirst());
      if (left.isEmpty()) hand->deleteLater();
      button->click();
    });
    hand->start(30);
  }
};

TEST_F(Recovering, WorkIsKeptWhileItIsUnsavedAndNoLonger) {
  EXPECT_TRUE(autosave().file().empty());
  edit("first");
  const fs::path file = autosave().file();
  Warnings warnings;
  const Result<Recovery> kept = loadRecovery(file, warnings);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_TRUE(warnings.empty());
  ASSERT_FALSE(kept->scene.lights.empty());
  EXPECT_EQ(kept->scene.lights.back().name, "first");
  EXPECT_TRUE(kept->scenePath.empty());
  // This editor runs: nobody may take its work for lost.
  EXPECT_TRUE(findLostWork(recoveryFolder(), warnings).empty());
  undo().undo();
  EXPECT_FALSE(fs::exists(file));
  edit("second");
  const QTemporaryDir folder;
  ASSERT_TRUE(window->loading().saveScene(folder.filePath(QStringLiteral("look.dermis")).toStdString()));
  EXPECT_TRUE(autosave().file().empty());
  EXPECT_TRUE(fs::is_empty(recoveryFolder()));
}

TEST_F(Recovering, LostWorkIsOfferedAndOpensAsUnsavedWork) {
  leaveBehind("lost", "/somewhere/face.dermis", 1000);
  answer({QStringLiteral("recover")});
  window->safetyNet()->offerLostWork();
  ASSERT_TRUE(waitIdle());
  ASSERT_EQ(document().scene().lights.size(), 1U);
  EXPECT_EQ(document().scene().lights[0].name, "lost");
  EXPECT_EQ(document().path(), fs::path("/somewhere/face.dermis"));
  EXPECT_TRUE(document().isModified());
  EXPECT_EQ(undo().count(), 0);
  // It goes on in the same file, so that there is no moment without one.
  EXPECT_EQ(autosave().file(), recoveryFolder() / "lost.dermis");
  Warnings warnings;
  EXPECT_TRUE(findLostWork(recoveryFolder(), warnings).empty());
}

TEST_F(Recovering, LaterKeepsDeleteDeletes) {
  leaveBehind("older", {}, 1000);
  leaveBehind("newer", {}, 2000);
  answer({QStringLiteral("later")});
  window->safetyNet()->offerLostWork();
  Warnings warnings;
  {
    const std::vector<LostWork> both = findLostWork(recoveryFolder(), warnings);
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[0].recovery.scene.lights[0].name, "newer");
  }
  answer({QStringLiteral("discard"), QStringLiteral("later")});
  window->safetyNet()->offerLostWork();
  const std::vector<LostWork> left = findLostWork(recoveryFolder(), warnings);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].recovery.scene.lights[0].name, "older");
}

TEST_F(Recovering, AFullDiskIsToldAndTheLastCompleteFileStays) {
  edit("safe");
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto oldHandler = signal(SIGXFSZ, SIG_IGN);
  rlimit full = before;
  full.rlim_cur = 64;  // as if the disk had no room for more
  QSignalSpy told(&autosave(), &Autosave::message);
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  Light light;
  light.name = "too much";
  document().addLight(light);
  const bool heard = QTest::qWaitFor([&] { return !told.isEmpty(); }, kPatienceMs);
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, oldHandler);
  ASSERT_TRUE(heard);
  Warnings warnings;
  Result<Recovery> kept = loadRecovery(autosave().file(), warnings);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_EQ(kept->scene.lights.back().name, "safe");
  // There is room again: it goes on without another edit.
  QSignalSpy written(&autosave(), &Autosave::written);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !written.isEmpty(); }, kPatienceMs));
  kept = loadRecovery(autosave().file(), warnings);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->scene.lights.back().name, "too much");
}

TEST_F(Recovering, AFolderThatCannotBeMadeIsToldOnce) {
  Autosave elsewhere(document(), "/proc/nowhere");
  elsewhere.setIntervalMs(10);
  QSignalSpy told(&elsewhere, &Autosave::message);
  document().addLight(Light{});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !told.isEmpty(); }, kPatienceMs));
  EXPECT_TRUE(told[0][1].toString().contains(QStringLiteral("/proc/nowhere")));
  QTest::qWait(100);
  EXPECT_EQ(told.size(), 1);
}

/// Editors that run side by side and are all killed; DERMIS_KILLS says how many (CI: a few).
TEST(Killed, TheLastCompleteSaveOpensAndAtMostFiveSecondsAreLost) {
  constexpr int kAtOnce = 6;
  constexpr int kIntervals[] = {1, 300};  // half of them write as often as they can: many are hit while they do
  constexpr qint64 kNoiseMs = 1500;       // a busy machine
  static_assert(Autosave::kDefaultIntervalMs + kNoiseMs <= 5000);
  const int kills = std::max(
      1, qEnvironmentVariableIntValue("DERMIS_KILLS") > 0 ? qEnvironmentVariableIntValue("DERMIS_KILLS") : kAtOnce);
  qint64 mostLost = 0;
  int recovered = 0;
  for (int done = 0; done < kills; done += kAtOnce) {
    const QTemporaryDir folder;
    const fs::path lost = folder.filePath(QStringLiteral("recovery")).toStdString();
    std::vector<std::unique_ptr<QProcess>> editors;
    std::vector<fs::path> files;
    for (int i = 0; i < std::min(kAtOnce, kills - done); ++i) {
      files.emplace_back(folder.filePath(QStringLiteral("look%1.dermis").arg(i)).toStdString());
      auto editor = std::make_unique<QProcess>();
      editor->start(QCoreApplication::applicationFilePath(),
                    {QLatin1String(kEditUntilKilled), QString::fromStdString(lost.string()),
                     QString::fromStdString(files.back().string()), QString::number(kIntervals[i % 2])});
      editors.push_back(std::move(editor));
    }
    for (const auto& editor : editors) ASSERT_TRUE(editor->waitForStarted());
    std::vector<qint64> endedAt;
    std::vector<QByteArray> said;
    for (const auto& editor : editors) {
      ASSERT_TRUE(editor->waitForReadyRead(kPatienceMs));
      QTest::qSleep(QRandomGenerator::global()->bounded(20, 600));
      editor->kill();  // SIGKILL
      editor->waitForFinished();
      endedAt.push_back(QDateTime::currentMSecsSinceEpoch());
      said.push_back(editor->readAllStandardOutput());
    }

    Warnings warnings;
    const std::vector<LostWork> found = findLostWork(lost, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    recovered += static_cast<int>(found.size());
    for (std::size_t i = 0; i < editors.size(); ++i) {
      int kept = 0, saved = 0;
      for (const QByteArray& line : said[i].split('\n'))
        if (line.startsWith("saved ")) saved = line.mid(6).toInt();
      if (fs::exists(files[i])) {
        const Result<Scene> scene = loadScene(files[i], warnings);
        ASSERT_TRUE(scene) << scene.error().message;
        kept = std::stoi(scene->lights.at(0).name);
      }
      EXPECT_GE(kept, saved);
      for (const LostWork& work : found)
        if (work.recovery.scene.name == files[i].string())
          kept = std::max(kept, std::stoi(work.recovery.scene.lights.at(0).name));
      qint64 firstLost = endedAt[i];
      for (const QByteArray& line : said[i].split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words.size() == 3 && words[0] == "edit" && words[1].toInt() == kept + 1) firstLost = words[2].toLongLong();
      }
      EXPECT_LE(endedAt[i] - firstLost, kIntervals[i % 2] + kNoiseMs);
      mostLost = std::max(mostLost, endedAt[i] - firstLost);
    }
  }
  RecordProperty("most_lost_ms", std::to_string(mostLost));
  std::printf("%d editors killed, %d left unsaved work, at most %lld ms of edits lost\n", kills, recovered,
              static_cast<long long>(mostLost));
  EXPECT_GT(recovered, 0);
}

}  // namespace
}  // namespace dermis
