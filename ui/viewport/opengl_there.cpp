#include "ui/viewport/opengl_there.h"

#include <QCoreApplication>
#include <QOpenGLContext>

namespace dermis {

QString openGlProblem() {
  QOpenGLContext context;
  if (context.create()) return {};
  return QCoreApplication::translate("start",
                                     "OpenGL can't be used on this display; install a graphics driver, or use a "
                                     "command such as \"dermis render\".");
}

}  // namespace dermis
