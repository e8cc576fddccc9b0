// A widget that OpenGL draws, and the two ways its picture gets into the window.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

class QOpenGLContext;

namespace dermis {

enum class Hosting {
  Composed,  ///< OpenGL puts the whole window together, so that no pixel is read back: right for a graphics card
  Copied     ///< read back and painted like any widget: software OpenGL would put all of the window together for each
             ///< label
};

class GlWidget : public QWidget {
  Q_OBJECT
 public:
  ~GlWidget() override;

  [[nodiscard]] Hosting hosting() const;
  /// Null until the first picture is asked for, and where there is no OpenGL.
  [[nodiscard]] QOpenGLContext* context() const;
  /// Draws a frame when the event loop comes to it; many requests are one frame. What merely lies over the picture
  /// needs none: that is update() of what lies there.
  void requestFrame();
  /// A frame of this moment; null without a context.
  [[nodiscard]] QImage grabFrame();
  /// Has another context made in place of one that is lost. The old one tells that it goes (`aboutToBeDestroyed`).
  void renewContext();

 Q_SIGNALS:
  /// A frame is in the window.
  void frameShown();

 protected:
  GlWidget(Hosting hosting, QWidget* parent);

  void makeCurrent();
  void doneCurrent();
  [[nodiscard]] unsigned framebuffer() const;

  /// With each new context, which is current.
  virtual void initializeGL() = 0;
  /// With the context current.
  virtual void paintGL() = 0;
  /// In its place, where the window system says that the context is lost.
  virtual void contextLost() = 0;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  class Surface;
  class ComposedSurface;
  class CopiedSurface;
  std::unique_ptr<Surface> m_surface;
};

}  // namespace dermis
