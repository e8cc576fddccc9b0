// Asks what is to become of work that an earlier editor didn't get to save.
#pragma once

#include <QDialog>
#include <vector>

#include "ui/document/autosave.h"

class QListWidget;

namespace dermis {

class RecoveryDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Choice { Later, Recover, Discard };

  explicit RecoveryDialog(const std::vector<LostWork>& found, QWidget* parent = nullptr);
  [[nodiscard]] Choice choice() const { return m_choice; }
  /// Which of them.
  [[nodiscard]] std::size_t selected() const;

 private:
  void choose(Choice choice);

  QListWidget* m_list = nullptr;
  Choice m_choice = Choice::Later;
};

}  // namespace dermis
