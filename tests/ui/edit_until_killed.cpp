#include "ui/edit_until_killed.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QTimer>
#include <cstdio>
#include <string>

#include "core/io/asset_loader.h"
#include "core/scene/scene_io.h"
#include "ui/document/autosave.h"

namespace dermis {

int editUntilKilled(int argc, char** argv) {
  if (argc < 5) return 2;
  QCoreApplication application(argc, argv);
  Scene scene;
  scene.model.builtin = "plane";
  scene.environment.builtin.clear();
  scene.environment.constant = glm::vec3(1.0F);
  scene.lights = {Light{}};
  scene.name = argv[3];  // so that whoever finds its work knows whose it is
  Warnings warnings;
  const Result<ResolvedScene> resolved = resolveScene(scene, {}, {}, warnings);
  if (!resolved) return 1;
  Document document;
  document.replace(*resolved, {});
  Autosave autosave(document, argv[2]);
  autosave.setIntervalMs(std::stoi(argv[4]));
  const std::filesystem::path file = argv[3];

  int edit = 0;
  QTimer hand;
  QObject::connect(&hand, &QTimer::timeout, [&] {
    ++edit;
    std::printf("edit %d %lld\n", edit, static_cast<long long>(QDateTime::currentMSecsSinceEpoch()));
    std::fflush(stdout);
    Light light;
    light.name = std::to_string(edit);
    document.setLight(0, light, QStringLiteral("Name"), 0);
    if (edit % 40 != 0) return;
    if (!saveScene(file, document.sceneForSaving())) return;
    std::printf("saved %d\n", edit);
    std::fflush(stdout);
    if (edit % 80 == 0) document.markSaved(file);  // then the unsaved work's file goes, and comes again
  });
  hand.start(4);
  return QCoreApplication::exec();
}

}  // namespace dermis
