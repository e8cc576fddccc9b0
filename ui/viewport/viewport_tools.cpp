// What tools and panels ask of the viewport: where things are, what a pixel holds, the other half of a split view.
#include <algorithm>
#include <cmath>

#include "ui/document/document.h"
#include "ui/text.h"
#include "ui/viewport/compared_picture.h"
#include "ui/viewport/model_picker.h"
#include "ui/viewport/overlay_canvas.h"
#include "ui/viewport/viewport.h"

namespace dermis {

void Viewport::addTool(ViewportTool* tool) {
  m_tools << tool;
  m_canvas->setTools(m_tools);
}

void Viewport::updateOverlay() { m_canvas->update(); }

Projection Viewport::projection() const { return {m_document.camera(), QSizeF(size())}; }

std::optional<PixelReadout> Viewport::readPixel(const QPointF& at) {
  if (!m_renderer || m_firstFrame || !takeContext()) return std::nullopt;
  const bool right = m_compared && at.x() * devicePixelRatioF() >=
                                       splitColumn(static_cast<int>(std::lround(width() * devicePixelRatioF())));
  Renderer& renderer = right ? m_compared->renderer() : *m_renderer;
  const glm::vec2 picture(renderer.statistics().pictureSize);
  const glm::vec2 share(static_cast<float>(at.x() / width()), static_cast<float>(at.y() / height()));
  const auto readout = renderer.readPixel(glm::ivec2(glm::floor(share * picture)),
                                          right ? m_comparedScene->scene.view : m_document.scene().view);
  doneCurrent();
  return readout;
}

std::optional<glm::vec3> Viewport::pickPosition(const QPointF& at) {
  if (!m_renderer || !takeContext()) return std::nullopt;
  const glm::vec2 picture(m_renderer->statistics().pictureSize);
  const glm::vec2 share(static_cast<float>(at.x() / width()), static_cast<float>(at.y() / height()));
  const auto point = m_renderer->pickPosition(glm::ivec2(glm::floor(share * picture)));
  doneCurrent();
  return point;
}

std::optional<SurfaceHit> Viewport::surfaceAt(const QPointF& at) const { return m_picker->hit(projection().ray(at)); }

QImage Viewport::picture() {
  if (!m_renderer || m_firstFrame) return {};
  // A moving picture has no samples of its own to be read: what the window shows has to do.
  if (!m_showsSamples) return grabFrame();
  if (!takeContext()) return {};
  const Image image = m_renderer->readView(Aov::Beauty, m_document.scene().view, PixelType::U8);
  doneCurrent();
  return QImage(reinterpret_cast<const uchar*>(image.pixels.data()), image.width, image.height,
                static_cast<qsizetype>(image.rowBytes()), QImage::Format_RGBA8888)
      .copy();
}

void Viewport::setReferences(const ReferenceObjects& references) {
  if (references == m_references) return;
  m_references = references;
  requestFrame();
}

void Viewport::compareWith(std::shared_ptr<const ResolvedScene> scene, std::shared_ptr<const ResolvedScene> left) {
  if (!scene) left.reset();
  if (scene == m_comparedScene && left == m_leftScene) return;
  m_comparedScene = std::move(scene);
  m_leftScene = std::move(left);
  Q_EMIT comparisonChanged();
  updateOverlay();
  requestFrame();
}

std::shared_ptr<const ResolvedScene> Viewport::leftScene() const {
  return m_leftScene ? m_leftScene : m_document.snapshot();
}

void Viewport::setSplit(double share) {
  m_split = std::clamp(share, 0.0, 1.0);
  updateOverlay();
  requestFrame();
}

int Viewport::splitColumn(int columns) const {
  return m_comparedScene ? static_cast<int>(std::lround(m_split * columns)) : columns;
}

void Viewport::refreshCompared() {
  if (!m_comparedScene) {
    m_compared.reset();
    return;
  }
  if (!m_compared) {
    auto made = ComparedPicture::create(rendererOptions());
    if (!made) {
      const QString sentence = text(made.error().message);
      m_comparedScene.reset();
      m_leftScene.reset();
      QMetaObject::invokeMethod(
          this, [this, sentence] { Q_EMIT message(MessageKind::Error, sentence); }, Qt::QueuedConnection);
      return;
    }
    m_compared = std::move(*made);
  }
  if (m_compared->scene() != m_comparedScene.get()) m_compared->show(m_comparedScene);
}

}  // namespace dermis
