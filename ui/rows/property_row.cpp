#include "ui/rows/property_row.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <algorithm>

#include "core/material/value_json.h"
#include "core/material/values_text.h"
#include "ui/rows/modified_dot.h"
#include "ui/rows/number_text.h"
#include "ui/text.h"
#include "ui/theme/metrics.h"

namespace dermis {

PropertyRow::PropertyRow(const QString& group, const QString& label, const QString& id, ValueEditor* editor,
                         QWidget* parent)
    : QWidget(parent),
      m_path(group.isEmpty() ? label : group + QStringLiteral(" › ") + label),
      m_name(label),
      m_group(group),
      m_editor(editor) {
  setObjectName(id);
  setAccessibleName(m_path);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(0);
  grid->setVerticalSpacing(2);
  m_dot = new ModifiedDot(this);
  m_dot->installEventFilter(this);
  m_label = new QLabel(label, this);
  m_label->setFixedHeight(metrics::kControlHeight);
  m_label->setBuddy(editor);
  m_label->installEventFilter(this);
  grid->addWidget(m_dot, 0, 0, Qt::AlignTop);
  grid->addWidget(m_label, 0, 1, Qt::AlignTop);
  editor->setParent(this);
  if (editor->wide()) {
    grid->addWidget(editor, 1, 1, 1, 2);
  } else {
    m_label->setFixedWidth(metrics::kLabelWidth);
    grid->addWidget(editor, 0, 2);
  }
  grid->setColumnStretch(2, 1);
  editor->nameControls(m_path, id);
  connect(editor, &ValueEditor::edited, this, &PropertyRow::edited);
}

void PropertyRow::showValue(const ParameterValue& value) {
  m_value = value;
  m_editor->showValue(value);
  refreshDot();
}

void PropertyRow::showDifferences(const QString& values) {
  if (values == m_differences) return;
  m_differences = values;
  m_editor->showMixed(!values.isEmpty());
  refreshDot();
}

void PropertyRow::setDefault(const ParameterValue& value) {
  m_default = value;
  m_editor->showDefault(value);
  refreshDot();
}

void PropertyRow::setPresetValue(const std::optional<ParameterValue>& value) {
  m_preset = value;
  refreshDot();
}

void PropertyRow::setHelp(const QString& sentence) {
  setToolTip(sentence);
  setWhatsThis(sentence);
  m_editor->setToolTip(sentence);
  m_editor->setWhatsThis(sentence);
  for (QWidget* control : m_editor->findChildren<QWidget*>()) control->setWhatsThis(sentence);
}

bool PropertyRow::isModified() const { return m_value && m_default && !(*m_value == *m_default); }

bool PropertyRow::differsFromPreset() const { return m_value && m_preset && !(*m_value == *m_preset); }

bool PropertyRow::matches(const QString& words) const {
  const QStringList parts = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  return std::all_of(parts.begin(), parts.end(), [this](const QString& part) {
    return m_path.contains(part, Qt::CaseInsensitive) || objectName().contains(part, Qt::CaseInsensitive);
  });
}

void PropertyRow::reset() {
  if (isModified() || (m_default && !m_differences.isEmpty())) Q_EMIT edited(*m_default, newGesture());
}

void PropertyRow::resetToPreset() {
  if (differsFromPreset()) Q_EMIT edited(*m_preset, newGesture());
}

void PropertyRow::refreshDot() {
  using State = ModifiedDot::State;
  m_dot->showState(!m_differences.isEmpty() ? State::Several
                   : differsFromPreset()    ? State::Changed
                   : isModified()           ? State::Differs
                                            : State::AsDefault);
  if (!m_differences.isEmpty()) m_dot->setToolTip(tr("The chosen slots have different values:\n%1").arg(m_differences));
}

// --- copy and paste ------------------------------------------------------------------------------------------------

/// A parameter's row with the texts that it only looks at.
struct PropertyRow::Description {
  ParameterRow row;
  std::string id, group, label, unit;
  std::vector<std::string> words;
  std::vector<std::string_view> wordViews;
};

void PropertyRow::describe(Description& d) const {
  if (m_parameter != nullptr) {
    d.row = *m_parameter;
  } else {
    d.row.type = static_cast<ParameterType>(m_value->index());
    if (const std::optional<NumberRange> range = m_editor->range()) {
      d.unit = range->unit.toStdString();
      d.row.unit = d.unit;
      d.row.hardMin = static_cast<float>(range->hardMin);
      d.row.hardMax = static_cast<float>(range->hardMax);
    }
    for (const QString& word : m_editor->words()) d.words.push_back(word.toStdString());
    d.wordViews.assign(d.words.begin(), d.words.end());
    d.row.words = d.wordViews;
  }
  d.id = objectName().toStdString();
  d.group = m_group.toStdString();
  d.label = m_name.toStdString();
  d.row.id = d.id;
  d.row.group = d.group;
  d.row.label = d.label;
}

void PropertyRow::copy() const {
  if (!m_value) return;
  Description d;
  describe(d);
  QApplication::clipboard()->setText(text(writeValues({{&d.row, *m_value}})));
}

Result<ParameterValue> PropertyRow::clipboardValue() const {
  Description d;
  describe(d);
  const QString clipboard = QApplication::clipboard()->text();
  std::optional<double> number;
  if (d.row.type == ParameterType::Float) number = parseNumber(clipboard, text(d.row.unit));
  const Result<ParameterValue> value = number ? Result<ParameterValue>(ParameterValue(static_cast<float>(*number)))
                                              : readValueFor(d.row, clipboard.toStdString());
  if (!value) return value;
  return clampToHardRange(d.row, *value);
}

void PropertyRow::paste() {
  if (!m_value) return;
  if (const Result<ParameterValue> value = clipboardValue())
    Q_EMIT edited(*value, newGesture());
  else
    Q_EMIT problem(text(value.error().message));
}

void PropertyRow::fillMenu(QMenu& menu) {
  const auto add = [&](const QString& words, const char* id, bool enabled, const QKeySequence& keys, auto slot) {
    QAction* action = menu.addAction(words);
    action->setObjectName(QLatin1String(id));
    action->setEnabled(enabled);
    action->setShortcut(keys);
    action->setShortcutVisibleInContextMenu(true);
    connect(action, &QAction::triggered, this, slot);
  };
  const auto words = [this](const std::optional<ParameterValue>& value) {
    const bool known = m_parameter != nullptr && value && m_parameter->type != ParameterType::Gaussians;
    return known ? QStringLiteral(" (%1)").arg(text(parameterToText(*m_parameter, *value))) : QString();
  };
  add(tr("Reset to the default%1").arg(words(m_default)), "row.reset",
      isModified() || (m_default && !m_differences.isEmpty()), QKeySequence(Qt::Key_Delete), &PropertyRow::reset);
  if (m_preset)
    add(tr("Back to the preset%1").arg(words(m_preset)), "row.resetToPreset", differsFromPreset(), {},
        &PropertyRow::resetToPreset);
  menu.addSeparator();
  add(tr("Copy value"), "row.copy", m_value.has_value(), QKeySequence::Copy, &PropertyRow::copy);
  add(tr("Paste value"), "row.paste", m_value && !QApplication::clipboard()->text().isEmpty(), QKeySequence::Paste,
      &PropertyRow::paste);
  if (actions().isEmpty()) return;
  menu.addSeparator();
  menu.addActions(actions());
}

bool PropertyRow::event(QEvent* event) {
  // The window's own shortcuts wait while a row has the focus and these keys mean its value.
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Copy) || key->matches(QKeySequence::Paste) || key->key() == Qt::Key_Delete) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void PropertyRow::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy))
    copy();
  else if (event->matches(QKeySequence::Paste))
    paste();
  else if (event->key() == Qt::Key_Delete)
    reset();
  else
    QWidget::keyPressEvent(event);
}

bool PropertyRow::eventFilter(QObject* watched, QEvent* event) {
  if ((watched == m_label || watched == m_dot) && event->type() == QEvent::MouseButtonDblClick) {
    reset();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void PropertyRow::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("row.menu"));
  fillMenu(menu);
  menu.exec(event->globalPos());
}

}  // namespace dermis
