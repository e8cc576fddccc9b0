#include "ui/rows/choice_editors.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QStyleOptionComboBox>
#include <QWheelEvent>
#include <algorithm>

namespace dermis {

QuietComboBox::QuietComboBox(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMaxVisibleItems(20);
}

QSize QuietComboBox::sizeHint() const {
  // QComboBox has a policy that gives this size, AdjustToMinimumContentsLengthWithIcon, but setting it makes the list
  // that drops down, of each box when the window is made.
  constexpr int kCharacters = 6, kBesideIcon = 4, kAround = 2;
  QStyleOptionComboBox option;
  initStyleOption(&option);
  const QFontMetrics metrics = fontMetrics();
  const QSize content(kCharacters * metrics.horizontalAdvance(QLatin1Char('X')) + iconSize().width() + kBesideIcon,
                      std::max(metrics.height(), iconSize().height()) + kAround);
  return style()->sizeFromContents(QStyle::CT_ComboBox, &option, content, this);
}

void QuietComboBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QComboBox::wheelEvent(event);
  else
    event->ignore();
}

ChoiceEditor::ChoiceEditor(const QStringList& words, QWidget* parent) : ValueEditor(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  m_box = new QuietComboBox(this);
  m_box->addItems(words);
  m_box->setPlaceholderText(QStringLiteral("—"));
  row->addWidget(m_box, 1);
  setFocusProxy(m_box);
  connect(m_box, &QComboBox::activated, this,
          [this](int index) { Q_EMIT edited(ParameterValue(EnumValue{index}), newGesture()); });
}

void ChoiceEditor::showValue(const ParameterValue& value) {
  m_index = std::get<EnumValue>(value).index;
  refresh();
}

void ChoiceEditor::showMixed(bool mixed) {
  m_mixed = mixed;
  refresh();
}

void ChoiceEditor::refresh() {
  const QSignalBlocker blocker(m_box);
  m_box->setCurrentIndex(m_mixed ? -1 : m_index);
}

QStringList ChoiceEditor::words() const {
  QStringList words;
  for (int i = 0; i < m_box->count(); ++i) words << m_box->itemText(i);
  return words;
}

void ChoiceEditor::nameControls(const QString& path, const QString& id) {
  m_box->setAccessibleName(path);
  m_box->setObjectName(id + QStringLiteral(".choice"));
}

SwitchEditor::SwitchEditor(QWidget* parent) : ValueEditor(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  m_box = new QCheckBox(this);
  row->addWidget(m_box);
  row->addStretch(1);
  setFocusProxy(m_box);
  connect(m_box, &QCheckBox::clicked, this,
          [this] { Q_EMIT edited(ParameterValue(m_box->checkState() != Qt::Unchecked), newGesture()); });
}

void SwitchEditor::showValue(const ParameterValue& value) {
  m_on = std::get<bool>(value);
  refresh();
}

void SwitchEditor::showMixed(bool mixed) {
  m_mixed = mixed;
  refresh();
}

void SwitchEditor::refresh() {
  const QSignalBlocker blocker(m_box);
  m_box->setTristate(m_mixed);
  m_box->setCheckState(m_mixed ? Qt::PartiallyChecked : m_on ? Qt::Checked : Qt::Unchecked);
}

void SwitchEditor::nameControls(const QString& path, const QString& id) {
  m_box->setAccessibleName(path);
  m_box->setObjectName(id + QStringLiteral(".switch"));
}

}  // namespace dermis
