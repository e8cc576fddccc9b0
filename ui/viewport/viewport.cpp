#include "ui/viewport/viewport.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QStandardPaths>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/cameras.h"
#include "ui/document/document.h"
#include "ui/text.h"
#include "ui/viewport/legend.h"
#include "ui/viewport/navigation.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/view_modes.h"

namespace dermis {
namespace {

constexpr double kJobSliceMs = 8.0;
constexpr int kStillAfterMs = 120;  // full resolution within 150 ms of the last change
constexpr int kEdge = 10;

}  // namespace

Viewport::Viewport(Document& document, QWidget* parent) : QOpenGLWidget(parent), m_document(document) {
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("Viewport"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setMouseTracking(false);
  m_statistics = new OverlayLabel(this);
  m_statistics->setObjectName(QStringLiteral("viewport.statistics"));
  m_statistics->setAccessibleName(tr("Statistics"));
  m_viewName = new OverlayLabel(this);
  m_viewName->setObjectName(QStringLiteral("viewport.viewName"));
  m_viewName->hide();
  m_legend = new Legend(this);
  m_scaleBar = new ScaleBar(this);
  m_problem = new QLabel(this);
  m_problem->setObjectName(QStringLiteral("viewport.problem"));
  m_problem->setAlignment(Qt::AlignCenter);
  m_problem->setWordWrap(true);
  m_problem->setMargin(60);
  m_problem->setStyleSheet(QStringLiteral("background: #242424; color: #b8b8b8;"));
  showProblem(tr("Preparing the picture…"));
  m_clock.start();

  m_next.setSingleShot(true);
  connect(&m_next, &QTimer::timeout, this, [this] {
    if (m_jobsLeft)
      continueJobs();
    else
      update();
  });
  m_still.setSingleShot(true);
  m_still.setInterval(kStillAfterMs);
  connect(&m_still, &QTimer::timeout, this, &Viewport::still);
  m_fly.setInterval(16);
  connect(&m_fly, &QTimer::timeout, this, &Viewport::flyStep);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    if (what != Change::Everything) moving();
    refreshLegend();
    update();
  });
  connect(this, &QOpenGLWidget::frameSwapped, this, [this] {
    if (!m_frameClock.isValid()) return;
    const double milliseconds = static_cast<double>(m_frameClock.nsecsElapsed()) * 1e-6;
    m_frameClock.invalidate();
    if (m_wasMoving) m_pace.measured(milliseconds);
    refreshStatistics(milliseconds);
  });
}

Viewport::~Viewport() { releaseRenderer(); }

// --- the picture
// ------------------------------------------------------------------------------------------------------

