// The picture: hosts a Renderer in a QOpenGLWidget, turns gestures into camera, light and environment changes.
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QSet>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "renderer.h"
#include "ui/document/loading.h"
#include "ui/rows/gesture.h"
#include "ui/viewport/pace.h"

class QLabel;

namespace dermis {

class Document;
class Legend;
class OverlayLabel;
class ScaleBar;

class Viewport : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit Viewport(Document& document, QWidget* parent = nullptr);
  ~Viewport() override;

  void frameAll();
  void showNamedView(const QString& name);
  void setAov(Aov aov);
  [[nodiscard]] Aov aov() const { return m_aov; }
  /// Draws the picture as if no light spread below a surface.
  void setWithoutSubsurface(bool without);
  [[nodiscard]] bool withoutSubsurface() const { return m_withoutSubsurface; }
  void setTargetSamples(int samples);
  void setStatisticsVisible(bool visible);
  void cancelJobs();
  /// What the renderer has done so far; zeros without one.
  [[nodiscard]] RenderStatistics statistics() const;
  [[nodiscard]] std::optional<GlInfo> glInfo() const;
  /// True when the picture shown has all its samples and nothing is queued.
  [[nodiscard]] bool isSettled() const;

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);
  void jobProgress(const QString& what, double fraction);
  void aovChanged(dermis::Aov aov);
  void withoutSubsurfaceChanged(bool without);
  /// Device pixels of the picture.
  void pictureResized(const QSize& pixels);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { None, Orbit, Pan, Zoom, Look, TurnEnvironment };
  void releaseRenderer();
  void drawFrame();
  /// Another frame, another slice of jobs, or rest.
  void scheduleNext();
  void continueJobs();
  void moving();
  void still();
  void moveCamera(const Camera& camera);
  void flyStep();
  void placeOverlays();
  /// The view's name and, where its colours are numbers, their legend.
  void refreshViewName();
  void refreshLegend();
  void refreshStatistics(double milliseconds);
  void showProblem(const QString& sentence);
  [[nodiscard]] bool animated() const;

  Document& m_document;
  std::unique_ptr<Renderer> m_renderer;
  std::shared_ptr<const ResolvedScene> m_drawn;  ///< what the renderer was given last
  Aov m_aov = Aov::Beauty;
  bool m_withoutSubsurface = false;
  int m_targetSamples = 64;
  bool m_jobsLeft = false;
  std::string m_jobText;     ///< of the job in progress
  bool m_firstFrame = true;  ///< nothing has been shown yet: wait for programs and environment
  bool m_moving = false;
  bool m_wasMoving = false;  ///< the frame shown last was a moving one
  Pace m_pace;
  QTimer m_next;
  QTimer m_still;
  QTimer m_fly;
  QElapsedTimer m_clock;
  QElapsedTimer m_frameClock;
  QElapsedTimer m_sinceFlyStep;
  QElapsedTimer m_sinceText;
  double m_smoothedMs = 0.0;

  Drag m_drag = Drag::None;
  Gesture m_gesture = 0;
  QPointF m_last;
  QSet<int> m_flyKeys;
  OverlayLabel* m_statistics = nullptr;
  OverlayLabel* m_viewName = nullptr;
  Legend* m_legend = nullptr;
  ScaleBar* m_scaleBar = nullptr;
  QLabel* m_problem = nullptr;
};

}  // namespace dermis
