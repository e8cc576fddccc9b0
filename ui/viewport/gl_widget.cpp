#include "ui/viewport/gl_widget.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QPaintEvent>
#include <QPainter>
#include <QSurfaceFormat>
#include <QTimer>
#include <cmath>
#include <utility>

namespace dermis {

class GlWidget::Surface {
 public:
  explicit Surface(GlWidget& host) : m_host(host) {}
  virtual ~Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  [[nodiscard]] virtual Hosting hosting() const = 0;
  [[nodiscard]] virtual QOpenGLContext* context() const = 0;
  virtual void makeCurrent() = 0;
  virtual void doneCurrent() = 0;
  [[nodiscard]] virtual unsigned framebuffer() const = 0;
  virtual void requestFrame() = 0;
  virtual QImage grabFrame() = 0;
  virtual void renewContext() = 0;
  virtual void paint() = 0;
  virtual void resize() = 0;

 protected:
  GlWidget& m_host;
};

// --- composed: a QOpenGLWidget fills the host, below all that lies over the picture

class GlWidget::ComposedSurface final : public Surface {
 public:
  explicit ComposedSurface(GlWidget& host) : Surface(host), m_inner(new Inner(host)) {
    // Gestures, keys and the name are the host's.
    m_inner->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_inner->setFocusPolicy(Qt::NoFocus);
    connect(m_inner, &QOpenGLWidget::frameSwapped, &host, &GlWidget::frameShown);
  }
  // Before the host's other children go: the context may still be wanted until then, and not after.
  ~ComposedSurface() override { delete m_inner; }

  [[nodiscard]] Hosting hosting() const override { return Hosting::Composed; }
  [[nodiscard]] QOpenGLContext* context() const override { return m_inner->context(); }
  void makeCurrent() override { m_inner->makeCurrent(); }
  void doneCurrent() override { m_inner->doneCurrent(); }
  [[nodiscard]] unsigned framebuffer() const override { return m_inner->defaultFramebufferObject(); }
  void requestFrame() override { m_inner->update(); }
  QImage grabFrame() override {
    m_inner->update();  // shows what is drawn here, if nothing else asks for it
    return m_inner->grabFramebuffer();
  }
  void renewContext() override {
    // Where Qt has noticed that the context is lost, it makes another by itself.
    if (context() == nullptr || !context()->isValid()) return;
    // What Qt tells a widget that moves to another window, where it cannot keep its context.
    for (const QEvent::Type type : {QEvent::WindowAboutToChangeInternal, QEvent::WindowChangeInternal}) {
      QEvent event(type);
      QCoreApplication::sendEvent(m_inner, &event);
    }
    m_inner->update();
  }
  void paint() override {}
  void resize() override { m_inner->setGeometry(m_host.rect()); }

 private:
  class Inner final : public QOpenGLWidget {
   public:
    explicit Inner(GlWidget& host) : QOpenGLWidget(&host), m_host(host) {}

   protected:
    void initializeGL() override { m_host.initializeGL(); }
    void paintGL() override { m_host.paintGL(); }

   private:
    GlWidget& m_host;
  };

  Inner* m_inner;
};

// --- copied: a framebuffer of its own, read back and painted

class GlWidget::CopiedSurface final : public Surface {
 public:
  explicit CopiedSurface(GlWidget& host) : Surface(host) { host.setAttribute(Qt::WA_OpaquePaintEvent); }
  ~CopiedSurface() override { leave(); }

