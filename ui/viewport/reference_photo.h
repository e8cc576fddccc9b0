// A photograph to compare with: over the picture or beside it. Kept in the editor's settings, not in the scene: it is
// about the desk of whoever looks, and a scene that is passed on would name a file that others don't have.
#pragma once

#include <QImage>
#include <QObject>
#include <QPointF>
#include <QWidget>

#include "ui/viewport/viewport_tool.h"

namespace dermis {

class TaskRunner;
class Viewport;

class ReferencePhoto : public QObject, public ViewportTool {
  Q_OBJECT
 public:
  enum class Place { Off, Over, Beside };
  struct Settings {
    QString path;
    Place place = Place::Off;
    double opacity = 0.5;  ///< over the picture
    double wipe = 1.0;     ///< over the picture: the share of the width, from the left, that is covered
    double scale = 1.0;    ///< 1: as high as the viewport
    QPointF offset;        ///< of its middle from the viewport's, in shares of the viewport's height
    bool operator==(const Settings&) const = default;
  };

  ReferencePhoto(Viewport& viewport, TaskRunner& tasks);
  [[nodiscard]] const Settings& settings() const { return m_settings; }
  void set(const Settings& settings);
  [[nodiscard]] const QImage& image() const { return m_image; }
  /// Where it is painted over the viewport.
  [[nodiscard]] QRectF rectangle(QSizeF viewport) const;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void cancel() override;
  void paint(QPainter& painter, const Projection& projection) override;

 Q_SIGNALS:
  void changed();
  void problem(const QString& sentence);

 private:
  void load();
  [[nodiscard]] bool isOver() const { return m_settings.place == Place::Over && !m_image.isNull(); }

  Viewport& m_viewport;
  TaskRunner& m_tasks;
  Settings m_settings;
  QImage m_image;
  QString m_loaded;
  double m_wipeBefore = 1.0;
};

/// The photograph in a widget of its own, beside the viewport; hidden unless it is wanted there.
class ReferenceView : public QWidget {
  Q_OBJECT
 public:
  ReferenceView(ReferencePhoto& photo, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ReferencePhoto& m_photo;
};

}  // namespace dermis
