// Pictures out of the editor: asked for in a dialog, drawn beside it, to files or to the clipboard.
#pragma once

#include <QObject>
#include <deque>
#include <memory>

#include "ui/document/loading.h"
#include "ui/jobs/picture_job.h"

class QWidget;

namespace dermis {

class Document;
class TaskRunner;
class Viewport;

class Exports : public QObject {
  Q_OBJECT
 public:
  Exports(Document& document, TaskRunner& tasks, QWidget& window);
  void setMetadata(PictureMetadata metadata) { m_metadata = std::move(metadata); }
  /// The dialog; the viewport gives size and what is switched on in it.
  void ask(const Viewport& viewport);
  /// The document as it is now; where another picture is being drawn, after that one.
  void draw(const PictureRequest& request);
  /// Those that wait are not drawn; the one under way is the runner's to cancel.
  void forgetWaiting() { m_waiting.clear(); }
  /// The views of a sheet: the ready-made ones and the scene's bookmarks.
  [[nodiscard]] std::vector<NamedView> sheetViews() const;

 Q_SIGNALS:
  void message(dermis::MessageKind kind, const QString& sentence);
  /// 0..1 of what is being drawn; negative: nothing is.
  void progressed(double fraction);

 private:
  struct Waiting {
    PictureRequest request;
    std::shared_ptr<const ResolvedScene> scene;
  };
  void startNext();

  std::deque<Waiting> m_waiting;
  Document& m_document;
  TaskRunner& m_tasks;
  QWidget& m_window;
  PictureMetadata m_metadata;
};

}  // namespace dermis
