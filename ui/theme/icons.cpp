#include "ui/theme/icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

#include "core/base/resources.h"

namespace dermis {
namespace {

/// Draws at whatever size and scale is asked for, so that icons are sharp on every screen.
class StrokeIconEngine : public QIconEngine {
 public:
  explicit StrokeIconEngine(QByteArray svg) : m_svg(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QApplication::palette();
    const QColor colour = mode == QIcon::Disabled ? palette.color(QPalette::Disabled, QPalette::WindowText)
                                                  : palette.color(QPalette::Active, QPalette::WindowText);
    QByteArray coloured = m_svg;
    coloured.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer(coloured).render(painter, QRectF(rect));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return picture;
  }
  QIconEngine* clone() const override { return new StrokeIconEngine(m_svg); }

 private:
  QByteArray m_svg;
};

}  // namespace

QIcon themeIcon(const char* name) {
  const std::string_view svg = resource(std::string("icons/") + name + ".svg");
  if (svg.empty()) return {};
  return QIcon(new StrokeIconEngine(QByteArray(svg.data(), static_cast<qsizetype>(svg.size()))));
}

}  // namespace dermis
