// Reads a map's file again when it has changed on disk: written in place, or replaced by renaming another over it.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <map>
#include <string>

namespace dermis {

class Document;
class Loading;

class MapWatcher : public QObject {
  Q_OBJECT
 public:
  enum class State { Good, Missing, Broken };

  MapWatcher(Document& document, Loading& loading, QObject* parent = nullptr);
  /// Of a file that some slot wears; Good for all others.
  [[nodiscard]] State stateOf(const std::string& path) const;

 Q_SIGNALS:
  void stateChanged();

 private:
  struct File {
    std::string readKey;  ///< of the content that is shown, or that was tried last
    std::string seenKey;  ///< at the last look: reading waits until it no longer changes
    State state = State::Good;
    int failures = 0;  ///< readings of this content that failed
  };
  void followDocument();
  void watch();
  void look();
  void takeResult(const QString& path, bool good);

  Document& m_document;
  Loading& m_loading;
  QFileSystemWatcher m_watcher;
  QTimer m_soon;
  std::map<std::string, File> m_files;
};

}  // namespace dermis
