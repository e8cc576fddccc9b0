#include "ui/viewport/model_picker.h"

#include <utility>

#include "ui/document/document.h"
#include "ui/text.h"

namespace dermis {

ModelPicker::ModelPicker(Document& document, QObject* parent) : QObject(parent), m_document(document) {
  connect(&m_document, &Document::changed, this, &ModelPicker::follow);
  // Its threads would slow down the new model's first pictures.
  m_soon.setSingleShot(true);
  m_soon.setInterval(500);
  connect(&m_soon, &QTimer::timeout, this, &ModelPicker::prepare);
}

void ModelPicker::begin() {
  if (!std::exchange(m_begun, true)) follow();
}

std::optional<SurfaceHit> ModelPicker::hit(const Ray& ray) const {
  return m_picker ? m_picker->hit(ray.origin, ray.direction) : std::nullopt;
}

void ModelPicker::follow() {
  if (!m_begun || m_document.model() == m_model) return;
  m_model = m_document.model();
  m_picker.reset();
  m_work.cancel(QStringLiteral("picker"));  // another model's
  if (m_model)
    m_soon.start();
  else
    m_soon.stop();
}

void ModelPicker::prepare() {
  using Made = Result<std::shared_ptr<const SurfacePicker>>;
  m_work.run(
      QStringLiteral("picker"), QString(),
      [model = m_model](const std::stop_token&) -> Made {
        auto made = SurfacePicker::create(model);
        if (!made) return tl::unexpected(made.error());
        return std::make_shared<const SurfacePicker>(std::move(*made));
      },
      [this](const Made& made) {
        if (made)
          m_picker = *made;
        else
          Q_EMIT problem(tr("The model can't be pointed at: %1").arg(text(made.error().message)));
      });
}

}  // namespace dermis
