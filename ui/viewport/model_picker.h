// What a ray meets of the model that is open: its rays are made ready beside the event loop whenever the model changes.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/bake/surface_picker.h"
#include "ui/jobs/task_runner.h"
#include "ui/viewport/projection.h"

namespace dermis {

class Document;

class ModelPicker : public QObject {
  Q_OBJECT
 public:
  explicit ModelPicker(Document& document, QObject* parent = nullptr);
  /// From now on models are made ready: their picture comes first.
  void begin();
  [[nodiscard]] bool isReady() const { return m_picker != nullptr; }
  /// Nothing beside the model, and for the moment until a new one is ready.
  [[nodiscard]] std::optional<SurfaceHit> hit(const Ray& ray) const;

 Q_SIGNALS:
  void problem(const QString& sentence);

 private:
  void follow();
  void prepare();

  Document& m_document;
  bool m_begun = false;
  QTimer m_soon;
  std::shared_ptr<const Model> m_model;
  std::shared_ptr<const SurfacePicker> m_picker;
  TaskRunner m_work;  ///< of its own: who cancels the loading of a file still wants to point at what is open
};

}  // namespace dermis
