// The graphics card under the picture: the renderer is made with each context, and given up with it or when the driver
// takes the context away.
#include <QOpenGLContext>
#include <utility>

#include "core/io/disk_cache.h"
#include "ui/text.h"
#include "ui/viewport/compared_picture.h"
#include "ui/viewport/model_picker.h"
#include "ui/viewport/viewport.h"

namespace dermis {

void Viewport::initializeGL() {
  // Called again with a fresh context, for example when a window is torn off: everything on the GPU is made anew.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::leaveContext, Qt::UniqueConnection);
  m_askReset = reinterpret_cast<AskReset>(context()->getProcAddress("glGetGraphicsResetStatus"));
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create(rendererOptions());
  if (!renderer) {
    const QString sentence = text(renderer.error().message);
    showProblem(tr("There is no picture: %1").arg(sentence));
    Q_EMIT message(MessageKind::Error, sentence);
    m_picker->begin();  // there will be no first picture to wait for
    return;
  }
  m_renderer = std::move(*renderer);
  m_pace = firstPace();
  m_drawn.reset();
  m_firstFrame = true;
}

RendererOptions Viewport::rendererOptions() const {
  RendererOptions options;
  options.cacheFolder = userCacheFolder("bakes");
  options.bakeMeshes = true;
  options.platform = "widget";
  return options;
}

void Viewport::releaseRenderer() {
  if (!m_renderer) return;
  makeCurrent();
  if (contextIsLost()) return letGo();
  m_compared.reset();
  m_renderer.reset();
  doneCurrent();
}

void Viewport::leaveContext() {
  if (m_renderer && contextIsLost()) loseRenderer();
  releaseRenderer();
}

void Viewport::letGo() {
  static_cast<void>(m_compared.release());
  static_cast<void>(m_renderer.release());
  m_jobsLeft = false;
}

bool Viewport::contextIsLost() const {
  if (context() == nullptr || !context()->isValid()) return true;
  // Qt asks the driver by itself where the window system is X11 with GLX, and nowhere else.
  return m_askReset != nullptr && QOpenGLContext::currentContext() == context() && m_askReset() != 0;
}

bool Viewport::takeContext() {
  makeCurrent();
  if (!contextIsLost()) return true;
  loseRenderer();
  return false;
}

void Viewport::loseRenderer() {
  letGo();
  // Lost before there was a picture again: another context would be lost as well.
  const bool again = std::exchange(m_contextWasLost, true);
  // From the event loop: a widget doesn't show its children while it paints.
  QMetaObject::invokeMethod(
      this,
      [this, again] {
        Q_EMIT jobProgress(QString(), 0.0);
        if (!m_contextWasLost) return;
        showProblem(
            tr("The graphics driver was reset. If the picture doesn't come back, save the scene and start Dermis "
               "again."));
        if (!again) renewContext();
      },
      Qt::QueuedConnection);
}

void Viewport::contextLost() {
  if (m_renderer) loseRenderer();
}

void Viewport::tellReset() {
  QMetaObject::invokeMethod(
      this,
      [this] {
        Q_EMIT message(MessageKind::Warning,
                       tr("The graphics driver was reset and the picture is made anew; the scene has lost nothing."));
      },
      Qt::QueuedConnection);
}

}  // namespace dermis
