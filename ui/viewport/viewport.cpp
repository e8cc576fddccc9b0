#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QOpenGLContext>
#include <QThreadPool>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/memory.h"
#include "ui/document/document.h"
#include "ui/text.h"
#include "ui/translation.h"
#include "ui/viewport/compared_picture.h"
#include "ui/viewport/fly_keys.h"
#include "ui/viewport/legend.h"
#include "ui/viewport/model_picker.h"
#include "ui/viewport/opengl_there.h"
#include "ui/viewport/overlay.h"
#include "ui/viewport/overlay_canvas.h"

namespace dermis {
namespace {

constexpr double kJobSliceMs = 8.0;
constexpr unsigned kVerticesAtOnce = 120000;  // a head's are lit in a call, a million triangles' in five
constexpr int kStillAfterMs = 120;            // full resolution within 150 ms of the last change
constexpr int kRestMs = 2000;                 // of a picture with all its samples before memory is tidied
constexpr int kHalfAskedMs = 2;               // how often whether half of a picture is drawn
constexpr int kRestBeforeStillMs = 500;       // with a button held: slow samples would be in the way of what comes next
/// What the renderer, which knows no Qt, says that it is doing.
[[maybe_unused]] constexpr const char* kJobWords[] = {
    QT_TRANSLATE_NOOP("tables", "Preparing shaders"),
    QT_TRANSLATE_NOOP("tables", "Sending maps to the graphics driver"),
    QT_TRANSLATE_NOOP("tables", "Measuring thickness and occlusion"),
};

}  // namespace

Viewport::Viewport(Document& document, QWidget* parent) : GlWidget(hostingHere(), parent), m_document(document) {
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("Viewport"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 180);
  setMouseTracking(true);
  m_canvas = new OverlayCanvas([this] { return projection(); }, this);
  m_flyKeys = new FlyKeys(this);
  m_picker = new ModelPicker(m_document, this);
  connect(m_picker, &ModelPicker::problem, this,
          [this](const QString& sentence) { Q_EMIT message(MessageKind::Warning, sentence); });
  qApp->installEventFilter(this);
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
    // From a timer: events that post the next one would leave no room for those of the window.
    if (m_jobsLeft && !m_lightIsPending)
      continueJobs();
    else
      nextFrame();
  });
  m_half.setInterval(kHalfAskedMs);
  connect(&m_half, &QTimer::timeout, this, [this] {
    if (!m_renderer || !takeContext()) return m_half.stop();
    if (m_renderer->beginningIsDrawn()) {
      m_half.stop();
      requestFrame();
    }
    doneCurrent();
  });
  m_rest.setSingleShot(true);
  m_rest.setInterval(kRestMs);
  connect(&m_rest, &QTimer::timeout, this, [] { QThreadPool::globalInstance()->start(giveMemoryBack); });
  connect(&m_lull, &Lull::quiet, this, &Viewport::nextFrame);
  m_still.setSingleShot(true);
  m_still.setInterval(kStillAfterMs);
  connect(&m_still, &QTimer::timeout, this, &Viewport::still);
  m_fly.setInterval(16);
  connect(&m_fly, &QTimer::timeout, this, &Viewport::flyStep);
  connect(&m_document, &Document::changed, this, [this](Change what) {
    // Of another model too a quick picture comes first, and what the one before cost says nothing of it.
    if (what == Change::Everything && m_renderer) m_pace = firstPace();
    if (what != Change::Bookmarks) moving();
    refreshLegend();
    requestFrame();
  });
  connect(this, &GlWidget::frameShown, this, [this] {
    if (!m_frameClock.isValid()) return;
    const double milliseconds = static_cast<double>(m_frameClock.nsecsElapsed()) * 1e-6;
    m_frameClock.invalidate();
    if (m_wasMoving && (m_wasScaled || m_pace.scale() == 1.0)) m_pace.measured(milliseconds);
    refreshStatistics(milliseconds);
  });
}

Viewport::~Viewport() {
  // The context is destroyed when all that is ours has gone.
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  releaseRenderer();
}

