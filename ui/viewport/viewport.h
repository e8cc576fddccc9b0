// The picture: hosts a Renderer in a widget, turns gestures into camera, light and environment changes.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "core/bake/surface_picker.h"
#include "renderer.h"
#include "ui/document/loading.h"
#include "ui/rows/gesture.h"
#include "ui/viewport/gl_widget.h"
#include "ui/viewport/lull.h"
#include "ui/viewport/pace.h"
#include "ui/viewport/projection.h"

class QLabel;

namespace dermis {

class ComparedPicture;
class Document;
class FlyKeys;
class Legend;
class ModelPicker;
class OverlayCanvas;
class OverlayLabel;
class ScaleBar;
class ViewportTool;

class Viewport : public GlWidget {
  Q_OBJECT
 public:
  explicit Viewport(Document& document, QWidget* parent = nullptr);
  ~Viewport() override;

  void frameAll();
  void showNamedView(const QString& name);
  /// Somewhere else by a key, which ends a gesture of its own.
  void goTo(const Camera& camera);
  void setAov(Aov aov);
  [[nodiscard]] Aov aov() const { return m_aov; }
  /// Draws the picture as if no light spread below a surface.
  void setWithoutSubsurface(bool without);
  [[nodiscard]] bool withoutSubsurface() const { return m_withoutSubsurface; }
  void setTargetSamples(int samples);
  void setStatisticsVisible(bool visible);
  /// How long a picture may take while something is dragged, before it is drawn with fewer pixels.
  void setPaceTarget(double milliseconds);
  void cancelJobs();
  /// What the renderer has done so far; zeros without one.
  [[nodiscard]] RenderStatistics statistics() const;
  [[nodiscard]] std::optional<GlInfo> glInfo() const;
  /// True when the picture shown has all its samples and nothing is queued.
  [[nodiscard]] bool isSettled() const;

  /// Tools are asked in this order before a gesture is the camera's; not owned.
  void addTool(ViewportTool* tool);
  void updateOverlay();
  [[nodiscard]] Projection projection() const;
  /// What the renderer holds at a point of the widget; nothing without a picture or outside it.
  [[nodiscard]] std::optional<PixelReadout> readPixel(const QPointF& at);
  /// The point of the model under a point of the widget.
  [[nodiscard]] std::optional<glm::vec3> pickPosition(const QPointF& at);
  /// What lies there, in numbers that don't wait for a picture; nothing while a new model is made ready for it.
  [[nodiscard]] std::optional<SurfaceHit> surfaceAt(const QPointF& at) const;
  [[nodiscard]] const ModelPicker& picker() const { return *m_picker; }
  /// The picture alone, whole and without what lies over it; null while there is none.
  [[nodiscard]] QImage picture();
  void setReferences(const ReferenceObjects& references);
  [[nodiscard]] const ReferenceObjects& references() const { return m_references; }

  /// Shows `scene` right of the split, with this camera; null: no split. `left` stands on the other side instead of the
  /// document; null: the document.
  void compareWith(std::shared_ptr<const ResolvedScene> scene, std::shared_ptr<const ResolvedScene> left = nullptr);
  [[nodiscard]] const ResolvedScene* compared() const { return m_comparedScene.get(); }
  [[nodiscard]] const ResolvedScene* comparedLeft() const { return m_leftScene.get(); }
  /// The share is the left side's.
  void setSplit(double share);
  [[nodiscard]] double split() const { return m_split; }

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);
  void jobProgress(const QString& what, double fraction);
  void aovChanged(dermis::Aov aov);
  void withoutSubsurfaceChanged(bool without);
  void comparisonChanged();
  /// The pointer is over the picture at this point, or has left it.
  void pointed(const QPointF& at);
  void pointerLeft();
  /// A plain click (not a drag) with these keys held.
  void clicked(const QPointF& at, Qt::KeyboardModifiers keys);
  /// A gesture has brought the camera somewhere else and has ended.
  void cameraGestureEnded();
  /// Device pixels of the picture.
  void pictureResized(const QSize& pixels);

