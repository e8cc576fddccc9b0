#include "ui/viewport/opengl_there.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include "renderer.h"

namespace dermis {
namespace {

struct OpenGlThere {
  bool any = false;
  Hosting hosting = Hosting::Composed;
};

OpenGlThere ask() {
  OpenGlThere there;
  QOpenGLContext context;
  there.any = context.create();
  const QString wish = qEnvironmentVariable("DERMIS_HOSTING");
  if (wish == QStringLiteral("copied")) there.hosting = Hosting::Copied;
  if (!there.any || wish == QStringLiteral("copied") || wish == QStringLiteral("composed")) return there;
  QOffscreenSurface surface;
  surface.setFormat(QSurfaceFormat::defaultFormat());
  surface.create();
  if (!context.makeCurrent(&surface)) return there;
  if (currentGlInfo("widget").software) there.hosting = Hosting::Copied;
  context.doneCurrent();
  return there;
}

/// Asked once: drivers don't change while the program runs.
const OpenGlThere& openGlThere() {
  static const OpenGlThere there = ask();
  return there;
}

}  // namespace

QString openGlProblem() {
  if (openGlThere().any) return {};
  return QCoreApplication::translate("start",
                                     "OpenGL can't be used on this display; install a graphics driver, or use a "
                                     "command such as \"dermis render\".");
}

Hosting hostingHere() { return openGlThere().hosting; }

}  // namespace dermis