void Viewport::initializeGL() {
  // Called again with a fresh context, for example when a window is torn off: everything on the GPU is made anew.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseRenderer, Qt::UniqueConnection);
  RendererOptions options;
  options.cacheFolder =
      toPath(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/environments"));
  options.bakeMeshes = true;
  options.platform = "widget";
  Result<std::unique_ptr<Renderer>> renderer = Renderer::create(options);
  if (!renderer) {
    const QString sentence = text(renderer.error().message);
    showProblem(tr("There is no picture: %1").arg(sentence));
    Q_EMIT message(MessageKind::Error, sentence);
    return;
  }
  m_renderer = std::move(*renderer);
  m_drawn.reset();
  m_firstFrame = true;
}

void Viewport::releaseRenderer() {
  if (!m_renderer) return;
  makeCurrent();
  m_renderer.reset();
  doneCurrent();
}

void Viewport::paintGL() {
  if (!m_renderer) return;
  const std::shared_ptr<const ResolvedScene> scene = m_document.snapshot();
  if (!scene) return;
  if (scene != m_drawn) {
    m_renderer->setScene(scene);
    m_drawn = scene;
  }
  if (m_firstFrame && m_renderer->runJobs(kJobSliceMs) && !m_renderer->drawable()) {
    // Nothing to show yet; the window answers while programs and environment are made.
    m_jobsLeft = true;
    scheduleNext();
    return;
  }
  drawFrame();
  // A slice of what is queued; when it was the last one, the picture is drawn again with what it made.
  const bool queued = !m_renderer->jobProgress().first.empty();
  m_jobsLeft = m_renderer->runJobs(kJobSliceMs);
  if (queued && !m_jobsLeft)
    m_next.start(0);
  else
    scheduleNext();
}

void Viewport::drawFrame() {
  const double ratio = devicePixelRatioF();
  FrameRequest request;
  request.displaySize = {static_cast<int>(std::lround(width() * ratio)),
                         static_cast<int>(std::lround(height() * ratio))};
  request.size = request.displaySize;
  request.camera = m_document.camera();
  request.view = m_document.scene().view;
  request.aov = m_aov;
  request.withoutSubsurface = m_withoutSubsurface;
  request.moving = m_moving;
  request.targetSamples = animated() ? 1 : m_targetSamples;
  request.seconds = static_cast<double>(m_clock.elapsed()) * 1e-3;
  request.framebuffer = defaultFramebufferObject();
  if (m_moving && m_renderer->glInfo().software) {
    const double scale = m_pace.scale();
    request.size = {std::max(1, static_cast<int>(request.displaySize.x * scale)),
                    std::max(1, static_cast<int>(request.displaySize.y * scale))};
  }
  m_frameClock.start();
  m_wasMoving = m_moving;
  const bool drawn = m_renderer->renderFrame(request);
  if (drawn && m_firstFrame) {
    m_firstFrame = false;
    // Hidden from the event loop: a widget doesn't hide its children while it paints.
    QMetaObject::invokeMethod(m_problem, &QWidget::hide, Qt::QueuedConnection);
  }
  for (const std::string& line : m_renderer->takeMessages()) {
    const QString sentence = text(line);
    QMetaObject::invokeMethod(
        this, [this, sentence] { Q_EMIT message(MessageKind::Warning, sentence); }, Qt::QueuedConnection);
  }
}

bool Viewport::animated() const {
  const auto& lights = m_document.scene().lights;
  return std::any_of(lights.begin(), lights.end(),
                     [](const Light& l) { return l.enabled && l.animation.kind != AnimationKind::None; });
}

void Viewport::scheduleNext() {
  if (m_jobsLeft)
    m_next.start(0);
  else if (!m_moving && animated())
    m_next.start(16);
  else if (!m_moving && m_renderer->accumulating())
    m_next.start(0);
}

void Viewport::continueJobs() {
  if (!m_renderer) return;
  makeCurrent();
  m_jobsLeft = m_renderer->runJobs(kJobSliceMs);
  const auto [what, fraction] = m_renderer->jobProgress();
  // What an earlier job made is shown while another goes on.
  if (m_renderer->drawable() && std::exchange(m_jobText, what) != what) update();
  doneCurrent();
  Q_EMIT jobProgress(m_jobsLeft ? text(what) : QString(), fraction);
  if (m_jobsLeft)
    m_next.start(0);
  else
    update();
}

void Viewport::cancelJobs() {
  if (!m_renderer) return;
  makeCurrent();
  m_renderer->cancelJobs();
  doneCurrent();
  m_jobsLeft = false;
  Q_EMIT jobProgress(QString(), 0.0);
  update();
}

void Viewport::moving() {
  m_moving = true;
  m_still.start();
}

void Viewport::still() {
  m_still.stop();
  m_moving = false;
  update();
}

void Viewport::setAov(Aov aov) {
  if (aov == m_aov) return;
  m_aov = aov;
  refreshViewName();
  Q_EMIT aovChanged(aov);
  update();
}

void Viewport::setWithoutSubsurface(bool without) {
  if (without == m_withoutSubsurface) return;
  m_withoutSubsurface = without;
  refreshViewName();
  Q_EMIT withoutSubsurfaceChanged(without);
  update();
}

void Viewport::refreshViewName() {
  QStringList words;
  if (m_aov != Aov::Beauty) words << viewMode(m_aov).label;
  if (m_withoutSubsurface) words << tr("without subsurface");
  m_viewName->setText(words.join(QStringLiteral(" · ")));
  m_viewName->setAccessibleName(words.isEmpty() ? QString() : tr("Shown: %1").arg(words.join(QStringLiteral(", "))));
  m_viewName->setVisible(!words.isEmpty());
  refreshLegend();
  placeOverlays();
}

void Viewport::refreshLegend() {
  const std::shared_ptr<const ResolvedScene> scene = m_aov == Aov::Beauty ? nullptr : m_document.snapshot();
  const auto range = scene ? valueRange(m_aov, *scene, m_document.camera()) : std::nullopt;
  m_legend->setVisible(range.has_value());
  if (range) m_legend->showRange(viewMode(m_aov).label, *range);
}

void Viewport::setTargetSamples(int samples) {
  m_targetSamples = std::max(1, samples);
  update();
}

void Viewport::setStatisticsVisible(bool visible) { m_statistics->setVisible(visible); }

RenderStatistics Viewport::statistics() const { return m_renderer ? m_renderer->statistics() : RenderStatistics{}; }

std::optional<GlInfo> Viewport::glInfo() const {
  return m_renderer ? std::optional(m_renderer->glInfo()) : std::nullopt;
}

bool Viewport::isSettled() const {
  return m_renderer && !m_firstFrame && !m_jobsLeft && !m_moving && m_drawn == m_document.snapshot() &&
         !m_renderer->accumulating();
}

void Viewport::refreshStatistics(double milliseconds) {
  // A picture that compiled a program or waited for the machine says little of the next one.
  if (m_smoothedMs > 0.0 && (milliseconds > 5.0 * m_smoothedMs || m_smoothedMs > 5.0 * milliseconds))
    m_smoothedMs = 0.0;
  m_smoothedMs = m_smoothedMs <= 0.0 ? milliseconds : 0.8 * m_smoothedMs + 0.2 * milliseconds;
  m_scaleBar->showScale(
      static_cast<double>(navigation::unitsPerPixel(m_document.camera(), static_cast<float>(height()))) *
      static_cast<double>(m_document.millimetresPerUnit()));
  if (!m_statistics->isVisible()) return;
  const RenderStatistics now = m_renderer ? m_renderer->statistics() : RenderStatistics{};
  // Often enough to read, not at every picture: the label is composed with the window.
  const bool last = now.samples >= now.targetSamples;
  if (m_sinceText.isValid() && m_sinceText.elapsed() < 200 && !last) return;
  m_sinceText.start();
  const QString line = QStringLiteral("%1 fps   %2 ms   %3/%4")
                           .arg(1000.0 / std::max(m_smoothedMs, 0.1), 0, 'f', m_smoothedMs > 100.0 ? 1 : 0)
                           .arg(m_smoothedMs, 0, 'f', 1)
                           .arg(now.samples)
                           .arg(now.targetSamples);
  if (line == m_statistics->text()) return;
  m_statistics->setText(line);
  placeOverlays();
}

void Viewport::showProblem(const QString& sentence) {
  m_problem->setText(sentence);
  m_problem->show();
  m_problem->raise();
}

void Viewport::placeOverlays() {
  m_statistics->adjustSize();
  m_statistics->move(width() - m_statistics->width() - kEdge, height() - m_statistics->height() - kEdge);
  m_scaleBar->move(kEdge + 4, height() - m_scaleBar->height() - kEdge);
  m_viewName->adjustSize();
  m_viewName->move(kEdge, kEdge);
  m_legend->move(width() - m_legend->width() - kEdge, kEdge);
  m_problem->setGeometry(rect());
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  placeOverlays();
  Q_EMIT pictureResized(QSize(width(), height()) * devicePixelRatioF());
}

// --- gestures
// ---------------------------------------------------------------------------------------------------------

void Viewport::moveCamera(const Camera& camera) {
  m_document.setCamera(camera);  // tells of a change, and so draws
}

void Viewport::frameAll() {
  if (!m_document.isReady()) return;
  moveCamera(navigation::frame(m_document.camera(), m_document.model()->bounds,
                               static_cast<float>(width()) / static_cast<float>(std::max(height(), 1))));
}

void Viewport::showNamedView(const QString& name) {
  if (!m_document.isReady()) return;
  if (const auto camera = namedCamera(name.toStdString(), m_document.model()->bounds)) moveCamera(*camera);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (!m_document.isReady() || m_drag != Drag::None) return;
  m_last = event->position();
  const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
  switch (event->button()) {
    case Qt::LeftButton:
      m_drag = shift ? Drag::Pan : Drag::Orbit;
      break;
    case Qt::MiddleButton:
      m_drag = Drag::Pan;
      break;
    case Qt::RightButton:
      m_drag = shift ? Drag::TurnEnvironment : Drag::Zoom;
      break;
    default:
      return;
  }
  m_gesture = newGesture();
  setCursor(m_drag == Drag::Pan ? Qt::SizeAllCursor : m_drag == Drag::Zoom ? Qt::SizeVerCursor : Qt::ClosedHandCursor);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag == Drag::None) return;
  const QPointF step = event->position() - m_last;
  m_last = event->position();
  const auto x = static_cast<float>(step.x());
  const auto y = static_cast<float>(step.y());
  constexpr float kRadiansPerPixel = 0.008F;
  const Camera& camera = m_document.camera();
  switch (m_drag) {
    case Drag::Orbit:
      moveCamera(navigation::orbit(camera, x * kRadiansPerPixel, y * kRadiansPerPixel));
      break;
    case Drag::Pan:
      moveCamera(navigation::pan(camera, x, -y, static_cast<float>(height())));
      break;
    case Drag::Zoom:
      moveCamera(navigation::zoom(camera, 0.04F * (x - y)));
      break;
    case Drag::Look:
      moveCamera(navigation::look(camera, x * 0.5F * kRadiansPerPixel, -y * 0.5F * kRadiansPerPixel));
      break;
    case Drag::TurnEnvironment: {
      EnvironmentSource next = m_document.scene().environment;
      next.rotationDegrees = std::remainder(next.rotationDegrees + 0.4F * x, 360.0F);
      m_document.setEnvironmentSettings(next, tr("Rotate environment"), m_gesture);
      break;
    }
    case Drag::None:
      break;
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  m_drag = Drag::None;
  m_flyKeys.clear();
  m_fly.stop();
  unsetCursor();
  if (m_moving) still();
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (!m_renderer || event->button() != Qt::LeftButton) return;
  const double ratio = devicePixelRatioF();
  makeCurrent();
  const auto point = m_renderer->pickPosition(
      {static_cast<int>(event->position().x() * ratio), static_cast<int>(event->position().y() * ratio)});
  doneCurrent();
  if (point) moveCamera(navigation::lookAt(m_document.camera(), *point));
}

void Viewport::wheelEvent(QWheelEvent* event) {
  if (!m_document.isReady()) return;
  const float fine = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.2F : 1.0F;
  moveCamera(navigation::zoom(m_document.camera(),
                              fine * static_cast<float>(event->angleDelta().y() + event->angleDelta().x()) / 120.0F));
  event->accept();
}

bool Viewport::event(QEvent* event) {
  // While the right button is held, letters fly; no menu's shortcut may take them.
  if (event->type() == QEvent::ShortcutOverride && (m_drag == Drag::Zoom || m_drag == Drag::Look)) {
    event->accept();
    return true;
  }
  return QOpenGLWidget::event(event);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  static const QSet<int> kFlyKeys = {Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E};
  if ((m_drag == Drag::Zoom || m_drag == Drag::Look) && kFlyKeys.contains(event->key())) {
    if (event->isAutoRepeat()) return;
    m_drag = Drag::Look;
    m_flyKeys.insert(event->key());
    if (!m_fly.isActive()) {
      m_sinceFlyStep.start();
      m_fly.start();
    }
    return;
  }
  QOpenGLWidget::keyPressEvent(event);
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat() && m_flyKeys.remove(event->key())) {
    if (m_flyKeys.isEmpty()) m_fly.stop();
    return;
  }
  QOpenGLWidget::keyReleaseEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  m_flyKeys.clear();
  m_fly.stop();
  QOpenGLWidget::focusOutEvent(event);
}

void Viewport::flyStep() {
  const float seconds = std::min(static_cast<float>(m_sinceFlyStep.restart()) * 1e-3F, 0.1F);
  const float speed = m_document.isReady() ? 0.8F * m_document.model()->bounds.radius() : 1.0F;
  const auto held = [this](int key) { return m_flyKeys.contains(key) ? 1.0F : 0.0F; };
  const glm::vec3 direction(held(Qt::Key_D) - held(Qt::Key_A), held(Qt::Key_E) - held(Qt::Key_Q),
                            held(Qt::Key_W) - held(Qt::Key_S));
  moveCamera(navigation::fly(m_document.camera(), direction * (speed * seconds)));
}

}  // namespace dermis
