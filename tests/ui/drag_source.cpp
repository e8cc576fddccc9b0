#include "ui/drag_source.h"

#include <QApplication>
#include <QDrag>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QScreen>
#include <QUrl>

namespace dermis {
namespace {

class Source : public QLabel {
 public:
  explicit Source(const QList<QUrl>& files) : m_files(files) {
    setWindowTitle(QStringLiteral("drag source"));
    setWindowFlags(Qt::Window | Qt::FramelessWindowHint | Qt::WindowStaysOnTopHint);
    setAlignment(Qt::AlignCenter);
    setText(files.value(0).fileName());
    resize(160, 32);
    const QRect screen = QApplication::primaryScreen()->geometry();
    move(screen.right() - width() - 8, screen.bottom() - height() - 8);
  }

 protected:
  void mousePressEvent(QMouseEvent*) override {
    auto* data = new QMimeData;
    data->setUrls(m_files);
    auto* drag = new QDrag(this);
    drag->setMimeData(data);
    drag->exec(Qt::CopyAction);
  }

 private:
  QList<QUrl> m_files;
};

}  // namespace

int dragSource(int argc, char** argv) {
  QApplication application(argc, argv);
  QList<QUrl> files;
  for (const QString& argument : application.arguments().mid(2))
    files << QUrl::fromLocalFile(QFileInfo(argument).absoluteFilePath());
  Source source(files);
  source.show();
  return QApplication::exec();
}

}  // namespace dermis