 protected:
  void initializeGL() override;
  void paintGL() override;
  void contextLost() override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { None, Orbit, Pan, Zoom, Look, TurnEnvironment };
  /// What the machine is taken for until pictures have been measured.
  [[nodiscard]] Pace firstPace() const;
  void releaseRenderer();
  /// The context goes, by itself or because it was lost.
  void leaveContext();
  /// Leaves what was on the graphics card as it is: nothing there can be given back, and no call reaches it.
  void letGo();
  /// Whether the driver has taken the context away, as after a reset of the graphics card. A driver tells it once.
  [[nodiscard]] bool contextIsLost() const;
  /// Makes the context current; false where there is none any more.
  bool takeContext();
  void loseRenderer();
  /// That there is a picture again.
  void tellReset();
  /// Asks for the next picture. A whole one is drawn in two events where the CPU draws it.
  void nextFrame();
  /// False where nothing was drawn yet, because light is still being computed.
  bool drawFrame();
  [[nodiscard]] FrameRequest frameRequest() const;
  /// What stands left of the split, or everywhere.
  [[nodiscard]] std::shared_ptr<const ResolvedScene> leftScene() const;
  /// The column where the compared picture begins; beyond the last where there is none.
  [[nodiscard]] int splitColumn(int columns) const;
  [[nodiscard]] RendererOptions rendererOptions() const;
  void refreshCompared();
  void cancelDrag();
  /// Another frame, another slice of jobs, or rest.
  void scheduleNext();
  void continueJobs();
  void moving();
  void still();
  void moveCamera(const Camera& camera);
  void flyStep();
  void placeOverlays();
  void tellPixels();
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
  bool m_lightIsPending = false;
  bool m_isBegun = false;         ///< the first half of the next picture was asked for
  bool m_contextWasLost = false;  ///< and there has been no picture since
  using AskReset = unsigned (*)();
  AskReset m_askReset = nullptr;  ///< glGetGraphicsResetStatus
  std::string m_jobText;          ///< of the job in progress
  bool m_firstFrame = true;       ///< nothing has been shown yet: wait for programs and environment
  bool m_moving = false;
  bool m_resting = false;   ///< a button is held and nothing has changed for a while: as sharp as a moving picture gets
  bool m_settling = false;  ///< just let go: one whole picture of the quick kind comes before the slow samples
  bool m_wasMoving = false;     ///< the frame shown last was a moving one
  bool m_showsSamples = false;  ///< the frame shown last was a still one
  bool m_wasScaled = false;     ///< and had fewer pixels than the widget
  double m_paceTarget = Pace::kTargetMs;
  Pace m_pace;
  ReferenceObjects m_references;
  std::unique_ptr<ComparedPicture> m_compared;
  std::shared_ptr<const ResolvedScene> m_comparedScene;
  std::shared_ptr<const ResolvedScene> m_leftScene;  ///< beside it, where that isn't the document
  double m_split = 0.5;
  QTimer m_next;
  QTimer m_rest;  ///< since the picture has all its samples
  QTimer m_half;  ///< until the first half of a picture is drawn
  Lull m_lull;
  QTimer m_still;
  QTimer m_fly;
  QElapsedTimer m_clock;
  QElapsedTimer m_frameClock;
  QElapsedTimer m_begunClock;  ///< of a picture that is drawn in two events
  QElapsedTimer m_sinceFlyStep;
  QElapsedTimer m_sinceText;
  double m_smoothedMs = 0.0;

  Drag m_drag = Drag::None;
  Gesture m_gesture = 0;
  QPointF m_last;
  QPointF m_pressed;
  bool m_dragged = false;  ///< the pointer has gone far enough for a drag
  Camera m_cameraBefore;   ///< the drag, for Esc
  EnvironmentSource m_environmentBefore;
  QList<ViewportTool*> m_tools;
  ViewportTool* m_activeTool = nullptr;
  OverlayCanvas* m_canvas = nullptr;
  ModelPicker* m_picker = nullptr;
  FlyKeys* m_flyKeys = nullptr;
  OverlayLabel* m_statistics = nullptr;
  OverlayLabel* m_viewName = nullptr;
  Legend* m_legend = nullptr;
  ScaleBar* m_scaleBar = nullptr;
  QLabel* m_problem = nullptr;
};

}  // namespace dermis
