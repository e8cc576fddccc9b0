#include "app/gui.h"

#include <dlfcn.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <QApplication>
#include <QMessageBox>
#include <QSurfaceFormat>
#include <QTimer>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "app/commands/look.h"
#include "app/commands/metadata.h"
#include "core/base/background.h"
#include "core/io/udim.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/safety_net.h"
#include "ui/preferences/preferences.h"
#include "ui/theme/theme.h"
#include "ui/translation.h"
#include "ui/viewport/opengl_there.h"

namespace dermis {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// Whether an X server answers at $DISPLAY. Through libxcb, which Qt's own platform plugin needs anyway, but without
/// linking it: the command line must start where no window system is installed.
bool xServerAnswers() {
  if (variable("DISPLAY").empty()) return false;
  void* library = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return false;
  struct Connection;
  using Connect = Connection* (*)(const char*, int*);
  using HasError = int (*)(Connection*);
  using Disconnect = void (*)(Connection*);
  const auto connect = reinterpret_cast<Connect>(dlsym(library, "xcb_connect"));
  const auto hasError = reinterpret_cast<HasError>(dlsym(library, "xcb_connection_has_error"));
  const auto disconnect = reinterpret_cast<Disconnect>(dlsym(library, "xcb_disconnect"));
  bool answers = false;
  if (connect != nullptr && hasError != nullptr && disconnect != nullptr) {
    Connection* connection = connect(nullptr, nullptr);
    answers = connection != nullptr && hasError(connection) == 0;
    disconnect(connection);
  }
  return answers;
}

bool waylandAnswers() {
  const std::string name = variable("WAYLAND_DISPLAY");
  if (name.empty()) return false;
  const std::string path = name.front() == '/' ? name : variable("XDG_RUNTIME_DIR") + "/" + name;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return false;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const int handle = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (handle < 0) return false;
  const bool answers = ::connect(handle, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(handle);
  return answers;
}

/// Asked before QApplication, which would abort the process. Other platforms (offscreen, vnc) are the caller's choice.
bool displayReachable() {
  const std::string platform = variable("QT_QPA_PLATFORM");
  if (!platform.empty() && !platform.starts_with("xcb") && !platform.starts_with("wayland")) return true;
  return xServerAnswers() || waylandAnswers();
}

std::map<std::string, std::string> metadataOf(const ResolvedScene& scene, const PictureRequest& request,
                                              const std::string& glRenderer) {
  cli::Look look;
  look.resolved = scene;
  look.folder = request.sceneFolder;
  const auto read = [&](const std::string& path) {
    if (!path.empty() && path.find(':') == std::string::npos) look.inputs.emplace_back(path);
  };
  read(scene.scene.model.path);
  read(scene.scene.environment.path);
  for (const ResolvedMaterial& slot : scene.slots)
    for (const TextureBinding& texture : slot.material.textures) {
      const std::vector<UdimTile> tiles = udimTiles(texture.path);
      if (tiles.empty()) read(texture.path);
      for (const UdimTile& tile : tiles) read(tile.file.string());
    }
  return cli::pictureMetadata(
      look, {request.size, request.samples, scene.scene.view.transform, glRenderer, {}, request.references});
}

}  // namespace

int runEditor(int& argc, char** argv, const std::vector<std::filesystem::path>& files) {
  if (!displayReachable()) {
    std::fputs(
        "dermis: no display can be reached; set DISPLAY or WAYLAND_DISPLAY, or use a command such as \"dermis "
        "render\"\n",
        stderr);
    return 1;
  }
  putPicturesFirst();
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(0);
  format.setSwapInterval(1);
  format.setOption(QSurfaceFormat::ResetNotification);  // a driver that was reset says so, and the picture is made anew
  QSurfaceFormat::setDefaultFormat(format);
  QApplication::setOrganizationName(QStringLiteral("Dermis"));
  QApplication::setApplicationName(QStringLiteral("dermis"));
  QApplication::setApplicationDisplayName(QString());
  QApplication::setApplicationVersion(QStringLiteral(DERMIS_VERSION));
  // Qt reads it once, before there is a screen. What the environment says stands above what is stored.
  if (variable("QT_SCALE_FACTOR").empty() && storedInterfaceScale() != 1.0)
    qputenv("QT_SCALE_FACTOR", QByteArray::number(storedInterfaceScale()));
  QApplication application(argc, argv);
  // QApplication adopts the user's locale; a decimal comma must not reach strtod in any library below us.
  std::setlocale(LC_NUMERIC, "C");
  loadTranslation(application, QLocale(), translationFolder());
  applyTheme(application, Preferences().values().theme);
  if (const QString problem = openGlProblem(); !problem.isEmpty()) {
    std::fprintf(stderr, "dermis: %s\n", qPrintable(problem));
    QMessageBox::critical(nullptr, QStringLiteral("Dermis"), problem);
    return 1;
  }

  MainWindow window;
  window.setPictureMetadata(metadataOf);
  window.show();
  window.open(files);
  QTimer::singleShot(0, &window, [&window] { window.safetyNet()->offerLostWork(); });
  return QApplication::exec();
}

}  // namespace dermis