  [[nodiscard]] Hosting hosting() const override { return Hosting::Copied; }
  [[nodiscard]] QOpenGLContext* context() const override { return m_context; }
  void makeCurrent() override {
    if (m_context != nullptr) m_context->makeCurrent(&m_surface);
  }
  void doneCurrent() override {
    if (m_context != nullptr) m_context->doneCurrent();
  }
  [[nodiscard]] unsigned framebuffer() const override { return m_target ? m_target->handle() : 0; }
  void requestFrame() override {
    m_wanted = true;
    m_host.update();
  }
  QImage grabFrame() override {
    draw();
    m_host.update();
    return m_picture;
  }
  void renewContext() override {
    leave();
    enter();
    requestFrame();
  }
  void paint() override {
    if (m_wanted || m_picture.size() != pixels()) draw();
    // What is painted now is in the window when the event loop goes on. A frame drawn to be grabbed is shown as well.
    if (std::exchange(m_isNew, false)) QTimer::singleShot(0, &m_host, &GlWidget::frameShown);
    QPainter painter(&m_host);
    if (m_picture.isNull())
      painter.fillRect(m_host.rect(), Qt::black);
    else
      painter.drawImage(QPointF(), m_picture);
  }
  void resize() override {
    enter();  // before there is something to paint: what goes wrong is told in widgets
    requestFrame();
  }

 private:
  [[nodiscard]] QSize pixels() const {
    const double ratio = m_host.devicePixelRatioF();
    return {static_cast<int>(std::lround(m_host.width() * ratio)),
            static_cast<int>(std::lround(m_host.height() * ratio))};
  }
  bool enter() {
    if (m_context != nullptr) return m_context->isValid();
    if (!m_surface.isValid()) {
      m_surface.setFormat(QSurfaceFormat::defaultFormat());
      m_surface.create();
    }
    m_context = new QOpenGLContext(&m_host);
    if (!m_context->create() || !m_context->makeCurrent(&m_surface)) return false;
    m_host.initializeGL();
    return true;
  }
  void leave() {
    if (m_context == nullptr) return;
    if (m_context->isValid()) m_context->makeCurrent(&m_surface);
    m_target.reset();
    delete m_context;  // tells that it goes while context() still answers
    m_context = nullptr;
  }
  void draw() {
    m_wanted = false;
    if (!enter() || !m_context->makeCurrent(&m_surface)) {
      if (!m_context->isValid()) m_host.contextLost();
      return;
    }
    if (!m_target || m_target->size() != pixels()) m_target = std::make_unique<QOpenGLFramebufferObject>(pixels());
    m_host.paintGL();
    m_target->bind();
    m_picture = m_target->toImage();
    m_picture.reinterpretAsFormat(QImage::Format_RGB32);  // alpha is no business of the window's
    m_picture.setDevicePixelRatio(m_host.devicePixelRatioF());
    m_isNew = true;
    m_context->doneCurrent();
  }

  QOffscreenSurface m_surface;
  QOpenGLContext* m_context = nullptr;  // the host's child
  std::unique_ptr<QOpenGLFramebufferObject> m_target;
  QImage m_picture;
  bool m_wanted = true;
  bool m_isNew = false;  ///< drawn and not painted yet
};

// --- either of them

GlWidget::GlWidget(Hosting hosting, QWidget* parent) : QWidget(parent) {
  if (hosting == Hosting::Composed)
    m_surface = std::make_unique<ComposedSurface>(*this);
  else
    m_surface = std::make_unique<CopiedSurface>(*this);
}

GlWidget::~GlWidget() = default;

Hosting GlWidget::hosting() const { return m_surface->hosting(); }

QOpenGLContext* GlWidget::context() const { return m_surface->context(); }

void GlWidget::makeCurrent() { m_surface->makeCurrent(); }

void GlWidget::doneCurrent() { m_surface->doneCurrent(); }

unsigned GlWidget::framebuffer() const { return m_surface->framebuffer(); }

void GlWidget::requestFrame() { m_surface->requestFrame(); }

QImage GlWidget::grabFrame() { return m_surface->grabFrame(); }

void GlWidget::renewContext() { m_surface->renewContext(); }

void GlWidget::paintEvent(QPaintEvent*) { m_surface->paint(); }

void GlWidget::resizeEvent(QResizeEvent*) { m_surface->resize(); }

}  // namespace dermis
