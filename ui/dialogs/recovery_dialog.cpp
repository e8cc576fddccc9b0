#include "ui/dialogs/recovery_dialog.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/text.h"
#include "ui/theme/metrics.h"

namespace dermis {

RecoveryDialog::RecoveryDialog(const std::vector<LostWork>& found, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("recovery"));
  setWindowTitle(tr("Unsaved work"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 18, 20, 16);
  column->setSpacing(metrics::kMargin);
  auto* head = new QLabel(tr("The editor was closed before this work was saved."), this);
  head->setProperty("heading", true);
  column->addWidget(head);
  m_list = new QListWidget(this);
  m_list->setObjectName(QStringLiteral("recovery.list"));
  m_list->setAccessibleName(tr("Unsaved work"));
  m_list->setToolTip(tr("Each line is what one editor had open when it ended"));
  m_list->setMinimumSize(460, 110);
  for (const LostWork& work : found) {
    const QString name = work.recovery.scenePath.empty() ? tr("Untitled") : pathText(work.recovery.scenePath);
    const QDateTime when = QDateTime::fromMSecsSinceEpoch(work.recovery.savedAtMilliseconds);
    m_list->addItem(tr("%1   ·   %2").arg(name, QLocale().toString(when, QLocale::ShortFormat)));
  }
  m_list->setCurrentRow(0);
  column->addWidget(m_list, 1);
  auto* note = new QLabel(tr("Recovering opens it as unsaved work; no file of yours is written over."), this);
  note->setProperty("quiet", true);
  column->addWidget(note);
  auto* buttons = new QHBoxLayout();
  const auto add = [&](const QString& label, const QString& name, const QString& help, Choice choice) {
    auto* button = new QPushButton(label, this);
    button->setObjectName(QStringLiteral("recovery.") + name);
    button->setToolTip(help);
    connect(button, &QPushButton::clicked, this, [this, choice] { choose(choice); });
    buttons->addWidget(button);
    return button;
  };
  add(tr("&Delete"), QStringLiteral("discard"), tr("Deletes the selected work for good"), Choice::Discard);
  buttons->addStretch(1);
  add(tr("&Later"), QStringLiteral("later"), tr("Keeps it and asks again at the next start"), Choice::Later);
  QPushButton* recover = add(tr("&Recover"), QStringLiteral("recover"), tr("Opens the selected work"), Choice::Recover);
  recover->setDefault(true);
  column->addLayout(buttons);
  connect(m_list, &QListWidget::itemActivated, this, [this] { choose(Choice::Recover); });
}

std::size_t RecoveryDialog::selected() const { return static_cast<std::size_t>(std::max(0, m_list->currentRow())); }

void RecoveryDialog::choose(Choice choice) {
  m_choice = choice;
  if (choice == Choice::Later)
    reject();
  else
    accept();
}

}  // namespace dermis
