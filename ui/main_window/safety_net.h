// Keeps unsaved work safe while the window is open, and offers what an earlier editor left.
#pragma once

#include <QObject>

#include "ui/document/autosave.h"

class QWidget;

namespace dermis {

/// Where unsaved work is kept.
[[nodiscard]] std::filesystem::path recoveryFolder();

class SafetyNet : public QObject {
  Q_OBJECT
 public:
  SafetyNet(Document& document, Loading& loading, QWidget* window);

  /// Asks about lost work, one after another, until one is recovered or the rest is kept for later.
  void offerLostWork();
  [[nodiscard]] Autosave& autosave() { return m_autosave; }

 private:
  void recover(const LostWork& work);

  Loading& m_loading;
  QWidget* m_window = nullptr;
  Autosave m_autosave;
};

}  // namespace dermis
