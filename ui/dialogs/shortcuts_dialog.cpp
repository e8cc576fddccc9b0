#include "ui/dialogs/shortcuts_dialog.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {
namespace {
constexpr int kIndexRole = Qt::UserRole;
}

ShortcutsDialog::ShortcutsDialog(Shortcuts& shortcuts, QWidget* parent) : QDialog(parent), m_shortcuts(shortcuts) {
  setObjectName(QStringLiteral("shortcuts"));
  setWindowTitle(tr("Keyboard shortcuts"));
  resize(620, 640);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(18, 16, 18, 14);
  column->setSpacing(metrics::kMargin);
  m_search = new QLineEdit(this);
  m_search->setObjectName(QStringLiteral("shortcuts.search"));
  m_search->setAccessibleName(tr("Search commands"));
  m_search->setToolTip(tr("Words of a command, or keys such as Ctrl+S"));
  m_search->setPlaceholderText(tr("Search commands or keys"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  column->addWidget(m_search);
  m_tree = new QTreeWidget(this);
  m_tree->setObjectName(QStringLiteral("shortcuts.list"));
  m_tree->setAccessibleName(tr("Commands"));
  m_tree->setToolTip(tr("Select a command, then press its new keys below"));
  m_tree->setHeaderLabels({tr("Command"), tr("Menu"), tr("Keys")});
  m_tree->setRootIsDecorated(false);
  m_tree->setUniformRowHeights(true);
  m_tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_tree->setColumnWidth(1, 170);
  m_tree->setColumnWidth(2, 150);
  m_tree->header()->setStretchLastSection(false);
  column->addWidget(m_tree, 1);
  buildEditor();
  fill();
  connect(m_search, &QLineEdit::textChanged, this, &ShortcutsDialog::filter);
  connect(m_tree, &QTreeWidget::currentItemChanged, this, &ShortcutsDialog::showSelected);
  connect(&m_shortcuts, &Shortcuts::changed, this, &ShortcutsDialog::refresh);
  m_tree->setCurrentItem(m_tree->topLevelItem(0));
}

void ShortcutsDialog::buildEditor() {
  auto* row = new QHBoxLayout();
  m_keys = new QKeySequenceEdit(this);
  m_keys->setObjectName(QStringLiteral("shortcuts.keys"));
  m_keys->setAccessibleName(tr("Keys"));
  for (auto* field : m_keys->findChildren<QLineEdit*>()) field->setAccessibleName(tr("Keys"));
  m_keys->setToolTip(tr("Press the new keys of the selected command"));
  const auto button = [&](const QString& label, const QString& name, const QString& help) {
    auto* made = new QPushButton(label, this);
    made->setObjectName(QStringLiteral("shortcuts.") + name);
    made->setToolTip(help);
    made->setAutoDefault(false);
    return made;
  };
  m_clear = button(tr("&Clear"), QStringLiteral("clear"), tr("The selected command has no keys"));
  m_reset = button(tr("&Reset"), QStringLiteral("reset"), tr("The keys it came with"));
  m_resetAll = button(tr("Reset &all"), QStringLiteral("resetAll"), tr("Every command has the keys it came with"));
  auto* close = button(tr("Close"), QStringLiteral("close"), tr("Changes are kept already"));
  row->addWidget(m_keys, 1);
  row->addWidget(m_clear);
  row->addWidget(m_reset);
  m_problem = new QLabel(this);
  m_problem->setObjectName(QStringLiteral("shortcuts.problem"));
  m_problem->setWordWrap(true);
  m_problem->setMinimumHeight(34);
  m_problem->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* foot = new QHBoxLayout();
  foot->addWidget(m_resetAll);
  foot->addStretch(1);
  foot->addWidget(close);
  auto* column = qobject_cast<QVBoxLayout*>(layout());
  column->addLayout(row);
  column->addWidget(m_problem);
  column->addLayout(foot);
  connect(m_keys, &QKeySequenceEdit::editingFinished, this, [this] {
    const Shortcuts::Entry* entry = selected();
    if (entry != nullptr && entry->action && m_keys->keySequence() != entry->action->shortcut())
      apply(m_shortcuts.set(*entry, m_keys->keySequence()));
  });
  connect(m_clear, &QPushButton::clicked, this, [this] {
    if (const Shortcuts::Entry* entry = selected()) apply(m_shortcuts.set(*entry, {}));
  });
  connect(m_reset, &QPushButton::clicked, this, [this] {
    if (const Shortcuts::Entry* entry = selected()) apply(m_shortcuts.reset(*entry));
  });
  connect(m_resetAll, &QPushButton::clicked, this, [this] {
    m_shortcuts.resetAll();
    apply({});
  });
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
}

const Shortcuts::Entry* ShortcutsDialog::selected() const {
  const QTreeWidgetItem* item = m_tree->currentItem();
  return item != nullptr ? &m_shortcuts.entries()[item->data(0, kIndexRole).toInt()] : nullptr;
}

void ShortcutsDialog::fill() {
  for (int i = 0; i < m_shortcuts.entries().size(); ++i) {
    const Shortcuts::Entry& entry = m_shortcuts.entries()[i];
    auto* item = new QTreeWidgetItem(m_tree, {entry.label, entry.menu});
    item->setData(0, kIndexRole, i);
  }
  refresh();
}

void ShortcutsDialog::refresh() {
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = m_tree->topLevelItem(i);
    const Shortcuts::Entry& entry = m_shortcuts.entries()[item->data(0, kIndexRole).toInt()];
    if (!entry.action) continue;
    item->setText(2, QKeySequence::listToString(entry.action->shortcuts(), QKeySequence::NativeText));
    QFont font = m_tree->font();
    font.setBold(m_shortcuts.isChanged(entry));
    item->setFont(2, font);
  }
}

void ShortcutsDialog::filter() {
  const QString words = m_search->text().simplified();
  for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = m_tree->topLevelItem(i);
    bool found = false;
    for (int column = 0; column < 3; ++column) found |= item->text(column).contains(words, Qt::CaseInsensitive);
    item->setHidden(!found);
  }
}

void ShortcutsDialog::showSelected() {
  const Shortcuts::Entry* entry = selected();
  m_keys->setKeySequence(entry != nullptr && entry->action ? entry->action->shortcut() : QKeySequence());
  m_problem->clear();
}

void ShortcutsDialog::apply(const QString& problem) {
  showSelected();
  m_problem->setText(problem);
  m_problem->setAccessibleName(problem);
}

}  // namespace dermis
