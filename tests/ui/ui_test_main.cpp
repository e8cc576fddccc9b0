// Starts Qt once for all tests of the editor: a screen, OpenGL 4.5 core, and settings of their own.
#include <gtest/gtest.h>

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <clocale>
#include <cstdio>
#include <cstring>

#include "core/base/background.h"
#include "ui/drag_source.h"
#include "ui/edit_until_killed.h"
#include "ui/editor_fixture.h"
#include "ui/theme/theme.h"

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], dermis::kEditUntilKilled) == 0) return dermis::editUntilKilled(argc, argv);
  if (argc > 1 && std::strcmp(argv[1], dermis::kDragSource) == 0) return dermis::dragSource(argc, argv);
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    std::fputs("these tests need an X server (Xvfb -screen 0 1600x1000x24 +extension GLX)\n", stderr);
    return 1;
  }
  const QTemporaryDir home;
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"}) qputenv(name, home.path().toUtf8());
  dermis::putPicturesFirst();  // as the program does
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setOption(QSurfaceFormat::ResetNotification);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setOrganizationName(QStringLiteral("Dermis"));
  QApplication::setApplicationName(QStringLiteral("dermis-tests"));
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  dermis::applyTheme(application);
  const int result = RUN_ALL_TESTS();
  dermis::closeEditor();
  return result;
}
