// Pictures that remember the scene they were made of: dropped on the window, they offer to open it.
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <string>

class QWidget;

namespace dermis {

class Loading;
class TaskRunner;

class PictureScenes : public QObject {
  Q_OBJECT
 public:
  PictureScenes(Loading& loading, TaskRunner& tasks, QWidget& window);
  /// Asks where the picture at `path` holds a scene; `otherwise` is called where it holds none, or where the person
  /// would rather use it as a picture. `mayDiscard` is asked before the document is replaced.
  void offer(const std::filesystem::path& path, std::function<bool()> mayDiscard, std::function<void()> otherwise);

 private:
  Loading& m_loading;
  TaskRunner& m_tasks;
  QWidget& m_window;
};

/// The scene that a picture's header carries, as the text of a scene file; empty where it carries none.
[[nodiscard]] std::string sceneTextOfPicture(const std::filesystem::path& path);

}  // namespace dermis