// --- the picture
// ------------------------------------------------------------------------------------------------------

void Viewport::paintGL() {
  if (!m_renderer) return;
  if (contextIsLost()) return loseRenderer();
  const std::shared_ptr<const ResolvedScene> scene = leftScene();
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
  // The first picture is a quick one of few pixels: something to see before the slow samples.
  if (m_firstFrame) moving();
  refreshCompared();
  if (!drawFrame()) return;
  const bool settled = std::exchange(m_settling, false);
  // What is queued goes on in an event of its own: nobody is answered while a picture is drawn already.
  const bool jobsWereLeft =
      std::exchange(m_jobsLeft, m_renderer->jobsAreQueued() || (m_compared && m_compared->jobsAreQueued()));
  // A first picture may have done the last of them itself.
  if (jobsWereLeft && !m_jobsLeft)
    QMetaObject::invokeMethod(
        this, [this] { Q_EMIT jobProgress(QString(), 0.0); }, Qt::QueuedConnection);
  if (settled && !m_jobsLeft)
    m_next.start(0);
  else
    scheduleNext();
}

void Viewport::nextFrame() {
  const bool isWhole = !m_moving || m_resting;
  const bool isPaidByTheCpu = m_renderer && m_renderer->glInfo().software;
  if (!isWhole || !isPaidByTheCpu || m_firstFrame || leftScene() != m_drawn || animated()) return requestFrame();
  if (m_half.isActive() || !takeContext()) return;
  m_begunClock.start();
  const FrameRequest request = frameRequest();
  m_isBegun = m_renderer->beginFrame(request);
  if (m_isBegun && m_compared) m_compared->begin(request);
  m_lightIsPending = !m_isBegun && m_renderer->lightIsPending();
  doneCurrent();
  if (m_isBegun)
    m_half.start();
  else if (m_lightIsPending)
    m_next.start(0);
  else
    requestFrame();
}

FrameRequest Viewport::frameRequest() const {
  const double ratio = devicePixelRatioF();
  FrameRequest request;
  request.displaySize = {static_cast<int>(std::lround(width() * ratio)),
                         static_cast<int>(std::lround(height() * ratio))};
  request.size = request.displaySize;
  request.camera = m_document.camera();
  request.view = m_document.scene().view;
  request.aov = m_aov;
  request.withoutSubsurface = m_withoutSubsurface;
  request.moving = m_moving || m_settling;
  request.targetSamples = animated() ? 1 : m_targetSamples;
  request.seconds = static_cast<double>(m_clock.elapsed()) * 1e-3;
  request.framebuffer = framebuffer();
  request.references = m_references;
  request.verticesAtOnce = kVerticesAtOnce;
  // A fast machine draws all pixels anyway: its pace stays at 1.
  if (m_moving && !m_resting) {
    const double scale = m_pace.scale();
    request.size = {std::max(1, static_cast<int>(request.displaySize.x * scale)),
                    std::max(1, static_cast<int>(request.displaySize.y * scale))};
  }
  return request;
}

bool Viewport::drawFrame() {
  FrameRequest request = frameRequest();
  m_half.stop();
  m_frameClock.start();
  if (std::exchange(m_isBegun, false)) m_frameClock = m_begunClock;
  m_wasMoving = m_moving && !m_firstFrame;  // whose time is that of its uploads
  m_showsSamples = !request.moving;
  m_wasScaled = request.size != request.displaySize;
  const int column = splitColumn(request.displaySize.x);
  if (column < request.displaySize.x) request.displayColumns = {0, std::max(column, 1)};
  const bool drawn = m_renderer->renderFrame(request);
  const bool comparedDrawn = !m_compared || m_compared->draw(request, column);
  m_lightIsPending = (!drawn && m_renderer->lightIsPending()) ||
                     (m_compared && !comparedDrawn && m_compared->renderer().lightIsPending());
  if (m_lightIsPending) {
    m_frameClock.invalidate();
    m_next.start(0);
    return false;
  }
  if (drawn && m_firstFrame) {
    m_firstFrame = false;
    QMetaObject::invokeMethod(m_picker, &ModelPicker::begin, Qt::QueuedConnection);
    // From the event loop: a widget doesn't hide its children while it paints. Seen at once, not with the next frame.
    QMetaObject::invokeMethod(
        m_problem,
        [this] {
          m_problem->hide();
          repaint();
        },
        Qt::QueuedConnection);
    if (std::exchange(m_contextWasLost, false)) tellReset();
  }
  for (const std::string& line : m_renderer->takeMessages()) {
    const QString sentence = text(line);
    QMetaObject::invokeMethod(
        this, [this, sentence] { Q_EMIT message(MessageKind::Warning, sentence); }, Qt::QueuedConnection);
  }
  return true;
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
  else if (!m_moving && (m_renderer->accumulating() || (m_compared && m_compared->accumulating())))
    m_lull.start(m_smoothedMs);
  else if (!m_moving)
    m_rest.start();
}

