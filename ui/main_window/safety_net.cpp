#include "ui/main_window/safety_net.h"

#include <QStandardPaths>

#include "ui/dialogs/recovery_dialog.h"
#include "ui/text.h"

namespace dermis {

std::filesystem::path recoveryFolder() {
  return toPath(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/recovery"));
}

SafetyNet::SafetyNet(Document& document, Loading& loading, QWidget* window)
    : QObject(window), m_loading(loading), m_window(window), m_autosave(document, recoveryFolder()) {
  connect(&m_autosave, &Autosave::message, &m_loading, &Loading::message);
}

void SafetyNet::offerLostWork() {
  Warnings warnings;
  std::vector<LostWork> found = findLostWork(recoveryFolder(), warnings);
  for (const std::string& warning : warnings) Q_EMIT m_loading.message(MessageKind::Warning, text(warning));
  while (!found.empty()) {
    RecoveryDialog dialog(found, m_window);
    dialog.exec();
    if (dialog.choice() == RecoveryDialog::Choice::Later) return;
    const auto chosen = found.begin() + static_cast<std::ptrdiff_t>(dialog.selected());
    if (dialog.choice() == RecoveryDialog::Choice::Recover) {
      recover(*chosen);
      return;
    }
    discardLostWork(*chosen);
    found.erase(chosen);
  }
}

void SafetyNet::recover(const LostWork& work) {
  m_loading.openUnsaved(work.recovery.scene, work.recovery.scenePath, [this, work] { m_autosave.adopt(work); });
}

}  // namespace dermis