void Viewport::continueJobs() {
  if (!m_renderer || !takeContext()) return;
  m_jobsLeft = m_renderer->runJobs(kJobSliceMs);
  if (m_compared && m_compared->runJobs(kJobSliceMs)) m_jobsLeft = true;
  const auto [what, fraction] = m_renderer->jobProgress();
  // What an earlier job made is shown while another goes on.
  if (m_renderer->drawable() && std::exchange(m_jobText, what) != what) requestFrame();
  doneCurrent();
  Q_EMIT jobProgress(m_jobsLeft ? tableText(what) : QString(), fraction);
  if (m_jobsLeft)
    m_next.start(0);
  else
    nextFrame();
}

void Viewport::cancelJobs() {
  if (!m_renderer || !takeContext()) return;
  m_renderer->cancelJobs();
  doneCurrent();
  m_jobsLeft = false;
  Q_EMIT jobProgress(QString(), 0.0);
  requestFrame();
}

void Viewport::moving() {
  m_moving = true;
  m_resting = false;
  m_still.start(kStillAfterMs);
}

void Viewport::still() {
  m_still.stop();
  if (!m_moving) return;
  if (QApplication::mouseButtons() != Qt::NoButton && !m_resting) {
    m_resting = true;
    m_still.start(kRestBeforeStillMs);
  } else {
    m_settling = m_wasScaled;
    m_moving = false;
    m_resting = false;
  }
  nextFrame();
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  // Whatever was dragged, a slider, a light, the camera: letting go ends it.
  if (event->type() == QEvent::MouseButtonRelease && m_moving)
    QMetaObject::invokeMethod(this, &Viewport::still, Qt::QueuedConnection);
  return GlWidget::eventFilter(watched, event);
}

void Viewport::setAov(Aov aov) {
  if (aov == m_aov) return;
  m_aov = aov;
  refreshViewName();
  Q_EMIT aovChanged(aov);
  requestFrame();
}

void Viewport::setWithoutSubsurface(bool without) {
  if (without == m_withoutSubsurface) return;
  m_withoutSubsurface = without;
  refreshViewName();
  Q_EMIT withoutSubsurfaceChanged(without);
  requestFrame();
}

void Viewport::setTargetSamples(int samples) {
  m_targetSamples = std::max(1, samples);
  requestFrame();
}

void Viewport::setPaceTarget(double milliseconds) {
  m_paceTarget = milliseconds;
  m_pace = firstPace();
}

Pace Viewport::firstPace() const { return Pace(m_renderer && !m_renderer->glInfo().software, m_paceTarget); }

RenderStatistics Viewport::statistics() const { return m_renderer ? m_renderer->statistics() : RenderStatistics{}; }

std::optional<GlInfo> Viewport::glInfo() const {
  return m_renderer ? std::optional(m_renderer->glInfo()) : std::nullopt;
}

bool Viewport::isSettled() const {
  return m_renderer && !m_firstFrame && !m_jobsLeft && !m_moving && !m_settling && m_drawn == leftScene() &&
         !m_renderer->accumulating() &&
         (!m_comparedScene ||
          (m_compared && m_compared->scene() == m_comparedScene.get() && !m_compared->accumulating()));
}

}  // namespace dermis
